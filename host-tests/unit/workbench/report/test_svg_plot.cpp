// The pieces of the report, on numbers that can be checked by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numeric>

#include "support/base/temporary_folder.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/report/step_response.hpp"
#include "workbench/report/svg_plot.hpp"
#include "workbench/report/truth_file.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

TEST(ReportTicks, AreRoundNumbersInsideTheRange) {
  EXPECT_EQ(ticks(0, 10, 5), (Values{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks(-1, 1, 4), (Values{-1, -0.5, 0, 0.5, 1}));
  EXPECT_EQ(ticks(3, 3, 4), (Values{3}));
  for (const double width : {1e-9, 0.037, 1.0, 88.0, 4.2e7}) {
    for (const double low : {-1.3, 0.0, 7.7}) {
      const Values at = ticks(low * width, (low + 1) * width, 5);
      ASSERT_GE(at.size(), 2U);
      ASSERT_LE(at.size(), 11U);
      EXPECT_GE(at.front(), low * width - 1e-6 * width);
      EXPECT_LE(at.back(), (low + 1) * width + 1e-6 * width);
    }
  }
}

TEST(ReportVisiblePoints, KeepEveryExtremeInOrder) {
  Values y(100000);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = std::sin(static_cast<double>(i) * 0.7);
  y[54321] = 9;
  y[77777] = -9;
  const std::vector<std::size_t> shown = visible_points(y, 500);
  EXPECT_LE(shown.size(), 2000U);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  EXPECT_NE(std::find(shown.begin(), shown.end(), 54321U), shown.end());
  EXPECT_NE(std::find(shown.begin(), shown.end(), 77777U), shown.end());
  EXPECT_EQ(shown.front(), 0U);
  EXPECT_EQ(shown.back(), y.size() - 1);
  EXPECT_EQ(visible_points({1, 2, 3}, 500).size(), 3U);
}

TEST(ReportText, IsEscaped) {
  EXPECT_EQ(escaped("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
}

TEST(ReportFigure, DrawsConstantAndEmptyLinesWithoutNonsense) {
  Plot plot;
  plot.title = "a \"plot\"";
  plot.x_label = "t";
  plot.y_label = "y";
  plot.lines = {{"flat", Ink::kMeasured, {0, 1, 2}, {5, 5, 5}},
                {"absent", Ink::kValve, {}, {}}};
  const std::string svg = figure(plot, "");
  EXPECT_NE(svg.find("flat"), std::string::npos);
  EXPECT_EQ(svg.find("absent"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_NE(svg.find("a &quot;plot&quot;"), std::string::npos);
}

TEST(ReportFigure, DrawsBarsLevelsNamesAndNotes) {
  Plot plot;
  plot.width = 300;
  plot.height = 150;
  plot.bars = {{-0.5, 0.5, 1, false}, {0.5, 1.5, -2, true}};
  plot.levels = {{"noise", 0.5}};
  plot.names = {"start", "+ dead\ntime"};
  PlotLine line{"", Ink::kTwoPath, {0, 1}, {1, -2}};
  line.is_signal = false;
  line.notes = {"one", "<two>"};
  plot.lines = {line};
  const std::string svg = figure(plot, "");
  for (const char* part :
       {"class=\"usual\"", "class=\"raised\"", "class=\"level\"", ">noise<", ">start<",
        ">+ dead<", ">time<", ">one<", ">&lt;two&gt;<", "<circle", "data-still"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(svg.find("legend"), std::string::npos);
}

TEST(ReportTime, HasTheUnitThatGivesShortNumbers) {
  EXPECT_STREQ(time_unit_for(30).label, "time, s");
  EXPECT_EQ(time_unit_for(3600).seconds, 60);
  EXPECT_EQ(time_unit_for(86400).seconds, 3600);
  EXPECT_EQ(time_unit_for(1e7).seconds, 86400);
}

TEST(ReportWording, RoundsToWhatTheIntervalSupports) {
  EXPECT_EQ(text_of({true, 5.0234, 4.83, 5.21}).value, "5.02");
  EXPECT_EQ(text_of({true, 5.0234, 4.83, 5.21}).interval, "4.83 to 5.21");
  EXPECT_EQ(text_of({true, 512.34, 480, 540}).value, "512");
  EXPECT_EQ(text_of({}).value, "unknown");
  EXPECT_EQ(fixed(-0.0001, 2), "0.00");
  EXPECT_EQ(fixed(-1.5, 1), "-1.5");
  EXPECT_EQ(fixed(NAN, 1), "–");
  EXPECT_EQ(duration(29.2), "29.2 s");
  EXPECT_EQ(duration(1400), "23.3 min");
  EXPECT_EQ(duration(9000), "2.50 h");
}

// One first-order process behind two paths that differ by a shift.
Identification known_model() {
  Identification r;
  r.model.process.na = 1;
  r.model.process.nb = 1;
  r.model.process.nk = 2;
  r.model.process.a[0] = -0.9;
  r.model.process.b[0] = 1;
  r.model.process.d = 3;
  const auto path = [](double start) {
    ident::Path<double> p;
    p.segments = 1;
    p.knots = {0, 10};
    p.x = {start, start + 5};  // half a unit of x for each unit of u
    return p;
  };
  r.model.ascending = path(0);
  r.model.descending = path(0);
  return r;
}

Simulation triangle() {
  Simulation s;
  s.period_s = 0.5;
  for (int i = 0; i < 200; ++i) {
    s.t.push_back(i * 0.5);
    s.u.push_back(i % 40 < 20 ? i % 20 * 0.5 : 10 - i % 20 * 0.5);
  }
  s.y = s.u;
  s.y_two_path = s.u;
  return s;
}

TEST(ReportStepResponse, IsInUnitsOfUWhateverTheModelsOwnMeasure) {
  const Identification r = known_model();
  const Simulation s = triangle();
  const StemScale scale = stem_scale(r.model, s);
  EXPECT_NEAR(scale.scale, 2, 1e-9);
  const StepResponse step = two_path_step(r, scale, s);
  // x rises by 1/2: y tends to (1/2) / (1 - 0.9) = 5, after nk + 1 = 3 samples.
  ASSERT_GT(step.y.size(), 20U);
  EXPECT_EQ(step.y[0], 0);
  EXPECT_EQ(step.y[2], 0);
  EXPECT_NEAR(step.y[3], 0.5, 1e-12);
  EXPECT_NEAR(step.y[4], 0.95, 1e-12);
  EXPECT_NEAR(step.y.back(), 5, 0.15);
  EXPECT_EQ(step.t[1], 0.5);
}

TEST(ReportStepResponse, OfAKnownProcess) {
  const StepResponse step = true_step({2, 10, 0, 1, false}, 0.5, 60);
  EXPECT_EQ(step.y.front(), 0);
  EXPECT_NEAR(step.y[22], 2 * (1 - std::exp(-1.0)), 1e-9);  // 1 s dead time + 10 s
  EXPECT_NEAR(step.y.back(), 2, 0.01);
}

class TruthFile : public ::testing::Test {
 protected:
  std::string write(const std::string& text) {
    std::ofstream(folder_.file("truth.json")) << text;
    return folder_.file("truth.json");
  }
  std::string error_of(const std::string& text) {
    try {
      static_cast<void>(read_truth(write(text)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;
};

TEST_F(TruthFile, SaysWhereItIsWrong) {
  EXPECT_NE(error_of("{\n  \"kind\": oops}").find("truth.json:2:11: "), std::string::npos)
      << error_of("{\n  \"kind\": oops}");
  EXPECT_NE(error_of("").find("truth.json:1:1: "), std::string::npos);
  EXPECT_NE(error_of("[1]").find("simulate --truth"), std::string::npos);
  EXPECT_NE(error_of("{\"kind\":1}").find("simulate --truth"), std::string::npos);
  const KnownTruth truth = read_truth(
      write(R"({"kind":"stiction","stick_band":{"ascending":5,"descending":4},)"
            R"("slip_jump":{"ascending":3,"descending":2}})"));
  EXPECT_EQ(truth.stick_band_descending, 4);
  EXPECT_FALSE(truth.process.has_value());
}

}  // namespace
}  // namespace workbench
