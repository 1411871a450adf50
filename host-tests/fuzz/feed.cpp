#include "feed.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "wire/candump.hpp"
#include "wire/dbc.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/candump_log.hpp"
#include "workbench/recording/csv.hpp"

namespace fuzz {
namespace {

using workbench::Column;
using workbench::Recording;

void require(bool promise, const char* what) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

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
  for (std::size_t k = 1; k < r.size(); ++k) {
    require(r.t[k] > r.t[k - 1], "time that increases");
    require(std::abs(r.t[k] - r.t[k - 1] - r.period_s) <=
                0.11 * r.period_s + 1e-15 * std::abs(r.t[k]),
            "equal steps");
  }
  require(r.resampling.missing < r.size(), "fewer missing than samples");
}

// Identification takes far longer than reading, so only every sixteenth recording is
// identified, chosen by its content: the same input always takes the same way.
void survives_identification(const Recording& r) {
  constexpr std::uint64_t kEvery = 16;
  std::uint64_t hash = r.size();
  for (const double value : r.y) {
    hash = hash * 1099511628211u ^ std::bit_cast<std::uint64_t>(value);
  }
  if (r.u.empty() || r.y.empty() || (hash >> 32) % kEvery != 0) return;
  const workbench::Analysis analysis(r);
  const workbench::Identification& found = analysis.result();
  const bool fault = found.verdict == ident::Verdict::kStiction ||
                     found.verdict == ident::Verdict::kBacklash;
  for (const auto& band : {found.stick_band.ascending, found.stick_band.descending}) {
    require(!band.known || fault, "no stick band without a fault");
    require(!band.known || (std::isfinite(band.value) && band.low <= band.value &&
                            band.value <= band.high),
            "a stick band inside its interval");
  }
}

// Everything a recording that was read is put through, in this order.
constexpr void (*kAfterReading[])(const Recording&) = {
    &keeps_its_invariants,
    &survives_identification,
};

template <class Read>
Outcome feed(Read read) {
  try {
    const Recording recording = read();
    for (const auto step : kAfterReading) step(recording);
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

Outcome feed_csv(std::string_view text) {
  Outcome outcome = Outcome::kRefused;
  for (const bool with_period : {false, true}) {
    for (const bool only_u : {false, true}) {
      workbench::CsvOptions options;
      if (with_period) options.ts = 0.5;
      if (only_u) options.required = {Column::u};
      outcome = better(outcome, feed([&] { return parse_csv(text, "f.csv", options); }));
    }
  }
  return outcome;
}

Outcome feed_candump(std::string_view text) {
  const std::size_t split = std::min(text.find("\n("), text.size());
  const std::string_view dbc = text.substr(0, split);
  const std::string_view log = text.substr(std::min(split + 1, text.size()));
  workbench::CandumpOptions options{"M.U", "N.Y", "", "", {}};
  const Outcome plain =
      feed([&] { return parse_candump_log(log, "f.log", dbc, "f.dbc", options); });
  options.sp = "N.P";
  options.x = "M.X";
  options.period_s = 0.5;
  return better(plain, feed([&] {
                  return parse_candump_log(log, "f.log", dbc, "f.dbc", options);
                }));
}

Outcome feed_dbc(std::string_view text) {
  constexpr std::size_t kMessages = 32;
  constexpr std::size_t kSignals = 128;
  const auto messages = std::make_unique<std::array<wire::DbcMessage, kMessages>>();
  const auto signals = std::make_unique<std::array<wire::DbcSignal, kSignals>>();
  wire::Dbc dbc(*messages, *signals);
  const wire::DbcStatus status = dbc.parse(text);
  require(dbc.messages().size() <= kMessages, "messages within the storage");
  require(status.found.empty() ||
              (status.found.data() >= text.data() &&
               status.found.data() + status.found.size() <= text.data() + text.size()),
          "a finding inside the text");
  for (const wire::DbcMessage& message : dbc.messages()) {
    for (const wire::DbcSignal& signal : dbc.signals_of(message)) {
      const std::string reference =
          std::string(message.name) + '.' + std::string(signal.name);
      wire::FrameSignal found;
      if (!dbc.find(reference, found).ok()) continue;
      require(wire::check(found) == wire::SignalError::kNone, "a checked signal");
      wire::CanFrame frame;
      frame.id = found.frame_id;
      frame.extended = found.extended;
      frame.dlc = 8;
      double value = 0;
      if (wire::insert(found, found.signal.offset, frame) == wire::SignalError::kNone) {
        const wire::SignalError error = wire::extract(found, frame, value);
        require(error == wire::SignalError::kNone || found.multiplexed,
                "an inserted value that reads back");
        if (error == wire::SignalError::kNone && !found.multiplexed) {
          require(value == found.signal.offset, "raw zero means the offset");
        }
      }
    }
  }
  return status.ok() ? Outcome::kAccepted : Outcome::kRefused;
}

}  // namespace fuzz
