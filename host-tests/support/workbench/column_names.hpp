// Columns as a user names them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/signal_choice.hpp"

namespace workbench::test {

inline ColumnNames named(const std::string& u, const std::string& y = "",
                         std::vector<std::string> loads = {}) {
  ColumnNames names;
  names.u = u;
  names.y = y;
  names.loads = std::move(loads);
  return names;
}

}  // namespace workbench::test
