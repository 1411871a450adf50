#include <gtest/gtest.h>

#include <vector>

#include "ident/two_path/path_simulation.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using test::Random;

// y(t) = 0.5·y(t−1) + x(t−1), x = 1 2 3 fixed, 1 before; initial addition 4:
// ŷ = 1 + 4, 2.5 + 1, 1.75 + 2.
TEST(PathSimulation, FollowsTheHandWorkedSequence) {
  test::Window w;
  w.u = {0, 0, 0};
  w.y = {5, 3, 3};
  w.ascending = {1, 1, 1};
  TwoPathModel<double> model;
  model.process.a = {-0.5};
  model.process.b = {1};
  std::vector<double> y(3);
  const double error =
      simulate_paths<double>(w.view(), std::vector<double>{1, 2, 3}, model, {4}, y);
  EXPECT_EQ(y, (std::vector<double>{5, 3.5, 3.75}));
  EXPECT_DOUBLE_EQ(error, 0.25 + 0.5625);
}

class PathSimulationOfRandomModels : public testing::Test {
 protected:
  void draw(Random& random) {
    window_ = test::random_window(random, 80);
    const int na = 1 + static_cast<int>(random() % kMaxNa);
    const int nb = 1 + static_cast<int>(random() % kMaxNb);
    model_ = test::random_model(
        random, 1 + static_cast<int>(random() % 4), 1 + static_cast<int>(random() % 4),
        test::random_process(random, na, nb, static_cast<int>(random() % (kMaxNk + 1))));
    initial_ = {};
    for (int i = 0; i < na; ++i) {
      initial_[static_cast<std::size_t>(i)] = test::normal(random);
    }
  }
  [[nodiscard]] std::vector<double> at_once() const {
    std::vector<double> y(window_.u.size());
    simulate_paths<double>(window_.view(), {}, model_, initial_, y);
    return y;
  }

  test::Window window_;
  TwoPathModel<double> model_;
  InitialState<double> initial_{};
};

// Free run from the same state; x is held before the first sample in both.
TEST_F(PathSimulationOfRandomModels, IsAFreeRun) {
  Random random(22);
  for (int k = 0; k < 50; ++k) {
    draw(random);
    std::vector<double> x(window_.u.size());
    std::vector<double> y(window_.u.size());
    test::valve_positions<double>(model_, window_.u, window_.ascending, x);
    test::free_run<double>(
        model_.process, x,
        std::span(initial_).first(static_cast<std::size_t>(model_.process.na)), y);
    const std::vector<double> found = at_once();
    for (std::size_t t = 0; t < y.size(); ++t) {
      ASSERT_NEAR(found[t], y[t], 1e-12);
    }
  }
}

TEST_F(PathSimulationOfRandomModels, IsTheSameInPieces) {
  Random random(27);
  for (int piece = 1; piece < 40; ++piece) {
    draw(random);
    const std::vector<double> whole = at_once();
    std::vector<double> y(whole.size());
    PathSimulation<double> simulation;
    simulation.start(window_.view(), {}, model_, initial_, y);
    double error = 0;
    while (!simulation.step(piece)) {
    }
    for (std::size_t t = 0; t < y.size(); ++t) {
      error += (window_.y[t] - y[t]) * (window_.y[t] - y[t]);
    }
    EXPECT_EQ(y, whole);
    EXPECT_DOUBLE_EQ(simulation.error(), error);
  }
}

}  // namespace
}  // namespace ident
