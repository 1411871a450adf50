#include "support/real_loads/loop.hpp"

#include <stdexcept>
#include <utility>

#include "support/real_loads/draft.hpp"

namespace workbench::test {
namespace {

constexpr int kMostRedraws = 5000;

}  // namespace

RealLoadLoop real_load_loop(LoopKind kind, std::uint64_t seed,
                            const std::vector<RealLoad>& loads) {
  if (loads.empty()) {
    throw std::invalid_argument(
        "real_load_loop: expected at least one load, found none; read them with "
        "read_real_loads from a folder that holds the recordings");
  }
  const bool sticking = kind == LoopKind::kSticking;
  Random random(sticking ? "real-load-sticking" : "real-load-healthy", seed);
  const RealLoadPlan plan = draw_plan(random, kind, seed);
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    auto loop =
        sticking ? draw_sticking(random, plan, loads) : draw_healthy(random, plan, loads);
    if (loop) return std::move(*loop);
  }
  throw std::runtime_error("real_load_loop: no loop for seed " + std::to_string(seed) +
                           " (" + plan.cause + ", " + plan.motion + ", " +
                           std::string(name(plan.historian)) +
                           "); the ranges leave none, try another seed");
}

nlohmann::json truth_json(const RealLoadLoop& loop) {
  nlohmann::json json = truth_json(loop.recorded.truth);
  const RealLoadTruth& truth = loop.truth;
  json["sticks"] = truth.motion != "none";
  json["motion"] = truth.motion;
  json["strokes"] = truth.strokes;
  json["historian"] = name(truth.historian);
  json["load"] = truth.load;
  json["load_at"] = truth.load_at;
  json["load_share"] = truth.load_share;
  json["setpoint"] = truth.setpoint;
  json["gap"] = truth.gap;
  json["cycles"] = truth.cycles;
  json["band_over_swing"] = truth.band_over_swing;
  json["oracle_nats"] = truth.oracle_nats;
  json["period_s"] = loop.recorded.period_s;
  return json;
}

}  // namespace workbench::test
