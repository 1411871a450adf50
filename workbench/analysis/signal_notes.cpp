#include "workbench/analysis/signal_notes.hpp"

#include <algorithm>
#include <functional>
#include <span>

#include "workbench/recording/output_limit.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

bool never_moves(std::span<const double> values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) ==
         values.end();
}

std::string limit_note(const OutputLimit& limit) {
  return "the controller output rests at its limit of " + number(limit.level, 4) + ", " +
         std::to_string(limit.stays) + " times and " + number(100 * limit.share, 2) +
         " % of all samples: look for windup, and for a range or a valve that is too "
         "small";
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
  for (const OutputLimit& limit : limits_of_output(recording.u)) {
    notes.push_back(limit_note(limit));
  }
  return notes;
}

}  // namespace workbench
