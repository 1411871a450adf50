#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/tag_file.hpp"

namespace workbench {
namespace {

std::string rows(double offset) {
  std::string out;
  for (int k = 0; k < 20; ++k) {
    out += "2026-03-04 00:00:" + std::string(k < 10 ? "0" : "") + std::to_string(k) +
           ',' + std::to_string(offset + (k * 7 % 5)) + '\n';
  }
  return out;
}

std::string tag_in(const std::string& text, const std::string& path) {
  const auto one = tag_file(text, path, CsvOptions{});
  return one ? one->tag : "none";
}

class TagFileTest : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name), std::ios::binary) << text;
    texts_.push_back({folder_.file(name), text});
    return folder_.file(name);
  }
  [[nodiscard]] Recording together() const {
    return parse_csv(table_of_tag_files(texts_, {}), "both");
  }

 private:
  TemporaryFolder folder_;
  std::vector<NamedBytes> texts_;
};

TEST_F(TagFileTest, ItsTagIsThatOfTheColumnOrOfTheFile) {
  EXPECT_EQ(tag_in("Time,Value\n" + rows(40), "x/FIC101.OP.csv"), "FIC101.OP");
  EXPECT_EQ(tag_in("Time,Value [%]\n" + rows(40), "FIC101.OP_2026-03.csv"),
            "FIC101.OP [%]");
  EXPECT_EQ(tag_in("Time,FIC101.PV\n" + rows(40), "trend.csv"), "FIC101.PV");
  EXPECT_EQ(tag_in("Time,FIC101\n" + rows(40), "FIC101_OP.csv"), "FIC101_OP");
  EXPECT_EQ(tag_in(rows(40), "FIC101.OP.csv"), "FIC101.OP");
}

TEST_F(TagFileTest, ALongFormatOfOneTagIsOne) {
  std::string text = "Tag,Time,Value,Quality\n";
  for (int k = 10; k < 40; ++k) {
    text += "LIC7.PV,2026-03-04 00:00:" + std::to_string(k) + ',' +
            std::to_string(k * 3 % 7) + ",Good\n";
  }
  EXPECT_EQ(tag_in(text, "a.csv"), "LIC7.PV");
}

TEST_F(TagFileTest, TwoSignalsOrNoneAreNot) {
  EXPECT_EQ(tag_in("t,u,y\n0,1,2\n1,3,4\n2,3,3\n", "a.csv"), "none");
  EXPECT_EQ(tag_in("this is no table\n", "a.csv"), "none");
  EXPECT_FALSE(are_tag_files({file("a.csv", "Time,Value\n" + rows(1))}, {}));
  EXPECT_FALSE(are_tag_files({file("a.csv", "Time,Value\n" + rows(1)), "/none"}, {}));
}

TEST_F(TagFileTest, TogetherTheyAreARecording) {
  const std::vector<std::string> paths = {
      file("FIC101.OP.csv", "Time,Value\n" + rows(40)),
      file("FIC101.PV.csv", "Time,Value\n" + rows(5) + "(20 rows)\n")};
  ASSERT_TRUE(are_tag_files(paths, {}));
  const Recording r = together();
  ASSERT_EQ(r.size(), 20U);
  EXPECT_EQ(r.u.front(), 40);
  EXPECT_EQ(r.y.front(), 5);
  EXPECT_EQ(r.period_s, 1);
}

TEST_F(TagFileTest, OfTwoHistoriansTheyGoTogetherToo) {
  std::string other = "Zeitstempel;FIC101.PV [m3/h]\n";
  for (int k = 10; k < 30; ++k) {
    other +=
        "04.03.2026 00:00:" + std::to_string(k) + ';' + std::to_string(k % 3) + ",5\n";
  }
  const std::vector<std::string> paths = {
      file("a.csv",
           "Zeitstempel;FIC101.OP\n04.03.2026 00:00:10;1,5\n"
           "04.03.2026 00:00:20;2,5\n04.03.2026 00:00:29;1,5\n"),
      file("b.csv", other)};
  ASSERT_TRUE(are_tag_files(paths, {}));
  const Recording r = together();
  EXPECT_EQ(r.unit(Column::y), "m3/h");
  EXPECT_EQ(r.u.front(), 1.5);
}

