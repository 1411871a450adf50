#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/column_name.hpp"

namespace workbench {
namespace {

struct Expected {
  std::string text;
  Part part;
  std::string tag;
  std::string unit;
};

TEST(ColumnName, SaysTagPartAndUnit) {
  for (const Expected& e : std::vector<Expected>{
           {"FIC101.OP", Part::kU, "fic101", ""},
           {"FIC-101/PV [m3/h]", Part::kY, "fic101", "m3/h"},
           {"FIC101.OP.Value", Part::kU, "fic101", ""},
           {"FIC-400B/PID1/OUT.CV %", Part::kU, "fic400bpid1", "%"},
           {"FIT-400A/AI1/OUT.CV gal/min", Part::kU, "fit400aai1", "gal/min"},
           {"LIC-400A/PID1/GAIN.CV No EngUnits", Part::kU, "lic400apid1gain",
            "No EngUnits"},
           {"FIC101/PID.MV#Value", Part::kMv, "fic101pid", ""},
           {"[default]FIC101/PV", Part::kY, "defaultfic101", ""},
           {"\\\\SRV\\FIC101.SP", Part::kSp, "srvfic101", ""},
           {"FIC101 (OP)", Part::kU, "fic101", ""},
           {"FIC101_OP (avg)", Part::kU, "fic101", ""},
           {"PV FIC101", Part::kY, "fic101", ""},
           {"FT_211", Part::kY, "f211", ""},
           {"FCV-211 [%]", Part::kU, "f211", "%"},
           {"Unit 5 LT106.Value", Part::kY, "unit5l106", ""},
           {"PV_101", Part::kY, "101", ""},
           {"pos (4)", Part::kNone, "", ""},
           {"Stellgröße [%]", Part::kU, "", "%"},
           {"Istwert in °C", Part::kY, "", "°C"},
           {"Set Point", Part::kSp, "", ""},
           {"Process value (m3/h)", Part::kY, "", "m3/h"},
           {"Reactor flow (FIC101.PV)", Part::kY, "fic101", ""},
           {"FIC101.PV - Flow of reactor 1", Part::kY, "fic101", ""},
           {"FIC101.OP Valve output signal", Part::kU, "fic101", ""},
           {"FIC101.PV_Q", Part::kQuality, "fic101pv", ""},
           {"FIC101.PV Quality Code", Part::kNone, "", ""},
           {"Stellgröße Y", Part::kU, "", ""},
           {"Regelgröße X", Part::kY, "", ""},
           {"OP / %", Part::kU, "", "%"},
           {"OP, %", Part::kU, "", "%"},
           {"FIC101.PV.Quality", Part::kQuality, "fic101pv", ""},
           {"t [s]", Part::kTime, "", "s"},
           {"Time_ms", Part::kTime, "", "ms"},
           {"Zeit in min", Part::kTime, "", "min"},
           {"Date/Time", Part::kTime, "", ""},
           {"IP_TREND_VALUE", Part::kValue, "ip", ""},
           {"OP_IP_TREND_VALUE", Part::kU, "", ""},
           {"FIC101.PV_IP_TREND_VALUE", Part::kY, "fic101", ""},
           {"LV_106", Part::kU, "l106", ""},
           {"axis x", Part::kNone, "", ""},
           {"", Part::kNone, "", ""},
       }) {
    SCOPED_TRACE(e.text);
    const ColumnName name = column_name(e.text);
    EXPECT_EQ(name.part, e.part);
    EXPECT_EQ(name.tag, e.tag);
    EXPECT_EQ(name.unit, e.unit);
  }
}

TEST(ColumnName, KeysForgetCaseSeparatorsAndUnits) {
  EXPECT_EQ(column_name("FIC-101/PV [m3/h]").key, column_name("fic101.pv.value").key);
  EXPECT_EQ(column_name("STELLGR\xD6\xDF"
                        "E")
                .key,
            column_name("Stellgröße").key);
  EXPECT_EQ(column_name("FIC101.PIDA.OP").loop, column_name("FIC101.DACA.PV").loop);
}

TEST(ColumnWords, KnowUnits) {
  for (const char* unit : {"%", "[%]", "(m3/h)", "°C", "No EngUnits", "M3/H", "m³/h"}) {
    EXPECT_TRUE(is_unit(unit)) << unit;
  }
  for (const char* other : {"FIC101", "", "Good", "12"})
    EXPECT_FALSE(is_unit(other)) << other;
}

TEST(ColumnName, MayBeFullOfBrackets) {
  std::string name;
  for (int k = 0; k < 20'000; ++k) name += "a(";
  name += std::string(20'000, ')');
  EXPECT_TRUE(column_name(name).unit.empty());
}

TEST(ColumnName, HowAValueWasMadeIsNoAddress) {
  const ColumnName name = column_name("FIC101.PV@1s avg");
  EXPECT_EQ(name.part, Part::kY);
  EXPECT_EQ(name.tag, "fic101");
  EXPECT_EQ(column_name("FIC101-OUT.UNIT1@NET0").part, Part::kU);
}

}  // namespace
}  // namespace workbench
