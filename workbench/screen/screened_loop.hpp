// What a screening says about one loop.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ident/verdict/verdict.hpp"
#include "workbench/screen/rhythm.hpp"

namespace workbench {

/// One calendar month of a loop; without dates, one recording of it.
struct Stretch {
  std::string name;        ///< "2026-03"; without dates "1", "2", ...
  std::string verdict;     ///< that most of its windows name
  double nats = 0;         ///< closed-loop evidence of its windows; NaN: none
  double stick_band = 0;   ///< mean of both strokes and all windows, units of u; NaN
  double oscillating = 0;  ///< share of the time, 0 … 1
};

struct ScreenedLoop {
  std::string loop;
  std::vector<std::string> files;
  std::string u_tag;  ///< in a table with many loops: names of its columns or tags
  std::string y_tag;
  std::string error;  ///< why there is no answer; "" there is one

  std::string verdict;                  ///< in the contract's words; "" with an error
  std::string reason;                   ///< one sentence
  std::string cause;                    ///< what moves the loop, "" unknown
  std::string unit;                     ///< of u, "" unknown
  ident::PerStroke<double> stick_band;  ///< units of u
  ident::PerStroke<double> slip_jump;
  double detectable_band = 0;  ///< units of u; 0 unknown
  double span = 0;             ///< of u
  double nats = 0;             ///< pooled closed-loop evidence; NaN none
  double stem_nats = 0;        ///< of its own stem, fitted or searched; NaN none
  double error_ratio = 0;      ///< squared error of a linear valve over the fitted one
  double regularity = 0;       ///< of the oscillation
  int windows = 0;
  double period_s = 0;           ///< of the oscillation; 0 none
  double oscillating_share = 0;  ///< of the time, 0 … 1
  double samples = 0;            ///< of recordings that are given twice once
  double sample_period_s = 0;
  std::string from;            ///< clock time of the first sample, "" unknown
  std::vector<Stretch> trend;  ///< at least two, or none
  std::vector<std::string> notes;
  double cost = 0;       ///< what it costs to leave it, 0 … 100: rate()
  double suspicion = 0;  ///< how likely the valve is at fault, 0 … 1: rate()

  int group = 0;         ///< number of its group, from 1; 0 none
  bool leads = false;    ///< the first of its group
  std::string group_is;  ///< of a leader: "valve", or "not_a_valve"
  double lag_s = 0;      ///< behind its leader, of one period

  Rhythm rhythm;
  /// The last cycles of u and y, for a small picture: kPicturePoints values each, one
  /// character from ! (lowest) to ~ (highest). "": none.
  std::string picture_u;
  std::string picture_y;
  static constexpr std::size_t kPicturePoints = 96;
};

/// The line of `--json`.
[[nodiscard]] nlohmann::ordered_json json_of(const ScreenedLoop& loop);

/// All of it, for the journal, and back. Throws nlohmann::json::exception for what this
/// did not write.
[[nodiscard]] nlohmann::json journal_json(const ScreenedLoop& loop);
[[nodiscard]] ScreenedLoop from_journal(const nlohmann::json& json);

/// `values` as characters, at most kPicturePoints; "" where they do not move.
[[nodiscard]] std::string picture_of(const std::vector<double>& values,
                                     std::size_t first);

}  // namespace workbench
