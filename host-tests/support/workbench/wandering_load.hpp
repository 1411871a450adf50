// A process that is moved by hand under a load that wanders further than u moves it.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench::test {

struct WanderingLoad {
  std::size_t samples = 1200;
  double lag = 10;         ///< of the process, in samples
  std::size_t delay = 0;   ///< samples
  double load = 0.3;       ///< standard deviation of each of its steps, units of y
  double column_gain = 0;  ///< by which a recorded column, which wanders, too, moves u
  unsigned seed = 1;
};

/// u rests on one of its levels for 20 to 60 samples, process gain 1, sample period 1 s.
/// The column is "column", in `loads`.
inline Recording recorded_under(const WanderingLoad& of) {
  std::mt19937 random(of.seed);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> rest(20, 60);
  Recording out;
  out.name = "wandering.csv";
  out.period_s = 1;
  double u = 50;
  double y = 0;
  double load = 0;
  double column = 0;
  int left = 0;
  Load recorded{"column", "", {}};
  const double keep = std::exp(-1 / of.lag);
  for (std::size_t k = 0; k < of.samples; ++k) {
    if (left-- == 0) {
      u = 50 + 3 * normal(random);
      left = rest(random);
    }
    out.t.push_back(static_cast<double>(k));
    out.u.push_back(u);
    const double before = k > of.delay ? out.u[k - 1 - of.delay] : 50;
    y = keep * y + (1 - keep) * (before - 50 + of.column_gain * column);
    load = 0.998 * load + of.load * normal(random);
    column = 0.995 * column + 0.1 * normal(random);
    recorded.values.push_back(column);
    out.y.push_back(50 + y + load + 0.02 * normal(random));
  }
  out.loads.push_back(std::move(recorded));
  return out;
}

}  // namespace workbench::test
