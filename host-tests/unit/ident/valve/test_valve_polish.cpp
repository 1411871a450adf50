// The polish against errors with a known lowest point.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "ident/valve/valve_polish.hpp"

namespace ident {
namespace {

using Model = ValveModel<double>;
using Error = std::function<double(const Model&)>;

double square(double value) {
  return value * value;
}

// Lowest at deadband 0.3, slips 0.2 and 0.1, time constant 20, whatever the start.
double friction_bowl(const Model& m) {
  const double slow =
      m.poles.slow < 1 ? std::log(time_constant_of(m.poles.slow) / 20) : 5;
  return square(m.friction.deadband - 0.3) + square(m.friction.slip_ascending - 0.2) +
         square(m.friction.slip_descending - 0.1) + 0.01 * square(slow);
}

Model polished(ValveForm form, Model from, const Error& error,
               int* evaluations = nullptr) {
  SearchWindow<double> window;
  window.swing = 1;
  window.period = 50;
  from.known = true;
  from.fit.error = error(from);
  ValvePolish<double> polish;
  polish.start(form, from, window, ValvePolish<double>::kEvaluations,
               ValvePolish<double>::kFarJumps);
  int count = 0;
  while (!polish.done()) {
    Model model = polish.propose();
    model.fit.error = error(model);
    polish.report(model);
    ++count;
  }
  if (evaluations != nullptr) {
    *evaluations = count;
  }
  return polish.best();
}

Model lagged(double time_constant) {
  Model model;
  model.poles.slow = pole_of(time_constant);
  return model;
}

TEST(ValvePolish, FindsTheLowestPoint) {
  int evaluations = 0;
  const Model best = polished(ValveForm::kMixed, lagged(60), friction_bowl, &evaluations);
  EXPECT_NEAR(best.friction.deadband, 0.3, 0.01);
  EXPECT_NEAR(best.friction.slip_ascending, 0.2, 0.01);
  EXPECT_NEAR(best.friction.slip_descending, 0.1, 0.01);
  EXPECT_NEAR(time_constant_of(best.poles.slow), 20, 2);
  EXPECT_LE(evaluations, ValvePolish<double>::kEvaluations);
}

TEST(ValvePolish, KeepsToItsForm) {
  const Model linear = polished(ValveForm::kLinear, lagged(60), friction_bowl);
  EXPECT_EQ(linear.friction.stick_ascending(), 0);
  EXPECT_EQ(linear.friction.stick_descending(), 0);
  const Model backlash = polished(ValveForm::kBacklash, lagged(60), friction_bowl);
  EXPECT_GT(backlash.friction.deadband, 0.2);
  EXPECT_EQ(backlash.friction.slip_ascending, 0);
  const Model ascending = polished(ValveForm::kAscending, lagged(60), friction_bowl);
  EXPECT_EQ(ascending.friction.deadband, 0);
  EXPECT_EQ(ascending.friction.slip_descending, 0);
  EXPECT_NEAR(ascending.friction.slip_ascending, 0.2, 0.01);
  const Model symmetric = polished(ValveForm::kSymmetric, lagged(60), friction_bowl);
  EXPECT_DOUBLE_EQ(symmetric.friction.slip_ascending, symmetric.friction.slip_descending);
}

TEST(ValvePolish, StaysWithinItsBounds) {
  const Model best = polished(ValveForm::kMixed, lagged(60), [](const Model& m) {
    EXPECT_GE(m.friction.deadband, 0);
    EXPECT_GE(m.friction.slip_ascending, 0);
    EXPECT_GE(m.friction.slip_descending, 0);
    EXPECT_LE(m.poles.fast, m.poles.slow);
    return 1 + m.friction.deadband + m.friction.slip_ascending +
           m.friction.slip_descending + m.poles.slow;
  });
  EXPECT_EQ(best.friction.deadband, 0);
}

TEST(ValvePolish, LeavesAnIntegratorAnIntegrator) {
  Model integrating;
  integrating.poles.slow = 1;
  EXPECT_EQ(polished(ValveForm::kMixed, integrating, friction_bowl).poles.slow, 1);
}

TEST(ValvePolish, IsRepeatable) {
  const Model one = polished(ValveForm::kMixed, lagged(5), friction_bowl);
  const Model other = polished(ValveForm::kMixed, lagged(5), friction_bowl);
  EXPECT_EQ(one.friction.deadband, other.friction.deadband);
  EXPECT_EQ(one.fit.error, other.fit.error);
}

}  // namespace
}  // namespace ident
