#include <cstdlib>
#include <string>

#include "config/gateway.hpp"
#include "feed.hpp"

namespace fuzz {
namespace {

void require(bool kept) {
  if (!kept) std::abort();
}

void require_valid(const config::Gateway& gateway) {
  require(!gateway.loops.empty() && gateway.loops.size() <= wire::kMostLoops);
  for (const config::Loop& loop : gateway.loops) {
    require(loop.id >= 1 && loop.id <= wire::kMostLoops);
    require(loop.sample_period_s > 0 && loop.stale_after_s >= loop.sample_period_s);
    require(loop.span[0] < loop.span[1] && wire::is_valid(loop.parameters));
    for (const config::Source* source : {&loop.u, &loop.y}) {
      if (source->kind != config::SourceKind::kCan) continue;
      require(source->bus < gateway.buses.size());
      require(wire::check(source->signal) == wire::SignalError::kNone);
    }
  }
}

}  // namespace

Outcome feed_toml(std::string_view text) {
  try {
    require_valid(config::parse_gateway(text, "fuzz.toml"));
    return Outcome::kAccepted;
  } catch (const config::ConfigError& error) {
    require(std::string(error.what()).starts_with("fuzz.toml:"));
    return Outcome::kRefused;
  }
}

}  // namespace fuzz
