// The polish against errors with a known lowest point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

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

// The directions of a form, from either side of the lowest point: what it leaves free is
// found, the rest stays.
TEST(ValvePolish, FindsTheLowestPointOfEveryForm) {
  struct Lowest {
    ValveForm form;
    double deadband, ascending, descending;
  };
  // Of a symmetric valve the slips are alike: half way between those of the bowl.
  constexpr Lowest kLowest[] = {{ValveForm::kLinear, 0, 0, 0},
                                {ValveForm::kBacklash, 0.3, 0, 0},
                                {ValveForm::kAscending, 0, 0.2, 0},
                                {ValveForm::kDescending, 0, 0, 0.1},
                                {ValveForm::kSymmetric, 0.3, 0.15, 0.15},
                                {ValveForm::kMixed, 0.3, 0.2, 0.1}};
  for (const bool remembers : {false, true}) {
    for (const Lowest& lowest : kLowest) {
      for (const double share : {0.0, 2.0}) {
        for (const double time_constant : {5.0, 60.0}) {
          Model from = lagged(time_constant);
          from.friction = {share * lowest.deadband, share * lowest.ascending,
                           share * lowest.descending, SlipMotion::kStops};
          from.start_known = remembers;
          const ValveFriction<double> found =
              polished(lowest.form, from, friction_bowl).friction;
          EXPECT_NEAR(found.deadband, lowest.deadband, 0.015);
          EXPECT_NEAR(found.slip_ascending, lowest.ascending, 0.015);
          EXPECT_NEAR(found.slip_descending, lowest.descending, 0.015);
          EXPECT_EQ(found.motion, SlipMotion::kStops);
          const auto stays = [](double value, double at) {
            return at != 0 || value == 0;
          };
          EXPECT_TRUE(stays(found.deadband, lowest.deadband));
          EXPECT_TRUE(stays(found.slip_ascending, lowest.ascending));
          EXPECT_TRUE(stays(found.slip_descending, lowest.descending));
        }
      }
    }
  }
}

TEST(ValvePolish, FindsBothTimeConstants) {
  const auto bowl = [](const Model& m) {
    return square(std::log(time_constant_of(m.poles.slow) / 20)) +
           square(std::log(time_constant_of(m.poles.fast) / 4));
  };
  for (const ValveForm form : {ValveForm::kLinear, ValveForm::kMixed}) {
    for (const double from : {6.0, 80.0}) {
      const Model best = polished(form, lagged(from), bowl);
      EXPECT_NEAR(time_constant_of(best.poles.slow), 20, 1);
      EXPECT_NEAR(time_constant_of(best.poles.fast), 4, 1);
    }
  }
}

// A stem that starts elsewhere is found with the valve, in a valley in which the data
// hardly tell deadband from slips and the start goes along.
TEST(ValvePolish, FindsTheStartOfTheStem) {
  for (const double along : {0.5, -0.5}) {
    const auto valley = [&](const Model& m) {
      const double band = m.friction.stick_ascending() - 0.5;
      const double other = m.friction.stick_descending() - 0.4;
      const double trade = m.friction.deadband - 0.3;
      const double start = m.start - 0.6 - along * trade;
      return 1e-6 + square(band) + square(other) + square(start) + 0.01 * square(trade);
    };
    Model from = lagged(20);
    from.friction = {0.1, 0.3, 0.2, SlipMotion::kResticks};
    from.start_known = true;
    from.start = 0.45;
    const Model best = polished(ValveForm::kMixed, from, valley);
    EXPECT_NEAR(best.friction.stick_ascending(), 0.5, 0.012);
    EXPECT_NEAR(best.friction.stick_descending(), 0.4, 0.012);
    EXPECT_NEAR(best.friction.deadband, 0.3, 0.06);
    EXPECT_NEAR(best.start, 0.6 + along * (best.friction.deadband - 0.3), 0.012);
    EXPECT_TRUE(best.start_known);
  }
}

// What a polish proposes where nothing is better than its start.
struct Proposed {
  std::vector<Model> models;
  Model from;

  Proposed(ValveForm form, bool remembers, double swing, double jumps,
           int evaluations = ValvePolish<double>::kEvaluations) {
    SearchWindow<double> window;
    window.swing = swing;
    window.period = 50;
    from = lagged(20);
    from.known = true;
    from.friction = {swing, swing, swing, SlipMotion::kStops};
    from.start_known = remembers;
    from.start = 3 * swing;
    from.fit.error = 1;
    ValvePolish<double> polish;
    polish.start(form, from, window, evaluations, jumps);
    while (!polish.done()) {
      models.push_back(polish.propose());
      Model worse = models.back();
      worse.fit.error = 2;
      polish.report(worse);
    }
    EXPECT_EQ(polish.best().fit.error, 1);
    EXPECT_EQ(polish.best().friction, from.friction);
  }
  [[nodiscard]] double move(std::size_t k) const {
    const ValveFriction<double>& f = models[k].friction;
    return std::max({std::abs(f.deadband - from.friction.deadband),
                     std::abs(f.slip_ascending - from.friction.slip_ascending),
                     std::abs(f.slip_descending - from.friction.slip_descending),
                     std::abs(models[k].start - from.start)});
  }
  // Only a jump moves the valve along no direction: deadband, slips and start at once.
  [[nodiscard]] bool jumps(std::size_t k) const {
    const ValveFriction<double>& f = models[k].friction;
    const double a = std::abs(f.slip_ascending - from.friction.slip_ascending);
    const double d = std::abs(f.deadband - from.friction.deadband);
    return a > 0 && d > 0 && std::abs(a - d) > 1e-9 && models[k].start != from.start;
  }
  [[nodiscard]] double farthest(std::size_t first, std::size_t last) const {
    double most = 0;
    for (std::size_t k = first; k < last; ++k) {
      most = jumps(k) ? std::max(most, move(k)) : most;
    }
    return most;
  }
};

