// What an identification has to say.
#pragma once

#include <gtest/gtest.h>

#include "ident/verdict/identification.hpp"

namespace test {

/// That the result gives this reason, and the verdict that goes with it.
inline void expect_verdict(const ident::Identification<double>& result,
                           ident::Reason reason) {
  EXPECT_EQ(name(result.verdict), name(ident::verdict_of(reason)));
  EXPECT_EQ(sentence(result.reason), sentence(reason));
}

}  // namespace test
