// No verdict stands against its own figures: laws over windows cut anywhere from
// simulated loops of any family, with what a historian or a faulty sensor does to some.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using Identifier = ident::Identifier<double, ident::kLargeWindow>;
using Identification = ident::Identification<double>;
using Estimate = ident::Estimate<double>;
using ident::Reason;
using ident::Verdict;

/// Coarser numbers, as a historian stores them; 0 leaves all as it is.
std::vector<double> stored(std::span<const double> values, int levels) {
  std::vector<double> out(values.begin(), values.end());
  if (levels == 0 || out.empty()) return out;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double step = (*high - *low) / levels;
  if (!(step > 0)) return out;
  for (double& value : out) value = std::round(value / step) * step;
  return out;
}

bool ordered(const Estimate& e) {
  return !e.known ||
         (std::isfinite(e.value) && e.low <= e.value && e.value <= e.high && e.low >= 0);
}

bool excludes(const Estimate& other, double band) {
  return other.high < band;
}

void hold(const Identification& found) {
  const Estimate& up = found.stick_band.ascending;
  const Estimate& down = found.stick_band.descending;
  const bool fault =
      found.verdict == Verdict::kStiction || found.verdict == Verdict::kBacklash;
  for (const Estimate* e :
       {&up, &down, &found.slip_jump.ascending, &found.slip_jump.descending}) {
    RC_ASSERT(ordered(*e));
    RC_ASSERT(fault || !e->known);
  }
  if (found.verdict == Verdict::kNoStiction) {
    // More than two cycles, and the valve cannot hide a band that matters.
    RC_ASSERT(found.evidence.reversals > 4 || found.reason == Reason::kBandDoesNotMatter);
  }
  if (!fault) return;
  RC_ASSERT(up.known && down.known);
  switch (found.reason) {
    case Reason::kSticksBothStrokes:
      RC_ASSERT(up.low > 0 && down.low > 0);
      break;
    case Reason::kSticksAscending:
      RC_ASSERT(up.low > 0 && excludes(down, up.value));
      break;
    case Reason::kSticksDescending:
      RC_ASSERT(down.low > 0 && excludes(up, down.value));
      break;
    default:
      break;
  }
  // The fitted valve's bands are told only where it explains something.
  if (found.reason != Reason::kSticksUnderLoad) {
    RC_ASSERT(found.fit_valve_percent > 0);
    RC_ASSERT(found.evidence.fit_percent > 0);
  }
}

RC_GTEST_PROP(VerdictLaws, StandWithTheirFigures, ()) {
  const auto scenarios = workbench::scenarios();
  const auto& scenario = scenarios[*rc::gen::inRange<std::size_t>(0, scenarios.size())];
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  const auto loop = workbench::simulate(scenario.name, seed);
  const std::size_t size = loop->u.size();
  const std::size_t length = *rc::gen::inRange<std::size_t>(
      std::min<std::size_t>(120, size - 1), std::min<std::size_t>(1200, size));
  const std::size_t first = *rc::gen::inRange<std::size_t>(0, size - length);
  const int levels = *rc::gen::element(0, 0, 12, 40, 200);
  RC_LOG() << scenario.name << ' ' << seed << ", " << length << " from " << first << ", "
           << levels << " levels\n";
  const auto part = [&](const std::vector<double>& values) {
    return std::span<const double>(values).subspan(first, length);
  };
  static const auto identifier = std::make_unique<Identifier>();
  hold(identifier->run(part(loop->u), stored(part(loop->y), levels), part(loop->sp)));
}

}  // namespace