// Every other proposal of a mixed valve, and of one that remembers; shorter and shorter.
TEST(ValvePolish, JumpsLessAndLessFar) {
  for (const double swing : {1.0, 0.2}) {
    for (const double far : {0.12, 0.02}) {
      const Proposed p(ValveForm::kMixed, true, swing, far);
      ASSERT_GT(p.models.size(), 180U);
      for (std::size_t k = 0; k < p.models.size(); ++k) {
        EXPECT_EQ(p.jumps(k), k % 2 == 0) << k;
        // The step of one coordinate and of the trade between them.
        const double left = 1 - static_cast<double>(k) / 200;
        EXPECT_LE(p.move(k), 2 * swing * (0.005 + far * left * left) + 1e-12);
      }
      EXPECT_GT(p.farthest(0, 60), 0.9 * swing * far);
      EXPECT_LT(p.farthest(140, 180), 0.5 * p.farthest(0, 60));
      EXPECT_GT(p.farthest(140, 180), 0.005 * swing);
    }
  }
}

TEST(ValvePolish, JumpsOnlyWhereAValveLosesStep) {
  const auto jumps = [](ValveForm form, bool remembers) {
    const Proposed p(form, remembers, 1, 0.12);
    int count = 0;
    for (std::size_t k = 0; k < p.models.size(); ++k) {
      count += p.jumps(k) ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(jumps(ValveForm::kSymmetric, false), 0);
  EXPECT_GT(jumps(ValveForm::kSymmetric, true), 50);
  EXPECT_GT(jumps(ValveForm::kMixed, true), 50);
  EXPECT_EQ(jumps(ValveForm::kLinear, true), 0);
}

// Steps along single directions: as long at first as the jumps, three hundredths of the
// swing at most, both ways, and halved until a thousandth.
TEST(ValvePolish, StepsBothWaysAndHalves) {
  for (const double swing : {1.0, 0.2}) {
    for (const double far : {0.12, 0.02}) {
      const Proposed p(ValveForm::kBacklash, false, swing, far);
      const double step = swing * std::min(far, 0.03);
      const auto deadband = [&](std::size_t k) {
        return p.models[k].friction.deadband - swing;
      };
      EXPECT_NEAR(deadband(0), step, 1e-12);
      EXPECT_NEAR(deadband(1), -step, 1e-12);
      double least = step;
      std::vector<double> slow;
      std::vector<double> fast;
      for (std::size_t k = 0; k < p.models.size(); ++k) {
        EXPECT_LE(std::abs(deadband(k)), step + 1e-12);
        least = deadband(k) > 0 ? std::min(least, deadband(k)) : least;
        slow.push_back(time_constant_of(p.models[k].poles.slow));
        fast.push_back(time_constant_of(p.models[k].poles.fast));
      }
      EXPECT_LT(least, 0.0015 * swing);
      EXPECT_GE(least, 0.0007 * swing);
      EXPECT_LT(p.models.size(), 40U);
      // A factor of a time constant.
      EXPECT_NEAR(*std::max_element(slow.begin(), slow.end()), 20 * std::exp(0.4), 1e-6);
      EXPECT_NEAR(*std::min_element(slow.begin(), slow.end()), 20 * std::exp(-0.4), 1e-6);
      EXPECT_NEAR(*std::max_element(fast.begin(), fast.end()), 0.1 * std::exp(0.8), 1e-6);
    }
  }
}

TEST(ValvePolish, EndsWithItsEvaluations) {
  EXPECT_EQ(Proposed(ValveForm::kMixed, true, 1, 0.12, 37).models.size(), 37U);
}

// Thirty periods are as good as an integrator, and it is left to others to be one.
TEST(ValvePolish, KeepsTimeConstantsBelowThatOfAnIntegrator) {
  const auto slower = [](const Model& m) { return 2 - m.poles.slow; };
  const double slow =
      time_constant_of(polished(ValveForm::kLinear, lagged(400), slower).poles.slow);
  EXPECT_NEAR(slow, 0.98 * 30 * 50, 1);
  Model beyond = lagged(4000);
  beyond.poles.fast = pole_of(3000.0);
  const auto worse = [&](const Model& m) {
    EXPECT_LT(m.poles.slow, 1);
    EXPECT_LE(m.poles.fast, m.poles.slow);
    return m.known ? 1.0 : 2.0;
  };
  polished(ValveForm::kMixed, beyond, worse);
  // As short as none at all.
  const auto faster = [](const Model& m) { return 1 + m.poles.slow + m.poles.fast; };
  const Model none = polished(ValveForm::kLinear, lagged(5), faster);
  EXPECT_EQ(none.poles.slow, 0);
  EXPECT_EQ(none.poles.fast, 0);
}

}  // namespace
}  // namespace ident
