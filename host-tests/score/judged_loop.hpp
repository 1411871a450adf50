// A loop whose valve is known, and what was found of it: what score_rules writes and
// judge_again reads, on one machine, of one build.
#pragma once

#include <type_traits>

#include "ident/verdict/identification.hpp"

namespace workbench::test {

struct JudgedLoop {
  bool simulated = true;  // else under a load cut from a recording
  bool sticks = false;    // or has play
  ident::Identification<double> found;
};
static_assert(std::is_trivially_copyable_v<JudgedLoop>);

}  // namespace workbench::test
