#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/time_parts.hpp"

namespace workbench {
namespace {

using Indices = std::vector<std::size_t>;

// Ten rows that begin with the time given, a second apart.
std::string rows(const std::string& date, int hour, int minute, int second) {
  std::string out;
  for (int k = 0; k < 10; ++k) {
    const int s = hour * 3600 + minute * 60 + second + k;
    out += date + std::to_string(s / 3600 % 24) + ',' + std::to_string(s / 60 % 60) +
           ',' + std::to_string(s % 60) + ".5,4" + std::to_string(k * k % 7) + ".5,6" +
           std::to_string(k % 4) + ".5\n";
  }
  return out;
}

Indices parts_of(const std::string& text) {
  return time_parts(layout_of(text, "a.csv", {{Column::u, Column::y}, {}}));
}

TEST(TimeParts, AreColumnsSideBySideInManyLanguages) {
  const std::string clock = rows("", 14, 30, 0);
  for (const char* head :
       {"Hour,Minute,Second,OP,PV", "HH,MM,SS,OP,PV", "Stunde,Minute,Sekunde,OP,PV",
        "heure,minute,seconde,OP,PV", "时,分,秒,OP,PV"}) {
    EXPECT_EQ(parts_of(std::string(head) + '\n' + clock), (Indices{0, 1, 2})) << head;
  }
  EXPECT_EQ(parts_of("Hour,Minute,Seconds elapsed,OP,PV\n" + clock), (Indices{0, 1}));
  EXPECT_EQ(parts_of("Minute,Hour,Second,OP,PV\n" + clock), Indices{});
}

TEST(TimeParts, NeedNoSecond) {
  const std::string minutes = "14,30,45.5,60.5\n14,31,46.5,61.5\n14,32,44.5,60.5\n";
  EXPECT_EQ(parts_of("Hour,Minute,OP,PV\n" + minutes), (Indices{0, 1}));
  EXPECT_EQ(parts_of("Stunde,Minute,OP,PV\n" + minutes), (Indices{0, 1}));
  EXPECT_EQ(parts_of("Std,Min,OP,PV\n" + minutes), Indices{});
  EXPECT_EQ(parts_of("h,m,OP,PV\n" + minutes), Indices{});
  EXPECT_EQ(parts_of("Hour,Min,Max,OP,PV\n14,30,45,45.5,60.5\n15,31,46,46.5,61.5\n"),
            Indices{});
  EXPECT_EQ(parts_of("Hours,Min,OP,PV\n1400.5,30,45.5,60.5\n1400.5,31,46.5,61.5\n"),
            Indices{});
  EXPECT_EQ(parts_of("Hour,Min,OP,PV\n14,-3,45.5,60.5\n14,-2,46.5,61.5\n"), Indices{});
  EXPECT_EQ(parts_of("Day,Month,Year,Hour,Minute,OP,PV\n13,5,2026,14,30,45.5,60.5\n"
                     "13,5,2026,14,31,45.5,60.5\n"),
            (Indices{2, 1, 0, 3, 4}));
  EXPECT_EQ(parts_of("Hour,Minute,OP,PV,Second\n14,30,45.5,60.5,10\n"
                     "14,30,46.5,61.5,20\n"),
            (Indices{0, 1, 4}));
}

TEST(TimeParts, TakeTheDateInAnyOrder) {
  EXPECT_EQ(parts_of("Year,Month,Day,Hour,Minute,Second,OP,PV\n" +
                     rows("2026,5,13,", 14, 30, 0)),
            (Indices{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(parts_of("DD,MM,YYYY,HH,MM,SS,OP,PV\n" + rows("13,5,2026,", 14, 30, 0)),
            (Indices{2, 1, 0, 3, 4, 5}));
  EXPECT_EQ(parts_of("Month,Day,Year,HH,MM,SS,OP,PV\n" + rows("5,13,26,", 14, 30, 0)),
            (Indices{2, 0, 1, 3, 4, 5}));
}

TEST(TimeParts, OfADatevecNeedNoNames) {
  const std::string six = rows("2026,5,13,", 14, 30, 0);
  EXPECT_EQ(parts_of(six), (Indices{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(parts_of("t_1,t_2,t_3,t_4,t_5,t_6,OP,PV\n" + six),
            (Indices{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(parts_of("a,b,c,d,e,f,OP,PV\n" + six), Indices{});
  EXPECT_EQ(parts_of(rows("2026,13,13,", 14, 30, 0)), Indices{});
  EXPECT_EQ(parts_of(rows("0,5,13,", 14, 30, 0)), Indices{});
}

TEST(TimeParts, AreWrittenAsOneTime) {
  const auto text = [](const std::vector<double>& parts) {
    return time_of_parts(parts).value_or("none");
  };
  EXPECT_EQ(text({14, 3, 7.25}), "14:03:07.2500000");
  EXPECT_EQ(text({100, 5, 0}), "100:05:00.0000000");
  EXPECT_EQ(text({14, 3}), "14:03:00.0000000");
  EXPECT_EQ(text({14, 3.25}), "14:03:15.0000000");
  EXPECT_EQ(text({26, 5, 3, 14, 30}), "2026-05-03 14:30:00.0000000");
  EXPECT_EQ(text({26, 5, 3, 14, 30, 59.99999999}), "2026-05-03 14:30:59.9999999");
  for (const std::vector<double>& wrong : {std::vector<double>{14, 60, 0},
                                           {14, 3, 60},
                                           {14, 60},
                                           {14.5, 3},
                                           {2026, 5, 3, 24, 30},
                                           {14.5, 0, 0},
                                           {-1, 0, 0},
                                           {2026, 13, 3, 14, 30, 0},
                                           {2026, 5, 0, 14, 30, 0},
                                           {2026, 5, 3, 24, 30, 0},
                                           {150, 5, 3, 14, 30, 0}}) {
    EXPECT_EQ(text(wrong), "none");
  }
}

TEST(TimeParts, OpenAsRowsOfOneClock) {
  const Recording night = parse_csv(
      "Date,Hour,Minute,Second,OP,PV\n" + rows("2026-05-13,", 23, 59, 50), "a.csv");
  EXPECT_EQ(night.start, "2026-05-13T23:59:50.500");
  EXPECT_EQ(night.period_s, 1);
  const Recording full = parse_csv(
      "Day,Month,Year,Hour,Minute,Second,OP,PV\n" + rows("13,5,2026,", 14, 30, 0),
      "a.csv");
  EXPECT_EQ(full.start, "2026-05-13T14:30:00.500");
  EXPECT_EQ(full.t, night.t);
}

TEST(TimeParts, HourAndMinuteOpenAsMinutes) {
  std::string dated = "Date,Hour,Minute,OP,PV\n";
  std::string alone = "Hour,Minute,OP,PV\n";
  std::string full = "Year,Month,Day,Hour,Minute,OP,PV\n";
  std::string faster = dated;
  for (int k = 0; k < 90; ++k) {
    const std::string values =
        ",4" + std::to_string(k * k % 7) + ".5,6" + std::to_string(k % 4) + ".5\n";
    const auto clock = [](int minute) {
      return std::to_string(minute / 60 % 24) + ',' + std::to_string(minute % 60);
    };
    const int day = k < 30 ? 13 : 14;
    const std::string at = clock(23 * 60 + 30 + k);
    dated += "2026-05-" + std::to_string(day) + ',' + at + values;
    full += "2026,5," + std::to_string(day) + ',' + at + values;
    alone += at + values;
    faster += "2026-05-13," + clock(14 * 60 + k / 6) + values;
  }
  for (const std::string& text : {dated, full}) {
    const Recording r = parse_csv(text, "a.csv");
    EXPECT_EQ(r.start, "2026-05-13T23:30:00");
    EXPECT_EQ(r.period_s, 60);
    EXPECT_EQ(r.size(), 90U);
  }
  EXPECT_EQ(parse_csv(alone, "a.csv").period_s, 60);
  const Recording cut = parse_csv(faster, "a.csv");
  EXPECT_EQ(cut.size(), 90U);
  EXPECT_EQ(cut.period_s, 10);
}

TEST(TimeParts, OutOfRangeAreRefusedWithTheirRow) {
  std::string text = "Hour,Minute,Second,OP,PV\n" + rows("", 14, 30, 0);
  text.replace(text.find("14,30,5.5"), 9, "14,75,5.5");
  try {
    (void)parse_csv(text, "a.csv");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.line, 7U);
    EXPECT_NE(error.expected.find("'Hour Minute Second'"), std::string::npos)
        << error.expected;
    EXPECT_EQ(error.found, "'14 75 5.5'");
  }
}

}  // namespace
}  // namespace workbench
