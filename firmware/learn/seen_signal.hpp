// Signals seen on a bus: those that a DBC file names, or, without one, what looks like
// a 16-bit number.
//
// A guess is a pair of bytes that reads as a quantity: it takes many values, moves by
// small steps against its range, and its high byte moves less often than its low one.
// Counters, checksums and bytes of two quantities do not. The other byte order and the
// pair one byte on lose against the smoother reading, so that the guesses of a frame do
// not overlap. What a guess cannot know: its unit, and its scale, which is set so that it
// reads as 0 … 100 where that is a power of ten.
#pragma once

#include <string>
#include <vector>

#include "config/dbc_file.hpp"
#include "firmware/learn/frame_survey.hpp"
#include "wire/signal.hpp"

namespace firmware {

struct SeenSignal {
  std::string bus = {};
  std::string message = {};  ///< of the DBC file; empty: a guess
  std::string name = {};
  std::string unit = {};
  std::string dbc = {};  ///< the file it is named in
  wire::FrameSignal signal = {};
  std::vector<double> t_s = {};  ///< since the first frame of all
  std::vector<double> value = {};
  double low = 0;         ///< smallest value
  double high = 0;        ///< largest value
  double interval_s = 0;  ///< between frames, usually
  double moving = 0;      ///< share of the frames that brought another value

  /// "LoopOP.OP", or "18F bytes 0-1, low first".
  [[nodiscard]] std::string title() const;
};

/// The signals of `dbc` that were seen with a finite value, in the order of the file.
/// `path`: what the configuration calls it.
[[nodiscard]] std::vector<SeenSignal> named_signals(const FrameSurvey& survey,
                                                    config::DbcFile& dbc,
                                                    const std::string& path);
/// What looks like a number, by identifier.
[[nodiscard]] std::vector<SeenSignal> guessed_signals(const FrameSurvey& survey);

}  // namespace firmware
