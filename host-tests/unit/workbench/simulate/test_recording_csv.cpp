#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "support/workbench/tiny_loop.hpp"
#include "workbench/simulate/recording_csv.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

TEST(SimulateCsv, WritesHeaderAndRows) {
  std::ostringstream out;
  write_csv(test::tiny_loop(), out);
  EXPECT_EQ(out.str(), "t,u,y,sp,x\n0,1,0.1,3,0\n0.5,-2.5,1e-07,3,0.3333333333333333\n");
  std::ostringstream without;
  write_csv(test::tiny_loop(), without, false);
  EXPECT_EQ(without.str(), "t,u,y,sp\n0,1,0.1,3\n0.5,-2.5,1e-07,3\n");
}

TEST(SimulateCsv, ReadsBackToTheSameValues) {
  const SimulatedLoop loop = *simulate("stiction", 4);
  std::stringstream file;
  write_csv(loop, file);
  std::string line;
  std::getline(file, line);
  for (std::size_t i = 0; i < loop.t.size(); ++i) {
    std::getline(file, line);
    std::vector<double> values;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');)
      values.push_back(std::stod(cell));
    ASSERT_EQ(values, (std::vector<double>{loop.t[i], loop.u[i], loop.y[i], loop.sp[i],
                                           loop.x[i]}));
  }
  EXPECT_FALSE(std::getline(file, line));
}

}  // namespace
}  // namespace workbench
