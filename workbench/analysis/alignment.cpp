#include "workbench/analysis/alignment.hpp"

#include <cstdlib>

#include "ident/signal/controller_action.hpp"
#include "workbench/analysis/analysis.hpp"

namespace workbench {
namespace {

constexpr int kMost = 3;
// What the law must explain, and leave over what it leaves as recorded, or a sample to
// either side: one that is nothing but integral is as good there.
constexpr double kExplained = 0.6;
constexpr double kSharper = 0.5;

}  // namespace

RecordingView aligned(const RecordingView& recording, int late) {
  const auto shift = static_cast<std::size_t>(std::abs(late));
  RecordingView out = recording.part(0, recording.size() - shift);
  if (late > 0) {
    out.y = recording.y.subspan(shift);
  } else {
    out.u = recording.u.subspan(shift);
  }
  return out;
}

int samples_late(const RecordingView& recording) {
  if (recording.size() < Identifier::kFewestSamples) return 0;
  const auto law = [&](int late) {
    const RecordingView view = aligned(recording, late);
    return ident::controller_action<double>(view.u, view.y, view.sp);
  };
  const double as_recorded = law(0).r_squared;
  int best = 0;
  double sharpest = kExplained;
  for (int late = -kMost; late <= kMost; ++late) {
    if (late == 0) continue;
    const auto action = law(late);
    if (!(action.r_squared > sharpest)) continue;
    // Beside a law that is no controller's a blurred one of its neighbours is none,
    // either.
    best = action.proportional * action.integral > 0 ? late : 0;
    sharpest = action.r_squared;
  }
  const auto is_sharper_than = [sharpest](double r_squared) {
    return 1 - sharpest < kSharper * (1 - r_squared);
  };
  const bool sharper = is_sharper_than(as_recorded) &&
                       is_sharper_than(law(best - 1).r_squared) &&
                       is_sharper_than(law(best + 1).r_squared);
  return sharper ? best : 0;
}

std::string alignment_note(int late) {
  switch (late) {
    case 1:
      return "y is recorded one sample later than the controller read it: moved back by "
             "as much";
    case -1:
      return "u is recorded one sample later than the controller set it: moved back by "
             "as much";
    default:
      return late > 0 ? "y is recorded " + std::to_string(late) +
                            " samples later than the controller read it: moved back by "
                            "as much"
                      : "u is recorded " + std::to_string(-late) +
                            " samples later than the controller set it: moved back by "
                            "as much";
  }
}

}  // namespace workbench
