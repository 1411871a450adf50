#include "workbench/recording/can/can_series.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "config/source_reader.hpp"
#include "wire/candump_reader.hpp"
#include "wire/j1939.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/stopped.hpp"

namespace workbench {
namespace {

using config::hex_id;

constexpr std::size_t kMaxIdsListed = 16;
constexpr std::size_t kMaxIdsKept = 4096;

// Its identifier, or the parameter group where the sender is open.
std::string frames_of(const wire::FrameSignal& signal) {
  return signal.ignored == 0
             ? "frames " + hex_id(signal.frame_id, signal.extended)
             : "frames of PGN " + hex_id(wire::j1939::pgn_of(signal.frame_id), false);
}

bool is_reserved(const wire::Signal& signal, const wire::CanFrame& frame) {
  return wire::j1939::has_error_codes(signal) && wire::extract_raw(signal, frame) >>
                                                     (signal.length - 8) >=
                                                     wire::j1939::kFirstErrorCode;
}

// Farther than half as wide as they are: no swing that limits cut off.
bool is_far_outside(const wire::Signal& signal, double value) {
  const double reach = (signal.maximum - signal.minimum) / 2;
  return value > signal.maximum + reach || value < signal.minimum - reach;
}

std::string hex_byte(std::uint32_t byte) {
  return hex_id(byte, false).substr(1);
}

class LogReader {
 public:
  LogReader(std::string_view text, const std::string& name,
            std::vector<CanSeries>& series, const std::stop_token& stop)
      : name_(name), series_(series), stop_(stop), log_(text) {}

  void read() {
    forget_absent_interfaces();
    while (log_.next()) {
      check_stop(stop_);
      take_line(log_.line());
    }
    if (lines_ == 0) {
      fail(1, 1, "lines of a candump log", "an empty file", "record with candump -l");
    }
    for (CanSeries& s : series_) {
      leave_out_highest(s);
      require_samples(s);
    }
  }

  [[nodiscard]] std::size_t unsupported() const { return unsupported_; }
  [[nodiscard]] std::size_t cut_line() const { return log_.cut_line(); }
  [[nodiscard]] double start_s() const { return static_cast<double>(base_ns_) * 1e-9; }

 private:
  // A log may have been recorded where the interface has another name.
  void forget_absent_interfaces() {
    const bool given = std::ranges::any_of(
        series_, [](const CanSeries& s) { return !s.interface.empty(); });
    if (!given) return;
    std::set<std::string, std::less<>> found;
    for (wire::CandumpReader log = log_; log.next();) {
      check_stop(stop_);
      const std::string_view name = log.line().interface;
      if (log.status().ok() && !found.contains(name)) found.emplace(name);
    }
    for (CanSeries& s : series_) {
      if (!found.contains(s.interface)) {
        s.interface.clear();
      } else {
        s.others_too = found.size() > 1;
      }
    }
  }

  [[noreturn]] void fail(std::size_t line, std::size_t column, std::string expected,
                         std::string found, std::string advice) const {
    throw InputError(name_, line, column, std::move(expected), std::move(found),
                     std::move(advice));
  }

  void take_line(const wire::CandumpLine& line) {
    const wire::CandumpStatus& status = log_.status();
    if (!status.ok() && !log_.is_xl()) {
      const std::string_view text = log_.text();
      const std::string_view rest = text.substr(std::min(status.column - 1, text.size()));
      fail(log_.number(), status.column, wire::expected_at(status.error),
           rest.empty() ? "the end of the line" : quoted(rest), log_.cure());
    }
    if (lines_++ == 0) base_ns_ = line.time_ns;
    if (log_.is_xl()) {
      ++unsupported_;
      return;
    }
    note_id(line.frame);
    for (CanSeries& s : series_) take_frame(line, s);
  }

  void note_id(const wire::CanFrame& frame) {
    if (frame.error || frame.remote) return;
    const std::pair<std::uint32_t, bool> key(frame.id, frame.extended);
    if (ids_.size() < kMaxIdsKept || ids_.contains(key)) ++ids_[key];
  }

