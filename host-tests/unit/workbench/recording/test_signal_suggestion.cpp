#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/signal_suggestion.hpp"

namespace workbench {
namespace {

std::vector<NamedSignal> signals(const std::vector<std::string>& texts) {
  std::vector<NamedSignal> out;
  for (const std::string& text : texts) {
    out.push_back({column_name(text), out.size() + 1, 1, true});
  }
  return out;
}

// "0 1" for u and y; "": none.
std::string only(const std::vector<std::string>& texts) {
  std::string out;
  for (const PickedSignal& signal : only_signals(
           signals(texts), std::vector<bool>(texts.size()), {Column::u, Column::y})) {
    EXPECT_TRUE(signal.by_elimination);
    out += (out.empty() ? "" : " ") + std::to_string(signal.index);
  }
  return out;
}

TEST(SignalSuggestion, TheOnlyOutputAndTheOnlyMeasuredValue) {
  EXPECT_EQ(only({"CH1[V] OUT", "CH2[V] PV"}), "0 1");
  EXPECT_EQ(only({"Durchfluss Ist", "Durchfluss Soll", "Reglerausgang"}), "2 0");
  EXPECT_EQ(only({"D102 PV", "D100 MV"}), "1 0");
  EXPECT_EQ(only({"101 <FIC101.OP> (VDC)", "102 <FIC101.PV> (VDC)"}), "0 1");
}

TEST(SignalSuggestion, NotOfTwoLoops) {
  EXPECT_EQ(only({"FIC101.OP", "TIC102.PV"}), "");
  EXPECT_EQ(only({"FT_115", "LV_106"}), "");
  EXPECT_EQ(only({"U1:FIC101.OP", "U1:TIC102.PV"}), "");
  EXPECT_EQ(only({"U1:FIC101.OP", "U2:FIC101.PV"}), "");
  EXPECT_EQ(only({"101 <FIC101.OP>", "102 <TIC102.PV>"}), "");
  EXPECT_EQ(only({"10FIC101.OP", "10TIC102.PV"}), "");
  EXPECT_EQ(only({"Feed flow OP", "Reactor level PV"}), "");
  EXPECT_EQ(only({"OP", "FIC101.PV", "FIC102.PV"}), "");
}

TEST(SignalSuggestion, TheOnlyOtherSignal) {
  EXPECT_EQ(only({"::Ctrl:out", "::Ctrl:act"}), "0 1");
  EXPECT_EQ(only({"PV", "Valve (%)"}), "1 0");
  EXPECT_EQ(only({"PV", "Something"}), "");
  EXPECT_EQ(only({"Output", "Input"}), "");
  EXPECT_EQ(only({"Output", "Target"}), "");
  EXPECT_EQ(only({"Output", "a", "b"}), "");
  EXPECT_EQ(only({"MV", "SP", "CO"}), "");
}

TEST(SignalSuggestion, NothingWhereOneOfThemIsGiven) {
  const auto candidates = signals({"out", "act"});
  EXPECT_TRUE(only_signals(candidates, {false, false}, {Column::y}).empty());
}

TEST(SignalSuggestion, ProposesByWordsThenWhatIsLeft) {
  const auto candidates = signals({"Valve", "Flow"});
  EXPECT_EQ(suggested_signals(candidates, {false, false}, {Column::u, Column::y}),
            (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(suggested_signals(candidates, {true, false}, {Column::u}),
            (std::vector<std::size_t>{2}));
  EXPECT_EQ(
      suggested_signals(signals({"A", "B"}), {false, false}, {Column::u, Column::y}),
      (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(
      suggested_signals(signals({"A", "SP"}), {false, false}, {Column::u, Column::y}),
      (std::vector<std::size_t>{2, 2}))
      << "one is left of two";
  EXPECT_EQ(suggested_signals(signals({"targetSpeed", "leftSpeed", "leftCommand"}),
                              {false, false, false}, {Column::u, Column::y}),
            (std::vector<std::size_t>{2, 1}));
}

TEST(SignalSuggestion, KnowsTheWordsOfBuildings) {
  const auto of = [](const std::vector<std::string>& names) {
    return suggested_signals(signals(names), std::vector<bool>(names.size(), false),
                             {Column::u, Column::y});
  };
  EXPECT_EQ(of({"DuctStaticPressureStPt", "SupplyFanSpeedCommand", "DuctStaticPressure"}),
            (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(of({"supply_vfd_speed", "duct_static"}), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(of({"ControlSetpoint", "RoomTemperature", "DamperCommand"}),
            (std::vector<std::size_t>{2, 1}));
}

TEST(SignalSuggestion, ProposesWhatMovesBeforeWhatRests) {
  auto candidates = signals({"HeatingCommand", "CoolingCommand", "RoomTemperature"});
  candidates[0].held = 1;
  EXPECT_EQ(suggested_signals(candidates, {false, false, false}, {Column::u, Column::y}),
            (std::vector<std::size_t>{1, 2}));
}

TEST(SignalSuggestion, ANumberBehindASignalSaysNothingAgainstIt) {
  EXPECT_EQ(suggested_signals(signals({"F.PV1", "F.OP1"}), {false, false},
                              {Column::u, Column::y}),
            (std::vector<std::size_t>{1, 0}));
}

TEST(SignalSuggestion, ReferenceMeasuredValueAndOutputOfDin) {
  EXPECT_EQ(suggested_signals(signals({"W", "X", "Y"}), {false, false, false},
                              {Column::u, Column::y}),
            (std::vector<std::size_t>{2, 1}));
}

TEST(SignalSuggestion, OfAPositionerItsPosition) {
  const auto proposed = [](const std::vector<std::string>& texts) {
    return suggested_signals(signals(texts), std::vector<bool>(texts.size()),
                             {Column::u, Column::y});
  };
  EXPECT_EQ(proposed({"Input Signal (%)", "Travel (%)", "Pressure A (bar)"}),
            (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(proposed({"Pressure", "Valve position", "Setpoint"}),
            (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(proposed({"x", "w"}), (std::vector<std::size_t>{1, 0}));
}

TEST(SignalSuggestion, AnOutputBesideAControlEffortMayBeThatOfTheProcess) {
  EXPECT_EQ(suggested_signals(signals({"Saída", "Erro", "Esforço"}),
                              {false, false, false}, {Column::u, Column::y}),
            (std::vector<std::size_t>{3, 3}));
}

TEST(SignalSuggestion, TheLastWordOfAnExtreme) {
  for (const char* name : {"A.PV (Max)", "A.PV|Minimum", "PV_min", "OP [StdDev]"}) {
    EXPECT_TRUE(is_extreme(column_name(name))) << name;
  }
  for (const char* name : {"A.PV", "PV Avg", "Max.PV", "", "()"}) {
    EXPECT_FALSE(is_extreme(column_name(name))) << name;
  }
}

TEST(SignalSuggestion, ProposesCardsAndTheValveOfAProcess) {
  const auto suggested = [](const std::vector<std::string>& texts) {
    return suggested_signals(signals(texts), std::vector<bool>(texts.size()),
                             {Column::u, Column::y});
  };
  EXPECT_EQ(suggested({"AI1", "AO1"}), (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(suggested({"Valve Position (%)", "Flow (m3/h)", "Flow Setpoint (m3/h)"}),
            (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace workbench
