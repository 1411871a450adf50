#include <gtest/gtest.h>

#include <string_view>

#include "hal/candump_tail.hpp"
#include "wire/candump.hpp"

namespace hal {
namespace {

TEST(CandumpTail, IsCutWhereverALineEnds) {
  for (const std::string_view line : {"(1700000125.000000) can0 18DAF110#551201",
                                      "(1700000125.000000) can0 18F##1001122",
                                      " (1700000125.500000)  can0  18E   [2]  33 44"}) {
    for (std::size_t length = 2; length < line.size(); ++length) {
      wire::CandumpLine parsed;
      const std::string_view part = line.substr(0, length);
      const wire::CandumpStatus status = wire::parse_candump(part, parsed);
      if (!status.ok()) EXPECT_TRUE(is_cut_short(part, status.column)) << part;
    }
  }
}

TEST(CandumpTail, IsBrokenWhereMoreFollowsOrNothingBegins) {
  for (const std::string_view line : {"t;u;y", "(1700000125.000000)", ""}) {
    EXPECT_FALSE(is_cut_short(line, 1)) << line;
  }
  constexpr std::string_view kBroken = "(1700000125.000000) can0 18Z#5512010000";
  wire::CandumpLine parsed;
  const wire::CandumpStatus status = wire::parse_candump(kBroken, parsed);
  ASSERT_FALSE(status.ok());
  EXPECT_FALSE(is_cut_short(kBroken, status.column));
}

}  // namespace
}  // namespace hal
