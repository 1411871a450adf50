// Several recordings that are not of one loop, or of one time.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/base/one_loop.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

Recording recording(const char* name, const char* start = "", std::uint64_t seed = 1) {
  test::SetpointLoop loop;
  loop.samples = 100;
  loop.seed = seed;
  Recording out = test::simulated(loop);
  out.name = name;
  out.start = start;
  return out;
}

Recording of_loop(const char* name, const char* loop, const char* tags) {
  Recording out = recording(name);
  out.loop = loop;
  out.tags = tags;
  return out;
}

TEST(OneLoop, HasOneUnitForEachSignal) {
  Recording percent = recording("percent.csv");
  percent.units[static_cast<std::size_t>(Column::y)] = "%";
  Recording litres = recording("litres.csv");
  EXPECT_NO_THROW(check_one_loop({percent, litres}));
  litres.units[static_cast<std::size_t>(Column::y)] = "l/s";
  EXPECT_THROW(check_one_loop({percent, litres}), InputError);
}

TEST(OneLoop, HasOneInstrument) {
  const Recording flow = of_loop("a.csv", "f101", "u FIC101.OP, y FIC101.PV");
  const Recording other = of_loop("b.csv", "t205", "u TIC205.OP, y TIC205.PV");
  try {
    check_one_loop({flow, recording("c.csv"), other});
    FAIL() << "taken together";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "b.csv: expected the loop of a.csv: u FIC101.OP, y FIC101.PV, found u "
                 "TIC205.OP, y TIC205.PV; give each loop by itself; where both are one, "
                 "name the columns with --u and --y");
  }
  EXPECT_NO_THROW(check_one_loop({flow, of_loop("d.csv", "area1f101", "")}));
}

TEST(Overlaps, AreNamedWithTheirLength) {
  const Recording first = recording("a.csv", "2026-03-17T08:15:00");
  const Recording second = recording("b.csv", "2026-03-17T08:16:00", 2);
  const auto said = overlaps_of({first, second});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(
      said[0],
      "a.csv and b.csv overlap in time by 40 s: what both hold counts twice; export "
      "each time once");
}

TEST(Overlaps, NothingIsSaidOfOthers) {
  const Recording first = recording("a.csv", "2026-03-17T08:15:00");
  for (const char* start :
       {"", "2026-03-17T08:16:40", "2026-03-18T08:15:00", "2026-03-17T08:16:00Z"}) {
    EXPECT_TRUE(overlaps_of({first, recording("b.csv", start, 2)}).empty()) << start;
  }
  EXPECT_TRUE(overlaps_of({first, first}).empty());
}

}  // namespace
}  // namespace workbench
