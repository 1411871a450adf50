#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/later_texts.hpp"

namespace workbench {
namespace {

constexpr const char* kHead = ",result,table,_time,_value,_field,_measurement,point\n";

// More rows than the first ones that a layout is told from.
std::string table(int number, const std::string& texts, double offset) {
  std::string out;
  for (int k = 0; k < 200; ++k) {
    const std::string s = std::to_string(k % 60);
    out += ",_result," + std::to_string(number) + ",2026-05-13T14:3" +
           std::to_string(k / 60) + ':' + (s.size() < 2 ? "0" : "") + s + "Z," +
           std::to_string(offset + k * 7 % 5) + ',' + texts + '\n';
  }
  return out;
}

std::vector<std::size_t> keys_of(const std::string& text) {
  const CsvLayout layout = layout_of(text, "a.csv", {});
  FluxTables tables(layout);
  std::istringstream rows(text.substr(layout.first_row_offset));
  for (std::string row; tables.are_there() && std::getline(rows, row);) {
    tables.add(split_line(row, ','));
  }
  return tables.keys();
}

TEST(FluxTables, AreToldApartByTheFewestTexts) {
  using Keys = std::vector<std::size_t>;
  EXPECT_EQ(keys_of(kHead + table(0, "value,plant,FIC101.OP", 40) +
                    table(1, "value,plant,FIC101.PV", 60)),
            Keys{7});
  EXPECT_EQ(keys_of(kHead + table(0, "op,%,FIC101", 40) + table(1, "pv,bar,FIC101", 60)),
            Keys{5});
  EXPECT_EQ(keys_of(kHead + table(0, "value,plant,a", 40)), Keys{});
  EXPECT_EQ(keys_of("result,time,point,OP\nx,1,a,2\nx,2,a,3\n"), Keys{});
}

TEST(FluxTables, ThatFollowEachOtherAreReadHoweverLongATextRests) {
  for (const char* between :
       {"", "\n,result,table,_time,_value,_field,_measurement,point\n"}) {
    const Recording r = parse_csv(kHead + table(0, "value,plant,FIC101.OP", 40) +
                                      between + table(1, "value,plant,FIC101.PV", 60),
                                  "a.csv");
    EXPECT_EQ(r.size(), 200U);
    EXPECT_EQ(r.u[1], 42);
    EXPECT_EQ(r.y[1], 62);
  }
}

TEST(FluxTables, OfSeveralLoopsAskForOne) {
  const auto pivoted = [](int number, const std::string& loop, double offset) {
    std::string out = table(number, "9," + loop, offset);
    return out;
  };
  const std::string text = ",result,table,_time,op,pv,area\n" + pivoted(0, "FIC101", 40) +
                           pivoted(1, "FIC102", 60);
  EXPECT_THROW((void)parse_csv(text, "a.csv"), InputError);
  CsvOptions options;
  options.names.u = "FIC102.op";
  options.names.y = "FIC102.pv";
  EXPECT_EQ(parse_csv(text, "a.csv", options).u[1], 62);
}

}  // namespace
}  // namespace workbench
