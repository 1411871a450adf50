#include <string_view>

#include "config/gateway.hpp"
#include "feed.hpp"
#include "require.hpp"

namespace fuzz {
namespace {

void require_valid(const config::Gateway& gateway) {
  require(!gateway.loops.empty() && gateway.loops.size() <= wire::kMostLoops,
          "one to 31 loops");
  for (const config::Loop& loop : gateway.loops) {
    require(loop.id >= 1 && loop.id <= wire::kMostLoops, "an id in range");
    require(loop.sample_period_s > 0 && loop.stale_after_s >= loop.sample_period_s,
            "times in range");
    require(loop.span[0] < loop.span[1], "a span");
    require(wire::is_valid(loop.parameters), "parameters in range");
    for (const config::Source* source : {&loop.u, &loop.y}) {
      if (source->kind != config::SourceKind::kCan) continue;
      require(source->bus < gateway.buses.size(), "a bus that there is");
      require(wire::check(source->signal) == wire::SignalError::kNone,
              "a signal that fits its frame");
    }
  }
}

}  // namespace

Outcome feed_toml(std::string_view text) {
  try {
    require_valid(config::parse_gateway(text, "fuzz.toml"));
    return Outcome::kAccepted;
  } catch (const config::ConfigError& error) {
    require(std::string_view(error.what()).starts_with("fuzz.toml:"),
            "a message that names the file");
    return Outcome::kRefused;
  }
}

}  // namespace fuzz
