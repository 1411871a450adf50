// Times in sentences as on the axes.
#include <gtest/gtest.h>

#include "workbench/serve/axis_times.hpp"

namespace workbench {
namespace {

Recording lasting(double seconds, const char* start = "") {
  Recording out;
  out.t = {0, seconds};
  out.start = start;
  return out;
}

TEST(ServeAxisTimes, AreInTheUnitOfTheAxis) {
  const std::string late = "<p>At t = 1.512e+05 s the output shifts.</p>";
  EXPECT_EQ(with_axis_times(late, lasting(3e5)), "<p>At t = 42 h the output shifts.</p>");
  EXPECT_EQ(with_axis_times(late, lasting(1e6)),
            "<p>At t = 1.75 d the output shifts.</p>");
  EXPECT_EQ(with_axis_times("from t = 90 s to 120 s, it", lasting(7200)),
            "from t = 1.5 min to 2 min, it");
  EXPECT_EQ(with_axis_times("t = 90 s", lasting(500)), "t = 90 s");
  EXPECT_EQ(with_axis_times("lies in t between 437.2 and 1124 s", lasting(3600)),
            "lies in t between 7.287 min and 18.73 min");
}

TEST(ServeAxisTimes, AreClockTimesWhereTheRecordingHasThem) {
  EXPECT_EQ(with_axis_times("At t = 90 s it", lasting(7200, "2026-03-04T08:00:00+01:00")),
            "At t = 08:01:30 it");
  EXPECT_EQ(with_axis_times("At t = 1.512e+05 s it", lasting(3e5, "2026-02-28T23:00:00")),
            "At t = 2026-03-02 17:00 it");
}

TEST(ServeAxisTimes, LeaveOtherTextsAlone) {
  for (const char* text :
       {"t = 12 of 20", "t between 5 and more", "t between", "a lag of 1.5e+04 s",
        "t = ", "t = 5 sets", "<code>t = 5000 s</code>", "<p title=\"t = 5000 s\">"}) {
    EXPECT_EQ(with_axis_times(text, lasting(3e5)), text);
  }
}

}  // namespace
}  // namespace workbench
