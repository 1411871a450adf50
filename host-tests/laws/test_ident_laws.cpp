// Laws of the identification's parts, over random inputs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ident/base/nnls.hpp"
#include "ident/signal/reversals.hpp"
#include "ident/signal/sample_window.hpp"
#include "ident/two_path/two_path_model.hpp"
#include "ident/valve/stick_slip_valve.hpp"
#include "support/ident/two_path_reference.hpp"

namespace ident {
namespace {

// Multiples of 1/64, so that sums and differences are exact.
double any_level(int low, int high) {
  return *rc::gen::inRange(low * 64, high * 64) / 64.0;
}

std::vector<double> any_signal(int most) {
  const int n = *rc::gen::inRange(1, most);
  std::vector<double> u;
  for (int t = 0; t < n; ++t) {
    u.push_back(any_level(-4, 4));
  }
  return u;
}

ValveFriction<double> any_friction() {
  return {
      any_level(0, 3), any_level(0, 3), any_level(0, 3),
      *rc::gen::element(SlipMotion::kSlides, SlipMotion::kStops, SlipMotion::kResticks)};
}

std::vector<double> positions(const ValveFriction<double>& friction, double start,
                              const std::vector<double>& u) {
  StickSlipValve<double> valve(friction, start);
  std::vector<double> x;
  for (const double value : u) {
    x.push_back(valve.step(value));
  }
  return x;
}

RC_GTEST_PROP(ValveLaws, NeverLeavesItsBandAroundU, ()) {
  const auto friction = any_friction();
  const auto u = any_signal(200);
  const auto x = positions(friction, u[0], u);
  for (std::size_t t = 0; t < u.size(); ++t) {
    RC_ASSERT(u[t] - x[t] <= friction.deadband / 2 + friction.slip_ascending);
    RC_ASSERT(x[t] - u[t] <= friction.deadband / 2 + friction.slip_descending);
  }
}

RC_GTEST_PROP(ValveLaws, ShiftsAndScalesWithU, ()) {
  const auto friction = any_friction();
  const auto u = any_signal(200);
  const double start = any_level(-4, 4);
  const auto x = positions(friction, start, u);
  std::vector<double> moved;
  for (const double value : u) {
    moved.push_back(4 * value + 8);
  }
  const ValveFriction<double> scaled{4 * friction.deadband, 4 * friction.slip_ascending,
                                     4 * friction.slip_descending, friction.motion};
  const auto x_moved = positions(scaled, 4 * start + 8, moved);
  for (std::size_t t = 0; t < u.size(); ++t) {
    RC_ASSERT(x_moved[t] == 4 * x[t] + 8);
  }
}

RC_GTEST_PROP(ValveLaws, IsItsOwnMirrorImage, ()) {
  const auto friction = any_friction();
  auto u = any_signal(200);
  const auto x = positions(friction, 0, u);
  for (double& value : u) {
    value = -value;
  }
  const ValveFriction<double> mirrored{friction.deadband, friction.slip_descending,
                                       friction.slip_ascending, friction.motion};
  const auto x_mirrored = positions(mirrored, 0, u);
  for (std::size_t t = 0; t < u.size(); ++t) {
    RC_ASSERT(x_mirrored[t] == -x[t]);
  }
}

// A stem that moves does so in the direction in which u pulls it.
RC_GTEST_PROP(ValveLaws, MovesTowardsU, ()) {
  const auto friction = any_friction();
  const auto u = any_signal(200);
  const auto x = positions(friction, u[0], u);
  for (std::size_t t = 1; t < u.size(); ++t) {
    RC_ASSERT((x[t] - x[t - 1]) * (u[t] - x[t - 1]) >= 0);
  }
}

RC_GTEST_PROP(ReversalLaws, AlternateBetweenExtremesFarEnoughApart, ()) {
  const auto u = any_signal(300);
  const double threshold = any_level(0, 2) + 1.0 / 128;
  std::vector<unsigned char> ascending(u.size());
  std::vector<Reversal<double>> found(u.size());
  found.resize(mark_directions<double>(u, threshold, ascending, found));
  for (std::size_t k = 0; k < found.size(); ++k) {
    RC_ASSERT(found[k].value == u[found[k].index]);
    RC_ASSERT((ascending[found[k].index] != 0) == found[k].maximum);
    if (k > 0) {
      RC_ASSERT(found[k].maximum != found[k - 1].maximum);
      RC_ASSERT(found[k].index > found[k - 1].index);
      RC_ASSERT(std::abs(found[k].value - found[k - 1].value) > threshold);
      for (std::size_t t = found[k - 1].index + 1; t <= found[k].index; ++t) {
        RC_ASSERT((ascending[t] != 0) == found[k].maximum);
        const bool within =
            found[k].maximum ? u[t] <= found[k].value : u[t] >= found[k].value;
        RC_ASSERT(within);
      }
    }
  }
}

RC_GTEST_PROP(ReversalLaws, OfTheNegativeAreTheSame, ()) {
  auto u = any_signal(300);
  std::vector<unsigned char> ascending(u.size());
  std::vector<Reversal<double>> found(u.size());
  std::vector<Reversal<double>> negative(u.size());
  found.resize(mark_directions<double>(u, 1.0, ascending, found));
  for (double& value : u) {
    value = -value;
  }
  negative.resize(mark_directions<double>(u, 1.0, ascending, negative));
  RC_ASSERT(found.size() == negative.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    RC_ASSERT(found[k].index == negative[k].index);
    RC_ASSERT(found[k].maximum != negative[k].maximum);
  }
}

// Whatever comes: every sample is accepted or counted, and nothing is lost or made up
// without being counted.
RC_GTEST_PROP(WindowLaws, AccountForEverySample, ()) {
  SampleWindow<float, 16> window(1000, *rc::gen::inRange(0, 6));
  const int n = *rc::gen::inRange(1, 300);
  std::int64_t t = *rc::gen::inRange(-1'000'000, 1'000'000);
  for (int k = 0; k < n; ++k) {
    t += *rc::gen::weightedElement<std::int64_t>(
        {{20, 1000}, {3, 900}, {3, 1200}, {2, 0}, {2, 2500}, {1, 9000}, {1, -4000}});
    Sample<float> sample;
    sample.t_us = t;
    sample.u = *rc::gen::weightedElement<float>({{30, 1.0F}, {1, NAN}, {1, INFINITY}});
    const std::size_t before = window.size();
    const std::uint64_t restarts = window.counters().restarts;
    const std::uint64_t filled = window.counters().filled;
    const PushResult result = window.push(sample);
    const bool entered = result == PushResult::kAccepted || result == PushResult::kGap;
    const std::size_t made = static_cast<std::size_t>(window.counters().filled - filled);
    if (window.counters().restarts > restarts) {
      RC_ASSERT(result == PushResult::kGap);
      RC_ASSERT(window.size() == 1U);
    } else if (entered) {
      RC_ASSERT(window.size() == std::min<std::size_t>(before + made + 1, 16));
      RC_ASSERT(std::abs(window.newest_us() - t) <= window.period_us() / 2);
    } else {
      RC_ASSERT(window.size() == before);
      RC_ASSERT(made == 0U);
    }
  }
  const WindowCounters& c = window.counters();
  RC_ASSERT(c.accepted + c.repeats + c.non_finite + c.time_back ==
            static_cast<std::uint64_t>(n));
}

// The conditions of Karush, Kuhn and Tucker, for sizes beyond any exhaustive search.
RC_GTEST_PROP(NnlsLaws, MeetTheOptimalityConditions, ()) {
  const int n = *rc::gen::inRange(1, kMaxUnknowns + 1);
  const int free = *rc::gen::inRange(0, n + 1);
  Eigen::MatrixXd a(n + 5, n);
  Eigen::VectorXd y(n + 5);
  for (double& value : a.reshaped()) {
    value = any_level(-2, 2);
  }
  for (double& value : y) {
    value = any_level(-2, 2);
  }
  const Square<double> q = a.transpose() * a;
  const Column<double> c = a.transpose() * y;
  const UnknownSet all = (UnknownSet{1} << n) - 1;
  const UnknownSet constrained = all & ~((UnknownSet{1} << free) - 1);
  NonNegativeLeastSquares<double> nnls;
  Column<double> z;
  RC_ASSERT(nnls.solve(q, c, constrained, z));
  const Eigen::VectorXd gradient = c - q * z;
  for (int i = 0; i < n; ++i) {
    const double scale = 1e-7 * std::sqrt(q(i, i)) * (1 + y.norm());
    if (i >= free) {
      RC_ASSERT(z(i) >= 0);
      RC_ASSERT(gradient(i) <= scale);
    }
    if (i < free || z(i) > 0) {
      RC_ASSERT(std::abs(gradient(i)) <= scale);
    }
  }
}

// Stable by the test means that an impulse dies out.
RC_GTEST_PROP(ProcessLaws, AStableProcessForgets, ()) {
  Process<double> process;
  process.na = *rc::gen::inRange(1, kMaxNa + 1);
  for (int i = 0; i < process.na; ++i) {
    process.a[i] = any_level(-2, 2);
  }
  // Halving every root ends inside the circle.
  while (!is_stable(process, 0.05)) {
    for (int i = 0; i < process.na; ++i) {
      process.a[i] = std::ldexp(process.a[i], -i - 1);
    }
  }
  const std::vector<double> x(1000, 0.0);
  std::vector<double> y(1000);
  const double impulse = 1;
  test::free_run<double>(process, x, {&impulse, 1}, y);
  RC_ASSERT(std::abs(y.back()) < 1e-9);
}

}  // namespace
}  // namespace ident
