#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/workbench/column_names.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/signal_choice.hpp"

namespace workbench {
namespace {

class SignalChoice : public testing::Test {
 protected:
  void given(const std::vector<std::string>& texts) {
    signals_.clear();
    for (const std::string& text : texts) {
      signals_.push_back({column_name(text), signals_.size() + 1, 1, true});
    }
  }

  // "u=FIC101.OP y=FIC101.PV", loads as "+".
  std::string chosen(const ColumnNames& names = {},
                     const std::vector<Column>& required = {Column::u, Column::y}) {
    std::string text;
    for (const PickedSignal& s : choose_signals(signals_, names, required, {file_})) {
      text += (text.empty() ? "" : " ") +
              (s.is_load() ? std::string("+") : std::string(name_of(s.column)) + "=") +
              signals_[s.index].name.text;
    }
    return text;
  }

  std::string refusal(const ColumnNames& names = {}) {
    try {
      return "chose " + chosen(names);
    } catch (const InputError& error) {
      return error.what();
    }
  }

  std::string usage(const ColumnNames& names) {
    try {
      return "chose " + chosen(names);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  }

  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  const std::string file_ = "f.csv";
  std::vector<NamedSignal> signals_;
};

TEST_F(SignalChoice, EachIsASignalOfItsOwn) {
  given({"A", "B", "C"});
  EXPECT_EQ(chosen(test::named("A", "B")), "u=A y=B");
  EXPECT_THROW(chosen(test::named("A", "A")), std::invalid_argument);
}

TEST_F(SignalChoice, TakesThePlainOneOfSeveralValues) {
  given({"PV", "PV_raw", "OP"});
  EXPECT_EQ(chosen(), "u=OP y=PV");
  given({"OP Min", "OP Max", "OP Avg", "PV Min", "PV Max", "PV Avg"});
  EXPECT_EQ(chosen(), "u=OP Avg y=PV Avg");
}

TEST_F(SignalChoice, TakesNoExtremeBesideAnotherValue) {
  given({"A.OP (Avg)", "A.OP (Min)", "A.OP (Max)", "A.PV (Max)", "A.PV (Avg)"});
  EXPECT_EQ(chosen(), "u=A.OP (Avg) y=A.PV (Avg)");
  given({"OP", "OP Min", "PV", "PV StdDev"});
  EXPECT_EQ(chosen(), "u=OP y=PV");
  given({"A.OP Min", "A.OP Max", "A.PV"});
  EXPECT_TRUE(has(refusal(), "one column for u")) << refusal();
}

TEST_F(SignalChoice, TheInputOfAControllersBlockIsMeasured) {
  given({"\"DB1\".Setpoint", "\"DB1\".Input", "\"DB1\".Output"});
  EXPECT_EQ(chosen(), "u=\"DB1\".Output y=\"DB1\".Input sp=\"DB1\".Setpoint");
  given({"Input", "Output", "Setpoint"});
  EXPECT_EQ(chosen(), "u=Output y=Input sp=Setpoint");
  given({"Input", "Output"});
  EXPECT_TRUE(has(refusal(), "--u COLUMN --y COLUMN")) << refusal();
  given({"A.Input", "B.Output", "B.Setpoint"});
  EXPECT_TRUE(has(refusal(), "expected a column y")) << refusal();
}

TEST_F(SignalChoice, AsksWhichOfCvAndMvIsTheOutput) {
  given({"FIC101.CV", "FIC101.SP", "FIC101.PV"});
  EXPECT_EQ(chosen(), "u=FIC101.CV y=FIC101.PV sp=FIC101.SP");
  given({"CV", "PV", "MV"});
  EXPECT_TRUE(has(refusal(), "both 'CV' and 'MV'")) << refusal();
  ColumnNames names;
  names.u = "MV";
  EXPECT_EQ(chosen(names), "u=MV y=PV");
}

TEST_F(SignalChoice, ProposesWhatMovesInStepsAndWhatTheLettersSay) {
  given({"T1", "Q1"});
  signals_[1].held = 0.9;
  EXPECT_TRUE(has(refusal(), "for example --u Q1 --y T1")) << refusal();
  given({"when", "uEst", "uVal", "yEst", "yVal"});
  signals_[0].counts = true;
  EXPECT_TRUE(has(refusal(), "for example --u uEst --y yEst")) << refusal();
}

TEST_F(SignalChoice, ProposesAnInputAsUAndWhatIsReadAsY) {
  given({"time(ms)", "encoder(steps)", "inputSignal(8bits)"});
  EXPECT_TRUE(has(refusal(), "--u \"inputSignal(8bits)\" --y \"encoder(steps)\""))
      << refusal();
  given({"Tiempo (s)", "PWM", "Velocidad (rad/s)"});
  EXPECT_TRUE(has(refusal(), "--u PWM --y \"Velocidad (rad/s)\"")) << refusal();
}

TEST_F(SignalChoice, ProposesNothingForWhatTheWordsRuleOut) {
  given({"timestamp_ms", "setpoint_rpm", "actual_rpm"});
  signals_[0].counts = true;
  EXPECT_TRUE(has(refusal(), "for example --u COLUMN --y actual_rpm")) << refusal();
  given({"box temp", "heater 1 temp", "control of heater", "P"});
  signals_[3].empty = true;
  EXPECT_TRUE(has(refusal(), "--u \"control of heater\" --y \"box temp\"")) << refusal();
}

TEST_F(SignalChoice, ProposesNoAimAndNoError) {
  given({"Q2", "T2SP", "T2"});
  EXPECT_TRUE(has(refusal(), "for example --u Q2 --y T2")) << refusal();
  given({"target_speed", "actual_velocity_mps", "error_mps", "torque_nm", "p_term_nm"});
  EXPECT_TRUE(has(refusal(), "--u COLUMN --y actual_velocity_mps")) << refusal();
  given({"xmeas_9", "xmeas_21", "xmv_10", "xmv_11"});
  EXPECT_TRUE(has(refusal(), "--u xmv_10 --y xmeas_9")) << refusal();
  given({"s1", "s2", "s3", "errorX", "posX"});
  EXPECT_TRUE(has(refusal(), "--u COLUMN --y COLUMN")) << refusal();
}

TEST_F(SignalChoice, MvBesideCvWithoutPvIsLeftOpen) {
  given({"FIC101.MV", "FIC101.SV", "FIC101.CV"});
  EXPECT_TRUE(has(refusal(), "--u COLUMN --y COLUMN")) << refusal();
}

TEST_F(SignalChoice, AllLoadsAreThoseThatHoldAnything) {
  given({"u", "y", "T1", "P"});
  signals_[3].empty = true;
  ColumnNames wish;
  wish.loads = {"all"};
  EXPECT_EQ(chosen(wish), "u=u y=y +T1");
  wish.loads = {"T1", "t1"};
  EXPECT_EQ(chosen(wish), "u=u y=y +T1");
}

TEST_F(SignalChoice, TakesAsALoadWhatIsNamedSo) {
  given({"FIC101.OP", "FIC101.PV", "FIC101.SP"});
  ColumnNames names;
  names.u = "FIC101.OP";
  names.y = "FIC101.PV";
  EXPECT_EQ(chosen(names), "u=FIC101.OP y=FIC101.PV sp=FIC101.SP");
  names.loads = {"FIC101.SP"};
  EXPECT_EQ(chosen(names), "u=FIC101.OP y=FIC101.PV +FIC101.SP");
}

TEST_F(SignalChoice, TakesTheOnlyPairAndItsCompanions) {
  given({"FIC101.SP", "FIC101.OP", "TIC2.PV", "FIC101.PV", "FIC101.POS"});
  EXPECT_EQ(chosen(), "u=FIC101.OP y=FIC101.PV sp=FIC101.SP x=FIC101.POS");
}

TEST_F(SignalChoice, MvIsTheOutputUnlessThereIsAnother) {
  given({"FIC101.MV", "FIC101.PV"});
  EXPECT_EQ(chosen(), "u=FIC101.MV y=FIC101.PV");
  given({"OP", "MV", "PV"});
  EXPECT_EQ(chosen(), "u=OP y=PV x=MV");
}

TEST_F(SignalChoice, BareNamesAndBlocksOfOneLoop) {
  given({"u", "y", "FIC101.OP", "FIC101.PV"});
  EXPECT_EQ(chosen(), "u=u y=y");
  given({"FIC101.PIDA.OP", "FIC101.DACA.PV"});
  EXPECT_EQ(chosen(), "u=FIC101.PIDA.OP y=FIC101.DACA.PV");
  given({"PID1/OUT", "PID1/PV", "AI1/OUT"});
  EXPECT_EQ(chosen({}, {Column::u}), "u=PID1/OUT y=PID1/PV");
}

TEST_F(SignalChoice, SeveralLoopsAreListedWithACommandLine) {
  given({"A.OP", "A.PV", "B.OP", "B.PV"});
  const std::string text = refusal();
  EXPECT_TRUE(has(text, "2 loops: A, B")) << text;
  EXPECT_TRUE(has(text, "--u A.OP --y A.PV")) << text;
  EXPECT_EQ(chosen(test::named("B.OP")), "u=B.OP y=B.PV");
}

TEST_F(SignalChoice, AMissingColumnListsWhatThereIs) {
  given({"LV_106", "FT 115"});
  const std::string text = refusal();
  EXPECT_TRUE(has(text, "'LV_106' 'FT 115'")) << text;
  EXPECT_TRUE(has(text, "--u LV_106 --y \"FT 115\"")) << text;
  given({"FT_211", "FV_211", "FT_115"});
  EXPECT_EQ(chosen(), "u=FV_211 y=FT_211");
  given({"FIC101.OP", "FIC101.PV", "FT_211", "FV_211"});
  EXPECT_EQ(chosen(), "u=FIC101.OP y=FIC101.PV");
  given({"A.OP", "B.PV"});
  EXPECT_TRUE(has(refusal(), "of one tag"));
}

TEST_F(SignalChoice, NoPrefixMakesOneLoopOfTwo) {
  for (const std::string front :
       {"", "Area1.", "Area1/", "\\\\SRV\\", "U1:", "[PLC]", "Channel1.PLC.", "Unit 1 ",
        "01-", "10", "export_", "Root."}) {
    for (const auto& [u, y] : {std::pair<std::string, std::string>("FIC101", "TIC205"),
                               {"FIC-1014", "FIC-1015"},
                               {"FIC101.PID", "TIC205.PID"}}) {
      given({front + u + ".OP", front + y + ".PV"});
      EXPECT_TRUE(has(refusal(), "of one tag")) << refusal();
      EXPECT_EQ(chosen(test::named("#1", "#2")),
                "u=" + front + u + ".OP y=" + front + y + ".PV");
    }
  }
  given({"Area1/TIC205/PV", "Area1/TIC205/SP", "Area1/FIC101/OP"});
  EXPECT_TRUE(has(refusal(), "of one tag")) << refusal();
}

TEST_F(SignalChoice, SaysThatTheOnlyOneLeftIsOfAnotherLoop) {
  given({"FIC101.OP", "TIC205.PV"});
  const ColumnNames names = test::named("FIC101.OP");
  const std::vector<PickedSignal> picked =
      choose_signals(signals_, names, {Column::u, Column::y}, {file_});
  EXPECT_EQ(elimination_note(picked, signals_),
            "taken for lack of any other: y 'TIC205.PV'");
}

TEST_F(SignalChoice, BlocksAndInstrumentsOfOneNumberAreOneLoop) {
  for (const auto& [u, y] : {std::pair("Area1.FIC101.PIDA.OP", "Area1.FIC101.DACA.PV"),
                             {"FIC-400C/PID1/OUT", "FIC-400C/AI1/PV"},
                             {"Area1.FIC101.OP", "Area1.FT101.PV"},
                             {"Loop1.Controller.OP", "Loop1.Sensor.PV"}}) {
    given({u, y});
    EXPECT_EQ(chosen(), std::string("u=") + u + " y=" + y);
  }
}

TEST_F(SignalChoice, NamesFitWithoutCaseUnitPrefixAndByNumber) {
  given({"\\\\S\\FIC101.OP [%]", "\\\\S\\FIC101.PV", "\\\\S\\TI7.PV"});
  for (const std::string u : {"fic101.op", "FIC-101/OP", "#1", "\\\\S\\FIC101.OP [%]"}) {
    EXPECT_EQ(chosen(test::named(u, "TI7")), "u=\\\\S\\FIC101.OP [%] y=\\\\S\\TI7.PV")
        << u;
  }
}

TEST_F(SignalChoice, ANameThatFitsNoneOrSeveralIsWrongUsage) {
  given({"A.OP", "A.PV", "B.OP", "B.PV"});
  EXPECT_TRUE(has(usage(test::named("OP", "A.PV")), "several columns"));
  EXPECT_TRUE(has(usage(test::named("OP", "A.PV")), "#1, #3"));
  EXPECT_TRUE(has(usage(test::named("C.OP", "A.PV")), "no such name"));
  EXPECT_TRUE(has(usage(test::named("#9", "A.PV")), "has the columns"));
  EXPECT_TRUE(has(usage(test::named("A.OP", "A.PV", {"A.PV"})), "already"));
}

TEST_F(SignalChoice, LoadsByNameOrAll) {
  given({"A.OP", "A.PV", "TI1", "A.PV.Quality", "PI2", ""});
  EXPECT_EQ(chosen(test::named("", "", {"pi2"})), "u=A.OP y=A.PV +PI2");
  EXPECT_EQ(chosen(test::named("", "", {"all"})), "u=A.OP y=A.PV +TI1 +PI2");
}

}  // namespace
}  // namespace workbench
