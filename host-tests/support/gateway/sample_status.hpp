// A gateway with two loops in which every field of the diagnostic table has a value of
// its own: what the golden tables of the views are written against.
#pragma once

#include <array>

#include "wire/diagnostics.hpp"

namespace support {

/// Loop 1, FIC-211: confirmed stiction, everything known.
[[nodiscard]] inline wire::LoopStatus sticking_loop() {
  wire::LoopStatus loop;
  loop.id = 1;
  loop.tag.assign("FIC-211");
  loop.mapping.assign("u can0 LoopOP.OP, y can0 0x18F");
  loop.verdict = wire::LoopVerdict::kStiction;
  loop.window_verdict = wire::LoopVerdict::kStiction;
  loop.confirmed = true;
  loop.flag = true;
  loop.input = wire::InputStatus::kGood;
  loop.confidence_pct = 97.5;
  loop.stick_band_pct = {5.01, 4.98};
  loop.stick_band_low_pct = {4.8, 4.75};
  loop.stick_band_high_pct = {5.2, 5.15};
  loop.detectable_band_pct = 0.63;
  loop.evidence_nats = 213.4;
  loop.trend_pct_per_day = -0.031;
  loop.trend_low_pct_per_day = -0.044;
  loop.trend_high_pct_per_day = -0.018;
  loop.days_to_limit = 40;
  loop.slip_jump_pct = {4.9, 4.85};
  loop.period_s = 140.25;
  loop.age_s = 12;
  loop.u_pct = 51.23;
  loop.y_pct = -0.5;
  loop.sp_pct = 50;
  loop.mode = wire::LoopMode::kAutomatic;
  loop.window_samples = 2048;
  loop.window_cycles = 10;
  loop.fit_percent = 94.1;
  loop.fit_linear_percent = -3.25;
  loop.suspect_effect = 13;
  loop.share_of_error_pct = 61.5;
  loop.residual_share_pct = 1.75;
  loop.changed_ms = 1'436'509'052'249;
  loop.counters = {{100'000, 3, 1, 7, 2, 4}, 5};
  loop.path = {wire::PathKnot{40, 38.5, 42.5}, wire::PathKnot{60, 57.75, -0.01}};
  loop.path_knots = 2;
  return loop;
}

/// Loop 31, LIC-400: nothing known yet.
[[nodiscard]] inline wire::LoopStatus new_loop() {
  wire::LoopStatus loop;
  loop.id = 31;
  loop.tag.assign("LIC-400");
  loop.input = wire::InputStatus::kGood;
  return loop;
}

[[nodiscard]] inline std::array<wire::LoopStatus, 2> sample_loops() {
  return {sticking_loop(), new_loop()};
}

[[nodiscard]] inline wire::GatewayStatus sample_gateway() {
  wire::GatewayStatus gateway;
  gateway.name.assign("gw-17");
  gateway.software_version.assign("0.1.0");
  gateway.uptime_s = 3600;
  gateway.config_crc32 = 0xCBF43926;
  return gateway;
}

}  // namespace support
