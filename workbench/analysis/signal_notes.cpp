#include "workbench/analysis/signal_notes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <functional>
#include <span>

#include "ident/verdict/judge.hpp"
#include "workbench/analysis/votes.hpp"
#include "workbench/recording/output_limit.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

bool never_moves(std::span<const double> values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) ==
         values.end();
}

// What a straight line of u leaves of y, a share of its squares; y `after` samples later.
double left_by_line(std::span<const double> u, std::span<const double> y,
                    std::size_t after) {
  using Signal = Eigen::Map<const Eigen::ArrayXd>;
  const auto n = static_cast<Eigen::Index>(u.size() - after);
  const Signal from(u.data(), n);
  const Signal to(y.data() + after, n);
  const double covariance = ((from - from.mean()) * (to - to.mean())).sum();
  const double squares =
      (from - from.mean()).square().sum() * (to - to.mean()).square().sum();
  return squares > 0 ? 1 - covariance * covariance / squares : 1;
}

// Where the samples are too far apart to see which of u and y comes first.
bool move_together(std::span<const double> u, std::span<const double> y) {
  constexpr double kMostLeft = 0.2;
  constexpr double kLessThanAfter = 3;
  if (u.size() < 3) return false;
  const double left = left_by_line(u, y, 0);
  return left > 0 && left < kMostLeft && left_by_line(u, y, 1) > kLessThanAfter * left;
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

std::string same_sample_note(const RecordingView& recording) {
  return move_together(recording.u, recording.y)
             ? "y moves with u in the same sample: the process answers faster than it is "
               "sampled, or u follows y. A shorter sample period would tell"
             : "";
}

// A load that climbs and falls between two levels makes of u a triangle that turns where
// the load does, and of y its two slopes: a stem that jumps at every turn, with a band of
// the whole swing, does the same.
std::string wide_band_note(const ident::Identification<double>& result) {
  constexpr double kNearlyAll = 0.75;  // of the usual swing of u
  const ident::Evidence<double>& e = result.evidence;
  const bool ahead = result.reason == ident::Reason::kSticksUnderLoad;
  const double band = ahead ? e.searched.wider_band() : e.band_over_swing;
  return is_fault(result.verdict) && band > kNearlyAll
             ? "the stick band is nearly all that u moves through: a load that climbs "
               "and "
               "falls between two levels, as of a tank with level switches, would look "
               "the same. In manual it goes on, and a sticking valve does not"
             : "";
}

}  // namespace workbench
