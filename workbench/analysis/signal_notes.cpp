#include "workbench/analysis/signal_notes.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "ident/signal/range_end.hpp"
#include "ident/signal/signal_shape.hpp"
#include "workbench/analysis/longest_part.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/output_limit.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

bool never_moves(std::span<const double> values) {
  return std::ranges::adjacent_find(values, std::not_equal_to<>()) == values.end();
}

// What a straight line of u leaves of y, a share of its squares; y `after` samples later.
double left_by_line(std::span<const double> u, std::span<const double> y,
                    std::size_t after) {
  return 1 - squared_correlation(u.first(u.size() - after), y.subspan(after));
}

// Where the samples are too far apart to see which of u and y comes first.
bool move_together(std::span<const double> u, std::span<const double> y) {
  constexpr double kMostLeft = 0.2;
  constexpr double kLessThanAfter = 3;
  if (u.size() < 3) return false;
  const double left = left_by_line(u, y, 0);
  return left > 0 && left < kMostLeft && left_by_line(u, y, 1) > kLessThanAfter * left;
}

// Rounding apart; a process takes time, and has noise.
bool is_the_same(std::span<const double> u, std::span<const double> y,
                 std::size_t after) {
  constexpr double kRounding = 1e-4;
  return u.size() > 2 && left_by_line(u, y, after) < kRounding;
}

std::string limit_note(const OutputLimit& limit) {
  return "the controller output rests at its limit of " + number(limit.level, 4) + ", " +
         std::to_string(limit.stays) + " times and " + number(100 * limit.share, 2) +
         " % of all samples: look for windup, and for a range or a valve that is too "
         "small";
}

std::string end_note(const ident::RangeEnd& end, bool upper) {
  return filled(
      upper ? "the process output is cut off at {0}, its highest reading, {1} times and "
              "{2} % of all samples: look at the range of the transmitter, and for an "
              "overflow or an empty vessel"
            : "the process output is cut off at {0}, its lowest reading, {1} times and "
              "{2} % of all samples: look at the range of the transmitter, and for an "
              "overflow or an empty vessel",
      {number(end.level, 4), std::to_string(end.stays), number(100 * end.share, 2)});
}

}  // namespace

std::vector<std::string> signal_notes(const RecordingView& recording) {
  std::vector<std::string> notes;
  if (never_moves(recording.u)) {
    notes.push_back("u stays at " + number(recording.u.front()) +
                    ": of a step test that begins with its step, say where u rested "
                    "before, --u-before");
  }
  if (never_moves(recording.y)) {
    notes.push_back("y stays at " + number(recording.y.front()));
  }
  if (is_the_same(recording.u, recording.y, 0)) {
    notes.push_back(
        "y is u on another scale, sample by sample: the same signal twice, or "
        "one computed from the other. Choose the process output as y");
  }
  for (const OutputLimit& limit : limits_of_output(recording.u)) {
    notes.push_back(limit_note(limit));
  }
  for (const bool upper : {false, true}) {
    const ident::RangeEnd end = ident::find_range_end(recording.y, upper);
    if (end.stays > 0) notes.push_back(end_note(end, upper));
  }
  return notes;
}

bool is_one_signal(std::span<const double> u, std::span<const double> y) {
  return is_the_same(u, y, 0) || is_the_same(u, y, 1);
}

std::string same_sample_note(const RecordingView& recording) {
  return move_together(recording.u, recording.y)
             ? "y moves with u in the same sample: the process answers faster than it is "
               "sampled, or u follows y. A shorter sample period would tell"
             : "";
}

std::vector<std::string> notes_for_model(const RecordingView& recording) {
  std::vector<std::string> notes;
  const UncutPart part = longest_part(recording);
  // The only move of a step test is a jump as well.
  if (part.length < recording.size() && !ident::moves_rarely<double>(recording.u)) {
    notes.push_back("y and u jump at " + number(recording.t[part.seam_at]) +
                    " s, as where two recordings were joined: the model takes them as "
                    "one. Give the parts as files of their own");
  }
  std::string same_sample = same_sample_note(recording);
  if (!same_sample.empty()) notes.push_back(std::move(same_sample));
  return notes;
}

}  // namespace workbench
