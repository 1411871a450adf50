// A process that is slower one way than the other, and a valve that sticks, both told
// from the same few turns of u.
#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/valve/directional_lag.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

// u among a few levels, and y behind a valve and a lag for either direction.
class FewTurns : public testing::Test {
 protected:
  void make(const ValveFriction<double>& friction, double rising, double falling) {
    constexpr double kLevels[] = {0.3, 0.7, 0.2, 0.9, 0.4, 0.6, 0};
    test::Random random(1);
    StickSlipValve<double> valve(friction, kLevels[0]);
    double state = kLevels[0];
    for (const double level : kLevels) {
      for (int k = 0; k < 90; ++k) {
        u.push_back(level);
        y.push_back(state + 0.01 * test::normal(random));
        const double goal = valve.step(level);
        state = goal + (state - goal) * (goal > state ? rising : falling);
      }
    }
    const double n = static_cast<double>(y.size());
    const double mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
    for (double& value : y) value = (value - mean) / 0.25;
    x.resize(y.size());
    scratch.resize(y.size());
    SearchWindow<double> window;
    window.u = u;
    window.y = y;
    window.period = 180;
    window.swing = 0.5;
    search->start(window, x, scratch, *stems);
    while (!search->step(1000)) {
    }
  }

  [[nodiscard]] double error_of_lag(int slice = 1000) {
    DirectionalLag<double> lag;
    lag.start(search->best(ValveForm::kLinear), search->window());
    while (!lag.step(*search, slice)) {
    }
    return lag.error();
  }
  [[nodiscard]] double error_of(ValveForm form) const {
    return search->best(form).fit.error;
  }

  std::vector<double> u;
  std::vector<double> y;
  std::vector<double> x;
  std::vector<double> scratch;
  std::unique_ptr<ValveSearch<double>> search = std::make_unique<ValveSearch<double>>();
  std::unique_ptr<ValveSearch<double>::Stems> stems =
      std::make_unique<ValveSearch<double>::Stems>();
};

TEST_F(FewTurns, OfAProcessThatIsSlowerDownAreItsOwn) {
  make({}, 0.9, 0.96);
  EXPECT_LT(3 * error_of_lag(), error_of(ValveForm::kLinear));
  EXPECT_LT(error_of_lag(), error_of(ValveForm::kMixed));
  EXPECT_LT(error_of_lag() / static_cast<double>(y.size()), 1.2 * 0.04 * 0.04) << "noise";
}

TEST_F(FewTurns, OfAStemThatSticksAreNotThatProcess) {
  make({0.05, 0.1, 0.1, SlipMotion::kSlides}, 0.94, 0.94);
  EXPECT_GT(error_of_lag(), 1.5 * error_of(ValveForm::kMixed));
}

TEST_F(FewTurns, AreWeighedInSlicesOfAnyLength) {
  make({}, 0.9, 0.96);
  EXPECT_EQ(error_of_lag(1), error_of_lag());
}

TEST_F(FewTurns, OfAnIntegratorAreNotAsked) {
  make({}, 0.9, 0.9);
  ValveModel<double> integrating = search->best(ValveForm::kLinear);
  integrating.poles.slow = 1;
  DirectionalLag<double> lag;
  lag.start(integrating, search->window());
  EXPECT_TRUE(lag.step(*search, 1));
  EXPECT_EQ(lag.error(), 0);
}

}  // namespace
}  // namespace ident
