// The state of a model in one sentence.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/report/model_headline.hpp"
#include "workbench/report/model_parts.hpp"

namespace workbench {
namespace {

class ModelHeadline : public ::testing::Test {
 protected:
  ModelHeadline()
      : recording_(test::simulated({})),
        model_(start_model(recording_, Column::y).model) {}
  // Of a model that explains much.
  [[nodiscard]] ModelReport report(ExplainResult explanation) const {
    ModelReport out{recording_, model_, compare(recording_, model_),
                    std::move(explanation)};
    out.comparison.quality.fit_percent = 80;
    return out;
  }

  Recording recording_;
  Model model_;
};

TEST_F(ModelHeadline, CallsNoModelCompleteThatLacksAStem) {
  ExplainResult result;
  result.explained = true;
  ModelReport told = report(result);
  EXPECT_EQ(model_headline(told), "The model is complete: nothing is missing.");
  told.lacks_stem = true;
  EXPECT_EQ(model_headline(told),
            "The verdict on the valve finds a stem that does not follow u, and the model "
            "has none.");
  EXPECT_EQ(model_verdict(told).find("good"), std::string::npos);
}

TEST_F(ModelHeadline, SaysThatNothingButTheControllerMovesU) {
  ExplainResult result;
  result.left_to_controller = true;
  EXPECT_EQ(
      model_headline(report(result)),
      "Little but the controller moves u: what the process makes of it is not told.");
}

}  // namespace
}  // namespace workbench