TEST(TagFile, TheNamesOfFilesAreOneWordAndBack) {
  const std::vector<std::string> names = {"FIC101.OP.csv", "FIC101.PV.csv"};
  EXPECT_EQ(name_of_files(names), "FIC101.OP.csv + FIC101.PV.csv");
  EXPECT_EQ(files_in(name_of_files(names)), names);
  EXPECT_EQ(files_in("a.csv"), std::vector<std::string>{"a.csv"});
  EXPECT_EQ(files_in("a + b.csv"), std::vector<std::string>{"a + b.csv"});
}

TEST(UndatedName, DatesAndRunningNumbersGo) {
  EXPECT_EQ(undated_name("x/FIC-101.csv"), "FIC-101");
  EXPECT_EQ(undated_name("FIC-101-2.csv"), "FIC-101");
  EXPECT_EQ(undated_name("FIC-101_2024-03.csv"), "FIC-101");
  EXPECT_EQ(undated_name("FIC-101_20240301.csv"), "FIC-101");
  EXPECT_EQ(undated_name("FIC-101_2024-03-01_120000.csv"), "FIC-101");
  EXPECT_EQ(undated_name("UNIT1-FIC-101.csv"), "UNIT1-FIC-101");
  EXPECT_EQ(undated_name("CHEM10.csv"), "CHEM10");
}

TEST_F(TagFileTest, MayHaveTheirTimesInParts) {
  const auto parts = [](int offset) {
    std::string out;
    for (int k = 10; k < 40; ++k) {
      out += "2026,5,13,14,30," + std::to_string(k) + ',' +
             std::to_string(offset + k * 3 % 7) + '\n';
    }
    return out;
  };
  const std::string head = "Year,Month,Day,Hour,Minute,Second,Value\n";
  file("FIC101.OP.csv", head + parts(40));
  file("FIC101.PV.csv", head + parts(60));
  const Recording both = together();
  EXPECT_EQ(both.size(), 30U);
  EXPECT_EQ(both.start, "2026-05-13T14:30:10");
  EXPECT_EQ(both.u[1], 45);
  file("FIC101.SP.csv", "Time,Value\n" + rows(50));
  EXPECT_THROW((void)together(), InputError);
}

TEST_F(TagFileTest, OfZonesThatMayBeHoursApartAreRefused) {
  const auto in_zone = [](double offset, const std::string& zone) {
    std::string out = rows(offset);
    for (std::size_t at = 0; (at = out.find(',', at)) != std::string::npos;
         at += zone.size() + 2) {
      out.insert(at, ' ' + zone);
    }
    return out;
  };
  file("FIC101.OP.csv", "Time,Value\n" + in_zone(40, "CST"));
  file("FIC101.PV.csv", "Time,Value\n" + in_zone(60, "CST"));
  EXPECT_EQ(together().size(), 20U);
  file("FIC101.SP.csv", "Time,Value\n" + in_zone(50, "UTC"));
  try {
    (void)together();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.found, "CST (-06:00 or +08:00) beside +00:00");
  }
}

TEST(TagFile, ASignalThatNobodyReadsIsOneToo) {
  std::string text = "Time,FIC101.OP,FIC101.PV\n";
  for (int i = 0; i < 20; ++i) {
    text += std::to_string(i) + ',' + std::to_string(i % 7) + ",(4." +
            std::to_string(i % 5) + ")\n";
  }
  EXPECT_EQ(tag_in(text, "a.csv"), "none");
}

TEST(TagFile, ATagThatFollowsBehindTheFirstRowsIsAnotherOne) {
  const auto tagged = [](const std::string& tag) {
    std::string out;
    for (int i = 0; i < 200; ++i) {
      out += tag + ',' + std::to_string(i * 10) + ',' + std::to_string(i % 7) + '\n';
    }
    return out;
  };
  const std::string head = "Tag,Time,Value\n";
  EXPECT_EQ(tag_in(head + tagged("FIC101.OP"), "a.csv"), "FIC101.OP");
  EXPECT_EQ(tag_in(head + tagged("FIC101.OP") + tagged("FIC101.PV"), "a.csv"), "none");
  EXPECT_EQ(tag_in(tagged("FIC101.OP") + tagged("FIC101.PV"), "a.csv"), "none");
}

}  // namespace
}  // namespace workbench
