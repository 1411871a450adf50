// The exports in host-tests/exports open as they should, or are refused with advice.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"

namespace workbench {
namespace {

std::string path_of(const std::string& file) {
  return std::string(STICKBAND_EXPORTS) + '/' + file;
}

const Recording& truth() {
  static const Recording kTruth = read_csv(path_of("truth.csv"));
  return kTruth;
}

CsvOptions named(const std::string& u, const std::string& y) {
  CsvOptions options;
  options.names.u = u;
  options.names.y = y;
  return options;
}

CsvOptions ordered(DateOrder order) {
  CsvOptions options;
  options.date_order = order;
  return options;
}

CsvOptions sheet(const std::string& name) {
  CsvOptions options;
  options.sheet = name;
  return options;
}

struct Export {
  std::string file;
  std::string start = "2026-05-13T14:30:00";
  bool has_sp = false;
  bool lacks_y = false;   // samples 10 to 12: sample 9 is held
  std::string note = {};  // a part of one; "" : no notes at all
  CsvOptions options = {};
  double scale_y = 1;
  double period_s = 1;
};

void PrintTo(const Export& e, std::ostream* out) {
  *out << e.file;
}

const std::string kMarked = "cells without a value";

std::vector<Export> exports() {
  const std::string day = "2026-05-13T14:30:00";
  return {
      {"pi-datalink.csv", day, true},
      {"pi-datalink-german.csv", day, true},
      {"pi-bad-values.csv", day, false, true, kMarked},
      {"pi-archive-long.csv", day, false, false, "Pt Created"},
      {"pi-web-api-long.csv", day + "Z"},
      {"pi-compressed-pairs.csv", day},
      {"wonderware-wide.csv", day, false, true, kMarked},
      {"wonderware-history-long.csv", day, false, true, "80 rows affected"},
      {"wonderware-intouch.csv", day},
      {"deltav-continuous.csv", day, true},
      {"deltav-units.csv", day + "-04:00"},
      {"deltav-utf16.txt", day},
      {"deltav-several-loops.csv", day, false, false, "",
       named("fic101/pid1/out", "FIC-101/PID1/PV")},
      {"ignition-tag-history.csv", day, true},
      {"ignition-epoch-ms.csv", day + "Z"},
      {"ignition-java-dates.csv", day + "+02:00"},
      {"ignition-dataset.csv", day},
      {"siemens-wincc-archive.csv", day},
      {"siemens-wincc-trend.csv", day},
      {"siemens-pcs7.csv", day + ".250", true},
      {"siemens-step7.csv", day, true},
      {"yokogawa-centum.csv", day, true},
      {"yokogawa-recorder.csv", day + ".500"},
      {"honeywell-experion.csv", day, true},
      {"honeywell-phd-long.csv", day, false, true, kMarked},
      {"abb-800xa.txt", day + "+02:00", true},
      {"abb-freelance.csv", day, false, true, "ungültig"},
      {"aspen-ip21-wide.csv", day},
      {"aspen-sqlplus-long.txt", day + ".400", false, true, "one grid every 1 s"},
      {"aspen-process-explorer.csv", day, false, false, "newest row came first"},
      {"excel-german.csv", day, true},
      {"excel-us.csv", day, true},
      {"excel-serial.csv", day, false, false, "as Excel counts them"},
      {"excel-unicode-text.txt", day},
      {"excel-thousands.csv", day, false, false, "", {}, 100},
      {"excel-sep-line.csv", ""},
      {"excel-cut-seconds.csv", day, false, false, "cut to whole minutes", {}, 1, 15},
      {"minutes-seconds.csv", "", false, false, "the full hour 1 time"},
      {"elapsed-hours.csv", ""},
      {"pandas-timedelta.csv", ""},
      {"minutes-of-day.csv", "", false, false, "cut to whole minutes", {}, 1, 15},
      {"excel-ambiguous-date.csv", "2026-04-03T14:30:00", false, false, "",
       ordered(DateOrder::dmy)},
      {"excel-ambiguous-date.csv", "2026-03-04T14:30:00", false, false, "",
       ordered(DateOrder::mdy)},
      {"excel-ambiguous-date.csv", "", false, false, "3 April 2026 or 4 March 2026"},
      {"excel-two-digit-year.csv", "", false, false, "13 May 2026 or 26 May 2013"},
      {"excel-british-midnight.csv", "2026-04-03T23:59:50"},
      {"excel-two-digit-year.csv", day, false, false, "", ordered(DateOrder::dmy)},
      {"excel-merged-heads.csv", day, false, true, "bad quality"},
      {"minutes.csv", ""},
      {"seconds-with-units.csv", "", true},
      {"epoch-seconds.csv", day + "Z"},
      {"epoch-microseconds.csv", day + "Z"},
      {"iso-basic.csv", day + "Z"},
      {"bare-cr.csv", day},
      {"daylight-saving-end.csv", "2026-10-25T02:59:50", false, false, "an hour back"},
      {"daylight-saving-start.csv", "2026-03-29T01:59:50", false, false, "an hour ahead"},
      {"time-of-day.csv", "", false, false, "passes midnight 1 time"},
      {"repeated-stamp.csv", day, false, false, "repeats the time"},
      {"opc-quality.csv", day, false, true, "bad quality"},
      {"own-names.csv", day, false, false, "newest row came first",
       named("LV_106", "ft115")},
      {"quoted-decimal-commas.csv", day},
      {"code-for-no-value.csv", day, false, true, "a code for a missing value"},
      {"quality-french.csv", day, false, true, "bad quality"},
      {"nan-cells.csv", day, false, true, "#N/A"},
      {"grafana.csv", day},
      {"influx-annotated.csv", day + "Z"},
      {"labview.lvm", ""},
      {"labview-no-times.lvm", "", false, false, "header has 4 names"},
      {"twincat-scope.csv", ""},
      {"matlab-durations.csv", ""},
      {"blanks.dat", ""},
      {"french.csv", day, true},
      {"ge-ifix.csv", day},
      {"abb-three-decimals.csv", day},
      {"date-and-clock-digits.csv", "2026-05-13T23:59:50", false, false, "HHMMSS"},
      {"excel-day-and-fraction.csv", day, false, false, "fractions of a day"},
      {"rockwell-trend.csv", day + ".250"},
      {"workbook.xlsx", day, true},
      {"workbook-german.xlsx", day, false, true, "3 empty cells"},
      {"workbook-one-fits.xlsx", day, true, false,
       "sheet 'Data' taken of 'Alarms', 'Data'"},
      {"workbook-two-sheets.xlsx", day, true, false, "sheet 'Monday'", sheet("Monday")},
      {"workbook.ods", day, false, true, "3 empty cells"},
      {"ordinal-dates.csv", day},
      {"japanese-era.csv", day},
      {"japanese-era-letters.csv", day},
      {"dotted-clock.csv", day},
      {"dotted-clock-alone.csv", ""},
      {"opc-ua-nodes.csv", day},
      {"influx-line-protocol.txt", day + "Z"},
      {"datevec.csv", day + ".250"},
      {"date-hour-minute-second.csv", day},
      {"hour-minute-second.csv", "", false, false, "passes midnight 1 time"},
      {"plc-durations.csv", "", true},
      {"home-assistant.json", day + "Z", false, true, "'unavailable'"},
      {"home-assistant-socket.json", day + ".250Z", false, true, "'unknown'"},
      {"outer-join.csv", "", false, false, "times of their own"},
  };
}

class ExportOpens : public testing::TestWithParam<Export> {};

TEST_P(ExportOpens, WithTheTruthInIt) {
  const Export& e = GetParam();
  const Recording r = read_csv(path_of(e.file), e.options);
  ASSERT_EQ(r.size(), truth().size());
  EXPECT_NEAR(r.period_s, e.period_s, 1e-4);
  EXPECT_EQ(r.start, e.start);
  EXPECT_EQ(r.has(Column::sp), e.has_sp);
  for (std::size_t k = 0; k < r.size(); ++k) {
    const std::size_t of_y = e.lacks_y && k >= 10 && k <= 12 ? 9 : k;
    EXPECT_NEAR(r.t[k] - r.t[0], e.period_s * static_cast<double>(k), 2e-3) << k;
    EXPECT_DOUBLE_EQ(r.u[k], truth().u[k]) << k;
    EXPECT_NEAR(r.y[k], e.scale_y * truth().y[of_y], 1e-9) << k;
    if (e.has_sp) {
      EXPECT_DOUBLE_EQ(r.sp[k], truth().sp[k]) << k;
    }
  }
  std::string notes;
  for (const std::string& note : r.resampling.notes) notes += note + '\n';
  if (e.note.empty()) {
    EXPECT_EQ(notes, "");
  } else {
    EXPECT_NE(notes.find(e.note), std::string::npos) << notes;
  }
}

std::string test_name(const testing::TestParamInfo<Export>& info) {
  std::string name = std::to_string(info.index) + '_' + info.param.file;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpus, ExportOpens, testing::ValuesIn(exports()), test_name);

struct Refusal {
  std::string file;
  std::size_t line;
  std::string found;
  std::string advice;
};

TEST(ExportRefused, WithTheRightAdvice) {
  for (const Refusal& refusal : std::vector<Refusal>{
           {"deltav-several-loops.csv", 1, "FIC-101/PID1, FIC-102/PID1",
            "--u FIC-101/PID1/OUT.CV --y FIC-101/PID1/PV.CV"},
           {"own-names.csv", 1, "'FT_115' 'LV_106'", "--u LV_106 --y FT_115"},
           {"no-controller-output.csv", 1, "'FIC101.PV'", "--u COLUMN --y FIC101.PV"},
           {"typo.csv", 9, "'12..3'", "repair the cell"},
           {"mostly-bad.csv", 1, "34 of 40", "export a time"},
           {"two-days-in-one.csv", 22, "2026-05-13T14:30:00", "sort the rows"},
           {"damaged.xlsx", 0, "archive", "CSV UTF-8"},
           {"workbook-two-sheets.xlsx", 0, "'Monday', 'Tuesday'", "--sheet"},
           {"yokogawa-min-max.csv", 2, "both 'FIC101.OP Min' and 'FIC101.OP Max'",
            "--u \"FIC101.OP Min\""},
           {"controller-words.csv", 1, "both 'CV' and 'MV'", "--u CV"},
           {"workbook.xls", 1, "xls", "CSV UTF-8"},
           {"table.xls", 1, "web page", "CSV UTF-8"},
           {"frame.parquet", 1, "Parquet", "to_csv"},
       }) {
    SCOPED_TRACE(refusal.file);
    try {
      static_cast<void>(read_csv(path_of(refusal.file)));
      ADD_FAILURE() << "it opened";
    } catch (const InputError& error) {
      EXPECT_EQ(error.line, refusal.line) << error.what();
      EXPECT_NE(error.found.find(refusal.found), std::string::npos) << error.what();
      EXPECT_NE(error.advice.find(refusal.advice), std::string::npos) << error.what();
    }
  }
}

// Every file of the folder is in one of the tables.
TEST(ExportCorpus, IsTestedWhole) {
  std::vector<std::string> known = {"truth.csv",
                                    "typo.csv",
                                    "yokogawa-min-max.csv",
                                    "controller-words.csv",
                                    "mostly-bad.csv",
                                    "damaged.xlsx",
                                    "workbook-two-sheets.xlsx",
                                    "workbook-sheet-a-tag.xlsx",
                                    "workbook.xls",
                                    "table.xls",
                                    "frame.parquet",
                                    "two-days-in-one.csv",
                                    "no-controller-output.csv"};
  for (const Export& e : exports()) known.push_back(e.file);
  for (const auto& entry : std::filesystem::directory_iterator(STICKBAND_EXPORTS)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".py") || name[0] == '.') continue;
    EXPECT_NE(std::find(known.begin(), known.end(), name), known.end()) << name;
  }
}

