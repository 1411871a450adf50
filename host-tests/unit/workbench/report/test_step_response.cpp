#include <gtest/gtest.h>

#include <cmath>

#include "workbench/report/step_response.hpp"

namespace workbench {
namespace {

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

TEST(ReportStepResponse, TellsWhetherTheModelMovesAsTheStemDoes) {
  Simulation s = triangle();
  EXPECT_NEAR(stem_scale(known_model().model, s).r_squared, 1, 1e-9);
  EXPECT_TRUE(stem_scale(known_model().model, s).is_told());
  s.stem = s.u;
  for (std::size_t i = 0; i < s.stem.size(); ++i) s.stem[i] += i < 100 ? 0 : 40;
  const StemScale scale = stem_scale(known_model().model, s);
  EXPECT_GT(scale.r_squared, 0);
  EXPECT_LT(scale.r_squared, 0.1);
  EXPECT_FALSE(scale.is_told());
}

TEST(ReportStepResponse, OfAKnownProcess) {
  const StepResponse step = true_step({2, 10, 0, 1, false}, 0.5, 60);
  EXPECT_EQ(step.y.front(), 0);
  EXPECT_NEAR(step.y[22], 2 * (1 - std::exp(-1.0)), 1e-9);  // 1 s dead time + 10 s
  EXPECT_NEAR(step.y.back(), 2, 0.01);
}

}  // namespace
}  // namespace workbench
