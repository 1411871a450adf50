// Signals as they stand in a candump log, before they are sampled.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "wire/signal.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {

/// One signal and all it said, in order of time.
struct CanSeries {
  Column column = Column::u;
  std::string reference;
  wire::FrameSignal signal;
  std::vector<double> t;  ///< s since the first line of the log
  std::vector<double> value;
  std::vector<std::uint32_t> line;
  /// Of its frames; given: only those of this interface where the log holds any of it.
  std::string interface;
  bool others_too = false;             ///< given, and the log holds further interfaces
  std::optional<std::uint8_t> sender;  ///< of its frames, where any may be
  std::size_t frames = 0;
  std::size_t short_frames = 0;
  std::size_t other_pages = 0;
  std::size_t not_available = 0;
  std::size_t outside_limits = 0;  ///< far: left out
  std::size_t just_outside = 0;    ///< kept
  std::size_t highest = 0;         ///< samples of the highest raw number, of no limits
  double highest_value = 0;        ///< what that is
  std::size_t repeated = 0;
  Spacing spacing;  ///< of t, when there are at least two

  /// Nine intervals in ten are on time.
  [[nodiscard]] bool cyclic() const {
    return t.size() >= 3 && spacing.on_time_share >= 0.9;
  }
  [[nodiscard]] std::string title() const {
    return std::string(name_of(column)) + " (" + reference + ")";
  }
};

/// What else a log says.
struct CanLogFacts {
  double start_s = 0;           ///< time of the first line
  std::size_t unsupported = 0;  ///< lines of CAN XL
  std::size_t cut_line = 0;     ///< number of the last one where it was cut; 0: whole
};

/// Reads the text `log` into `series`, whose columns, references and signals are given.
/// Throws InputError as read_candump() says, and Stopped; `name` stands in messages.
CanLogFacts read_series(std::string_view log, const std::string& name,
                        std::vector<CanSeries>& series, const std::stop_token& stop);

}  // namespace workbench