class RealExports : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) {
      GTEST_SKIP() << "no recordings in " << folder_;
    }
  }
  std::filesystem::path folder_ = std::filesystem::path(STICKBAND_RECORDINGS) / "exports";
};

TEST_F(RealExports, EveryPairOfTheWideOneOpens) {
  const std::string path = (folder_ / "AREA400-export.csv").string();
  EXPECT_THROW(static_cast<void>(read_csv(path)), InputError);
  for (const std::string loop : {"FIC-400B", "FIC-400C", "FSC-400A", "LIC-400A"}) {
    SCOPED_TRACE(loop);
    CsvOptions options = named(loop + "/PID1/OUT", loop + "/PID1/PV");
    options.names.loads = {"all"};
    const Recording r = read_csv(path, options);
    EXPECT_EQ(r.size(), 781U);
    EXPECT_EQ(r.period_s, 1);
    EXPECT_EQ(r.start, "2025-04-23T14:14:00-04:00");
    EXPECT_EQ(r.unit(Column::u), "%");
    EXPECT_TRUE(r.has(Column::sp));
    EXPECT_EQ(r.loads.size(), 32U);
    for (const Load& load : r.loads) EXPECT_EQ(load.values.size(), r.size()) << load.name;
  }
}

TEST_F(RealExports, DateAndTimeInTwoColumnsNewestFirst) {
  const Recording r =
      read_csv((folder_ / "LIC-106-export.csv").string(), named("LV_106", "FT_115"));
  EXPECT_EQ(r.size(), 10080U);
  EXPECT_EQ(r.period_s, 60);
  EXPECT_EQ(r.start, "2024-11-21T00:00:00");
  EXPECT_EQ(r.u.back(), 44.9806976318359);
}

}  // namespace
}  // namespace workbench
