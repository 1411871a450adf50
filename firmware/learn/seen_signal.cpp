#include "firmware/learn/seen_signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "config/source_reader.hpp"

namespace firmware {
namespace {

constexpr std::size_t kFewest = 20;     // frames, to tell anything
constexpr std::size_t kDifferent = 12;  // values that a quantity takes, at least
constexpr double kMostRough = 0.25;     // step, root mean square, against the range
constexpr double kCounting = 0.9;       // share of steps that are the same

double first_of_all_us(const FrameSurvey& survey) {
  double first = HUGE_VAL;
  for (const SurveyedFrame* frame : survey.all()) {
    first = std::min(first, static_cast<double>(frame->first_us));
  }
  return first;
}

// Fills in what follows from the frames; false: no value was seen.
bool read_values(const SurveyedFrame& from, double start_us, SeenSignal& out) {
  for (std::size_t k = 0; k < from.frames.size(); ++k) {
    double value = 0;
    if (wire::extract(out.signal, from.frames[k], value) != wire::SignalError::kNone ||
        !wire::within_limits(out.signal.signal, value)) {
      continue;
    }
    out.t_s.push_back((static_cast<double>(from.time_us[k]) - start_us) * 1e-6);
    out.value.push_back(value);
  }
  if (out.value.empty()) return false;
  const auto [low, high] = std::ranges::minmax_element(out.value);
  out.low = *low;
  out.high = *high;
  out.bus = from.bus;
  out.interval_s = from.rate_hz() > 0 ? 1 / from.rate_hz() : 0;
  std::size_t moves = 0;
  for (std::size_t k = 1; k < out.value.size(); ++k) {
    moves += out.value[k] != out.value[k - 1] ? 1 : 0;
  }
  out.moving = static_cast<double>(moves) / static_cast<double>(out.value.size());
  return true;
}

// Root mean square of the steps against the range, so that a jump of the whole range (of
// a sign that was taken for a number) weighs; above 1 where it is no quantity.
double roughness(const std::vector<double>& value) {
  constexpr double kNone = 2;
  if (value.size() < kFewest) return kNone;
  const auto [low, high] = std::ranges::minmax_element(value);
  const double range = *high - *low;
  if (!(range > 0)) return kNone;
  const std::set<double> different(value.begin(), value.end());
  if (different.size() < kDifferent) return kNone;
  double squares = 0;
  std::size_t alike = 0;
  for (std::size_t k = 1; k < value.size(); ++k) {
    squares += (value[k] - value[k - 1]) * (value[k] - value[k - 1]);
    alike += k > 1 && value[k] - value[k - 1] == value[k - 1] - value[k - 2] &&
                     value[k] != value[k - 1]
                 ? 1
                 : 0;
  }
  const auto steps = static_cast<double>(value.size() - 1);
  if (static_cast<double>(alike) > kCounting * steps) return kNone;
  return std::sqrt(squares / steps) / range;
}

struct Guess {
  wire::Signal signal;
  std::size_t byte = 0;
  double rough = 0;
};

std::optional<Guess> guess_at(const SurveyedFrame& frame, std::size_t byte,
                              wire::ByteOrder order) {
  Guess best{.signal = {}, .byte = byte, .rough = kMostRough};
  bool any = false;
  const bool little = order == wire::ByteOrder::kLittleEndian;
  const std::uint64_t often = frame.changes[little ? byte : byte + 1];
  const std::uint64_t seldom = frame.changes[little ? byte + 1 : byte];
  if (often == 0 || seldom > often) return std::nullopt;
  for (const bool is_signed : {false, true}) {
    wire::FrameSignal field{.frame_id = frame.id, .extended = frame.extended};
    field.signal.start = static_cast<std::uint16_t>(8 * byte + (little ? 0 : 7));
    field.signal.length = 16;
    field.signal.byte_order = order;
    field.signal.is_signed = is_signed;
    std::vector<double> value;
    for (const wire::CanFrame& payload : frame.frames) {
      double number = 0;
      if (wire::extract(field, payload, number) == wire::SignalError::kNone) {
        value.push_back(number);
      }
    }
    const double rough = roughness(value);
    if (rough >= best.rough) continue;
    best.rough = rough;
    best.signal = field.signal;
    any = true;
  }
  return any ? std::optional(best) : std::nullopt;
}

// A power of ten that makes a full range of 0 … 100; 1 where none does.
double scale_for(double low, double high) {
  if (low < 0) return 1;
  for (const double scale : {1.0, 0.1, 0.01, 0.001}) {
    if (high * scale <= 105 && high * scale > 10) return scale;
  }
  return 1;
}

}  // namespace

std::string SeenSignal::title() const {
  if (!message.empty()) return message + '.' + name;
  const bool little = signal.signal.byte_order == wire::ByteOrder::kLittleEndian;
  const unsigned byte = signal.signal.start / 8U;
  return config::hex_id(signal.frame_id, signal.extended) + " bytes " +
         std::to_string(byte) + '-' + std::to_string(byte + 1) +
         (little ? ", low first" : ", high first");
}

std::vector<SeenSignal> named_signals(const FrameSurvey& survey, config::DbcFile& dbc,
                                      const std::string& path) {
  std::vector<SeenSignal> out;
  const double start_us = first_of_all_us(survey);
  for (const wire::DbcMessage& message : dbc.content().messages()) {
    for (const wire::DbcSignal& signal : dbc.content().signals_of(message)) {
      SeenSignal seen{.message = std::string(message.name),
                      .name = std::string(signal.name),
                      .unit = std::string(signal.unit),
                      .dbc = path};
      if (!dbc.find(seen.title(), seen.signal)) continue;
      for (const SurveyedFrame* frame : survey.all()) {
        const bool same = (frame->id & ~seen.signal.ignored) == seen.signal.frame_id;
        if (!same || frame->extended != message.extended) continue;
        SeenSignal here = seen;
        if (read_values(*frame, start_us, here)) out.push_back(std::move(here));
      }
    }
  }
  return out;
}

std::vector<SeenSignal> guessed_signals(const FrameSurvey& survey) {
  std::vector<SeenSignal> out;
  const double start_us = first_of_all_us(survey);
  for (const SurveyedFrame* frame : survey.all()) {
    std::vector<Guess> guesses;
    for (std::size_t byte = 0; byte + 1 < frame->shortest; ++byte) {
      for (const auto order :
           {wire::ByteOrder::kLittleEndian, wire::ByteOrder::kBigEndian}) {
        if (const auto guess = guess_at(*frame, byte, order)) guesses.push_back(*guess);
      }
    }
    std::ranges::sort(guesses,
                      [](const Guess& a, const Guess& b) { return a.rough < b.rough; });
    std::array<bool, wire::kMaxFdLength + 1> taken{};
    const std::size_t before = out.size();
    for (const Guess& guess : guesses) {
      if (taken[guess.byte] || taken[guess.byte + 1]) continue;
      taken[guess.byte] = taken[guess.byte + 1] = true;
      SeenSignal seen;
      seen.signal = {.frame_id = frame->id, .extended = frame->extended};
      seen.signal.signal = guess.signal;
      if (!read_values(*frame, start_us, seen)) continue;
      const double scale = scale_for(seen.low, seen.high);
      seen.signal.signal.scale = scale;
      for (double& value : seen.value) value *= scale;
      seen.low *= scale;
      seen.high *= scale;
      out.push_back(std::move(seen));
    }
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(before), out.end(),
              [](const SeenSignal& a, const SeenSignal& b) {
                return a.signal.signal.start < b.signal.signal.start;
              });
  }
  return out;
}

}  // namespace firmware