  void take_frame(const wire::CandumpLine& line, CanSeries& s) {
    double value = 0;
    const wire::SignalError error = wire::extract(s.signal, line.frame, value);
    if (error == wire::SignalError::kOtherFrame) return;
    if (s.others_too && s.interface != line.interface) return;
    ++s.frames;
    require_one_sender(line.frame, s);
    if (s.interface.empty()) s.interface = line.interface;
    if (s.interface != line.interface) {
      fail(log_.number(), 0, "frames of " + s.title() + " on one interface",
           "both " + quoted(s.interface) + " and " + quoted(line.interface),
           "keep the lines of one interface");
    }
    switch (error) {
      case wire::SignalError::kShortFrame:
        ++s.short_frames;
        return;
      case wire::SignalError::kNotSelected:
        ++s.other_pages;
        return;
      case wire::SignalError::kNotFinite:
        fail(log_.number(), 0, "a finite value of " + s.title(), "NaN or an infinity",
             "cut the log where the sender had no value");
      default:
        break;
    }
    const wire::Signal& signal = s.signal.signal;
    const bool highest = wire::is_highest_raw(signal, line.frame);
    if (!wire::within_limits(signal, value)) {
      if (highest || is_reserved(signal, line.frame) || is_far_outside(signal, value)) {
        ++(highest ? s.not_available : s.outside_limits);
        return;
      }
      ++s.just_outside;
    }
    const double t = static_cast<double>(line.time_ns - base_ns_) * 1e-9;
    if (!s.t.empty() && t < s.t.back()) {
      fail(log_.number(), 1, "a time not before the previous frame of " + s.title(),
           "a step back of " + number(s.t.back() - t) + " s",
           "split the log where the clock was set");
    }
    if (!s.t.empty() && t == s.t.back()) {
      ++s.repeated;
      return;
    }
    if (s.t.size() >= kMaxSamples) {
      fail(log_.number(), 0,
           "at most " + std::to_string(kMaxSamples) + " frames of one signal", "more",
           "split the log");
    }
    if (highest && !(signal.minimum < signal.maximum)) {
      ++s.highest;
      s.highest_value = value;
    }
    s.t.push_back(t);
    s.value.push_back(value);
    s.line.push_back(static_cast<std::uint32_t>(log_.number()));
  }

  // Where the identifier leaves the sender open, J1939.
  void require_one_sender(const wire::CanFrame& frame, CanSeries& s) const {
    constexpr std::uint32_t kAddress = 0xFF;
    if ((s.signal.ignored & kAddress) != kAddress) return;
    const auto address = static_cast<std::uint8_t>(frame.id & kAddress);
    if (!s.sender) s.sender = address;
    if (*s.sender == address) return;
    fail(log_.number(), 0, "frames of " + s.title() + " from one sender",
         "the source addresses 0x" + hex_byte(*s.sender) + " and 0x" + hex_byte(address),
         "name one: by the identifier in the DBC file, or by source_address in the "
         "configuration");
  }

  // Without limits the highest raw number is a value as any other, unless it is rare and
  // lies farther out than all others are apart.
  void leave_out_highest(CanSeries& s) const {
    constexpr double kRare = 0.05;
    const auto is_rare =
        static_cast<double>(s.highest) <= kRare * static_cast<double>(s.t.size());
    if (s.highest == 0 || !is_rare) return;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : s.value) {
      if (value == s.highest_value) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    const double apart = high - low;
    const bool far = s.highest_value > high + apart || s.highest_value < low - apart;
    if (!(apart > 0) || !far) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < s.value.size(); ++i) {
      if (s.value[i] == s.highest_value) continue;
      s.t[kept] = s.t[i];
      s.value[kept] = s.value[i];
      s.line[kept++] = s.line[i];
    }
    s.t.resize(kept);
    s.value.resize(kept);
    s.line.resize(kept);
    s.not_available += s.highest;
  }

  void require_samples(const CanSeries& s) const {
    constexpr double kMostOutside = 0.5;
    const auto used = static_cast<double>(s.frames - s.other_pages);
    if (static_cast<double>(s.outside_limits) > kMostOutside * used) {
      const wire::Signal& signal = s.signal.signal;
      fail(0, 0,
           s.title() + " within its limits " + number(signal.minimum) + " to " +
               number(signal.maximum),
           std::to_string(s.outside_limits) + " of " + std::to_string(s.frames) +
               " frames outside",
           "correct the limits, or how the signal is laid out and scaled");
    }
    if (!s.t.empty()) return;
    if (s.frames == 0) {
      const std::string seen =
          first_listed(ids_, {.things = kMaxIdsListed}, ", ", [](const auto& id) {
            return hex_id(id.first.first, id.first.second) + " (" +
                   std::to_string(id.second) + " frames)";
          });
      fail(0, 0, frames_of(s.signal) + " of " + s.title(),
           seen.empty() ? "no data frame at all" : "only the identifiers " + seen,
           "check the signal, the DBC file and the log");
    }
    std::string why;
    if (s.other_pages > 0) {
      why = std::to_string(s.other_pages) + " with another multiplexor than " +
            std::to_string(s.signal.multiplex_value);
    } else if (s.short_frames > 0) {
      why = std::to_string(s.short_frames) + " too short";
    } else {
      why = std::to_string(s.not_available) + " marked as not available";
    }
    fail(0, 0, frames_of(s.signal) + " that hold " + s.title(),
         std::to_string(s.frames) + " frames, " + why,
         "check the signal and the DBC file, or record longer");
  }

  const std::string& name_;
  std::vector<CanSeries>& series_;
  const std::stop_token& stop_;
  wire::CandumpReader log_;
  std::map<std::pair<std::uint32_t, bool>, std::size_t> ids_;
  std::size_t lines_ = 0;
  std::size_t unsupported_ = 0;
  std::int64_t base_ns_ = 0;
};

}  // namespace

CanLogFacts read_series(std::string_view log, const std::string& name,
                        std::vector<CanSeries>& series, const std::stop_token& stop) {
  LogReader reader(log, name, series, stop);
  reader.read();
  for (CanSeries& s : series) {
    if (s.t.size() >= 2) s.spacing = spacing_of(s.t);
  }
  return {reader.start_s(), reader.unsupported(), reader.cut_line()};
}

}  // namespace workbench
