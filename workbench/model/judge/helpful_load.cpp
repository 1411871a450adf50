#include "workbench/model/judge/helpful_load.hpp"

#include <algorithm>
#include <utility>

#include "workbench/effects/effects.hpp"
#include "workbench/effects/process_shape.hpp"
#include "workbench/model/base/noise.hpp"
#include "workbench/model/base/shortened.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/recording/further_signals.hpp"
#include "workbench/recording/own_readings.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr double kSignificance = 0.005;  // of all signals together
constexpr std::size_t kClosest = 3;      // signals that are fitted
constexpr double kSameSignal = 0.98;     // squared correlation
constexpr double kLikeOutput = 0.8;      // perhaps another reading of what y reads

// Of the signal behind no lag, a short one, or that of the process, with the residual.
double likeness(const std::vector<double>& values, const Fit& fit, double period_s) {
  const double process_s = fit.process_value("first_lag").value_or(10 * period_s);
  double most = 0;
  std::vector<double> behind(values.size());
  for (const double share : {0.0, 0.2, 1.0}) {
    lag(values, period_s, std::max(share * process_s, period_s / 10), values.front(),
        behind);
    most = std::max(most, squared_correlation(behind, fit.residual));
  }
  return most;
}

std::vector<const Load*> closest_loads(const Fitter& fitter, const Fit& base) {
  const Recording& recording = fitter.recording();
  std::vector<std::pair<double, const Load*>> scored;
  for (const Load& load : recording.loads) {
    const double score = likeness(load.values, base, recording.period_s);
    if (!(score > 0)) continue;
    const bool may_be_reading =
        squared_correlation(load.values, fitter.y()) > kLikeOutput;
    scored.emplace_back(may_be_reading ? score - 1 : score, &load);
  }
  std::ranges::stable_sort(scored, std::ranges::greater(),
                           &std::pair<double, const Load*>::first);
  scored.resize(std::min(kClosest, scored.size()));
  std::vector<const Load*> out;
  for (const auto& [score, load] : scored) out.push_back(load);
  return out;
}

std::optional<HelpfulLoad> best_of(const Fitter& fitter, const Fit& base) {
  const auto many = static_cast<double>(fitter.recording().loads.size());
  std::optional<HelpfulLoad> best;
  for (const Load* load : closest_loads(fitter, base)) {
    const Effect& effect = effects::disturbance_measured(load->name);
    const auto fit = fitter.extend(base, effect, Effort::kScreen);
    if (!fit || !lowers_error(fitter, base, *fit) || !is_possible(fitter, *fit, effect)) {
      continue;
    }
    // Two slow signals look alike by chance from end to end, not from one sample to the
    // next.
    const DifferenceTest ahead = test_given_past(
        base.residual, fit->residual, fitter.situation(*fit).u, fitter.blocks());
    const DifferenceTest test =
        test_difference(base.residual, fit->residual, fitter.blocks());
    if (many * std::max(test.p_steady, ahead.p_value) > kSignificance) continue;
    const double left = fitter.rmse_on(*fit, false) / fitter.rmse_on(base, false);
    const double share = 1 - left * left;
    if (!best || share > best->share) best = {load->name, share};
  }
  return best;
}

}  // namespace

std::optional<HelpfulLoad> helpful_load(const Recording& recording, const Model& model,
                                        const std::vector<Load>& unused,
                                        const Work& work) {
  Recording asked = recording;
  for (const Load& load : unused) {
    if (load.values.size() == recording.size() && !is_count(load.values) &&
        !is_own_reading(recording, load, kSameSignal)) {
      asked.loads.push_back(load);
    }
  }
  if (asked.loads.size() == recording.loads.size()) return std::nullopt;
  const Catalogue catalogue = standard_catalogue().with(asked.loads);
  const Fitter whole(asked, model.output, work);
  const Fit fit = whole.apply(model, catalogue);
  if (!is_long(asked)) return best_of(whole, fit);
  const Shortened fewer = shortened(asked, model.output);
  const Fitter quick(fewer.recording, model.output, work);
  return best_of(quick, quick.on_the_short(fit, fewer));
}

}  // namespace workbench
