#include "workbench/model/fit/stem_search.hpp"

#include <algorithm>
#include <memory>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"

namespace workbench {

std::vector<SeenStem> stems_seen(std::span<const double> u, std::span<const double> y,
                                 double period_s, bool later_cycles, const Work& work) {
  using Identifier = ident::Identifier<double, ident::kLargeWindow>;
  const std::size_t n = std::min(u.size(), Identifier::kCapacity);
  const auto identifier = std::make_unique<Identifier>();
  constexpr int kBudget = 200;  // some 10 ms of a desk
  ident::WindowOptions options;
  options.verdict_only = true;
  options.later_cycles = later_cycles;
  identifier->start(u.first(n), y.first(n), {}, 0, options);
  while (!identifier->step(kBudget)) work.check();
  const auto& found = identifier->result();
  const ident::ValveFriction<double>& friction = found.valve.friction;
  if (!found.valve.known ||
      friction.stick_ascending() + friction.stick_descending() <= 0) {
    return {};
  }
  std::vector<double> stem(n);
  identifier->stem_positions(stem);
  const double sample_s = period_s * found.decimation;
  const double slow = found.valve.poles.slow;
  return {{friction.deadband, friction.slip_ascending, friction.slip_descending,
           stem[0] - u[0], slow < 1 ? sample_s * ident::time_constant_of(slow) : 0}};
}

}  // namespace workbench
