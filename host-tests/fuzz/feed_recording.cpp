#include <algorithm>
#include <cmath>

#include "feed.hpp"
#include "require.hpp"
#include "workbench/recording/can/candump_log.hpp"
#include "workbench/recording/csv.hpp"

namespace fuzz {
namespace {

using workbench::Column;
using workbench::Recording;

void keeps_its_invariants(const Recording& r) {
  require(r.size() >= 2, "at least two samples");
  require(r.size() <= workbench::kMaxSamples, "at most kMaxSamples");
  require(std::isfinite(r.period_s) && r.period_s > 0, "a positive period");
  for (const Column column : {Column::t, Column::u, Column::y, Column::sp, Column::x}) {
    const auto& values = r.values(column);
    require(values.empty() || values.size() == r.size(), "columns of one length");
    require(std::all_of(values.begin(), values.end(),
                        [](double v) { return std::isfinite(v); }),
            "finite values");
  }
  for (const workbench::Load& load : r.loads) {
    require(load.values.size() == r.size(), "loads as long as the rest");
    require(std::all_of(load.values.begin(), load.values.end(),
                        [](double v) { return std::isfinite(v); }),
            "finite loads");
  }
  for (std::size_t k = 1; k < r.size(); ++k) {
    require(r.t[k] > r.t[k - 1], "time that increases");
    require(std::abs(r.t[k] - r.t[k - 1] - r.period_s) <=
                0.11 * r.period_s + 1e-15 * std::abs(r.t[k]),
            "equal steps");
  }
  require(r.resampling.missing < r.size(), "fewer missing than samples");
}

template <class Read>
Outcome feed(Read read, Examine examine) {
  try {
    const Recording recording = read();
    keeps_its_invariants(recording);
    if (examine) examine(recording);
    return Outcome::kAccepted;
  } catch (const workbench::InputError& error) {
    const std::string_view message = error.what();
    require(message.find(": expected ") != std::string_view::npos,
            "a message that expects");
    require(message.find(", found ") != std::string_view::npos, "a message that found");
    require(std::none_of(message.begin(), message.end(),
                         [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
            "a message of one printable line");
    require(message.size() < 2000, "a message of bounded length");
    return Outcome::kRefused;
  }
}

Outcome better(Outcome a, Outcome b) {
  return a == Outcome::kAccepted || b == Outcome::kAccepted ? Outcome::kAccepted
                                                            : Outcome::kRefused;
}

}  // namespace

Outcome feed_csv(std::string_view text, Examine examine) {
  Outcome outcome = Outcome::kRefused;
  for (const bool with_period : {false, true}) {
    for (const bool only_u : {false, true}) {
      workbench::CsvOptions options;
      if (with_period) options.ts = 0.5;
      if (only_u) options.required = {Column::u};
      outcome = better(outcome,
                       feed([&] { return parse_csv(text, "f.csv", options); }, examine));
    }
  }
  workbench::CsvOptions options;
  options.names.loads = {"all"};
  options.date_order = workbench::DateOrder::dmy;
  return better(outcome,
                feed([&] { return parse_csv(text, "f.csv", options); }, examine));
}

Outcome feed_candump(std::string_view text, Examine examine) {
  const std::size_t split = std::min(text.find("\n("), text.size());
  const std::string_view dbc = text.substr(0, split);
  const std::string_view log = text.substr(std::min(split + 1, text.size()));
  workbench::CandumpOptions options{"M.U", "N.Y", "", "", {}};
  // One of the two ways of reading, by the length: both would cost twice the time.
  if (text.size() % 2 != 0) {
    options.sp = "N.P";
    options.x = "M.X";
    options.period_s = 0.5;
  }
  const auto read = [&] {
    return parse_candump_log(log, "f.log", dbc, "f.dbc", options);
  };
  return feed(read, examine);
}

}  // namespace fuzz
