// The report on a model: what its pictures and sentences say.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/report/model_headline.hpp"
#include "workbench/report/model_page.hpp"
#include "workbench/report/model_parts.hpp"
#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

std::size_t count_of(const std::string& text, std::string_view what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

bool says(const std::string& text, std::string_view what) {
  return text.find(what) != std::string::npos;
}

// A loop with a dead time of six samples, and two models of it.
class ModelPage : public ::testing::Test {
 protected:
  ModelPage() {
    test::SetpointLoop loop;
    loop.delay = 6;
    recording_ = test::simulated(loop);
    recording_.name = "<late>.csv";
    start_ = start_model(recording_, Column::y).model;
  }
  [[nodiscard]] ModelReport report_on(const Model& model) const {
    return {recording_, model, compare(recording_, model), explain(recording_, model)};
  }

  Recording recording_;
  Model start_;
};

TEST_F(ModelPage, NamesWhatIsMissingAndWhatItWouldBring) {
  const ModelReport report = report_on(start_);
  EXPECT_EQ(model_headline(report), "The model still lacks dead time.");
  const std::string page = model_page(report);
  EXPECT_TRUE(says(page, "<h1>The model still lacks dead time.</h1>"));
  EXPECT_TRUE(says(page, "class=\"verdict bad\""));
  EXPECT_TRUE(says(page, "not yet added"));
  EXPECT_TRUE(says(page, "process.dead_time"));
  EXPECT_TRUE(says(page, "&lt;late&gt;.csv"));
  EXPECT_FALSE(says(page, "<late>"));
}

TEST_F(ModelPage, TellsWhatWasFoundWithItsParametersAndTheFallOfTheError) {
  const Model model = add_effect(recording_, start_, "process.dead_time").model;
  const ModelReport report = report_on(model);
  EXPECT_EQ(model_headline(report), "The model is complete: explained by dead time.");
  const std::string page = model_page(report);
  EXPECT_TRUE(says(page, "class=\"verdict good\""));
  EXPECT_TRUE(says(page, "Since the start"));
  EXPECT_FALSE(says(page, "not yet added"));
  const std::string ladder = ladder_figure(report);
  EXPECT_EQ(count_of(ladder, "<circle"), 2U);
  EXPECT_TRUE(says(ladder, "noise, about"));
  EXPECT_TRUE(says(ladder, ">start<"));
}

TEST_F(ModelPage, LabelsARefitToAnotherRecordingAsOne) {
  const Model model = add_effect(recording_, start_, "process.dead_time").model;
  EXPECT_EQ(refitted_error(report_on(model)), 0);
  test::SetpointLoop loop;
  loop.delay = 6;
  loop.seed = 77;
  loop.lag_s = 30;
  recording_ = test::simulated(loop);
  const ModelReport report = report_on(model);
  ASSERT_GT(refitted_error(report), 0);
  EXPECT_TRUE(says(model_verdict(report), "Refit."));
  EXPECT_TRUE(says(model_tiles(report), "after a refit"));
}

TEST_F(ModelPage, PutsTheVerdictOnTheValveFirstWhereItIsKnown) {
  Analysis analysis(recording_);
  const ReportData valve{recording_, analysis, analysis.simulate(), std::nullopt};
  const std::string page = model_page(report_on(start_), &valve);
  const std::string_view verdict =
      headline(analysis.result().verdict, analysis.result().reason,
               analysis.result().detectable_band);
  ASSERT_TRUE(says(page, verdict));
  EXPECT_LT(page.find(verdict), page.find("The model still lacks", page.find("<main>")));
  EXPECT_TRUE(says(page, "process output over controller output"));
}

TEST_F(ModelPage, NamesTheUnitWhereTheFileDoes) {
  EXPECT_TRUE(says(model_tiles(report_on(start_)), "units of y"));
  recording_.units[static_cast<std::size_t>(Column::y)] = "m3/h";
  EXPECT_TRUE(says(model_tiles(report_on(start_)), "m3/h"));
}

TEST_F(ModelPage, IsSelfContainedAndWithoutNonsenseNumbers) {
  const std::string page = model_page(report_on(start_));
  for (const char* foreign : {"http://", "https://", "src=", "@import", "url("}) {
    const std::size_t name_spaces =
        foreign == std::string_view("http://") ? count_of(page, "http://www.w3.org") : 0;
    EXPECT_EQ(count_of(page, foreign), name_spaces) << foreign;
  }
  for (const char* nonsense : {">nan", "\"nan", " nan", "inf\"", ">inf<"}) {
    EXPECT_FALSE(says(page, nonsense)) << nonsense;
  }
}

TEST_F(ModelPage, ShowsTheResidualInEveryViewTheLargestShareFirst) {
  const ModelReport report = report_on(start_);
  const std::string panels = residual_panels(report);
  EXPECT_EQ(count_of(panels, "<svg"), 8U);
  ASSERT_FALSE(report.comparison.failures.empty());
  EXPECT_LT(panels.find(escaped(report.comparison.failures.front().where)),
            panels.find("</svg>"));
  EXPECT_TRUE(says(panels, "class=\"raised\""));
}

TEST_F(ModelPage, SaysAndPaintsByOneRuleWhetherTheResidualFollowsU) {
  ModelReport report = report_on(start_);
  ASSERT_TRUE(report.comparison.residual_test.follows_u);
  const auto lags = [&report] {
    const std::string panels = residual_panels(report);
    const std::size_t at = panels.find("Lag behind u");
    return panels.substr(at, panels.find("</svg>", at) - at);
  };
  EXPECT_TRUE(says(lags(), "still follows u"));
  EXPECT_TRUE(says(lags(), "raised"));
  report.comparison.residual_test.follows_u = false;
  EXPECT_TRUE(says(lags(), "does not follow u"));
  EXPECT_FALSE(says(lags(), "raised"));
}

TEST_F(ModelPage, DrawsNoDetourOfTheLadder) {
  Model model = start_;
  const auto step = [&](const char* effect, double before, double after) {
    model.history.push_back({effect, recording_.name, before, after, before, after});
  };
  const double start = model.history.front().rmse_validation_after;
  step("valve.rate_limit", start, 0.5 * start);
  step("-valve.rate_limit", 0.5 * start, start);
  step("process.dead_time", start, 0.4 * start);
  const std::string ladder = ladder_figure(report_on(model));
  EXPECT_FALSE(says(ladder, "without"));
  EXPECT_TRUE(says(ladder, "replaced on the way"));
  // What was taken out for good is no detour.
  model.history.pop_back();
  EXPECT_TRUE(says(ladder_figure(report_on(model)), "without"));
}

TEST_F(ModelPage, LeavesTheLadderOutOfAModelWithoutHistory) {
  Model model = start_;
  model.history.clear();
  EXPECT_TRUE(ladder_figure(report_on(model)).empty());
}

TEST(ReportTitles, AreWordsForCodes) {
  EXPECT_EQ(title_of("valve.stiction"), "stiction");
  EXPECT_EQ(title_of("valve.unheard_of"), "valve.unheard_of");
}

}  // namespace
}  // namespace workbench
