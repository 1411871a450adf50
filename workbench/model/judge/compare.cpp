#include "workbench/model/judge/compare.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/views.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kExcess = 0.05;  // more of the error than of the samples, to be told
constexpr std::size_t kLags = 20;

ViewCurve curve_of(const Binning& binning, std::span<const double> residual,
                   std::size_t samples) {
  const std::size_t bins = binning.position.size();
  ViewCurve curve{binning.view, binning.coordinate, binning.position, {}, {}, {}};
  std::vector<double> sum(bins, 0.0);
  std::vector<double> square(bins, 0.0);
  std::vector<double> count(bins, 0.0);
  for (std::size_t k = 0; k < residual.size(); ++k) {
    if (binning.bin[k] < 0) continue;
    const auto i = static_cast<std::size_t>(binning.bin[k]);
    sum[i] += residual[k];
    square[i] += residual[k] * residual[k];
    count[i] += 1;
  }
  const double total = std::max(dot(residual, residual), 1e-300);
  for (std::size_t i = 0; i < bins; ++i) {
    curve.mean.push_back(count[i] > 0 ? sum[i] / count[i] : 0);
    curve.error_share.push_back(square[i] / total);
    curve.sample_share.push_back(count[i] / static_cast<double>(samples));
  }
  return curve;
}

// The run of bins that holds most error beyond its due: maximal sum of the excess.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  double excess = 0;
};
Run worst_run(const ViewCurve& curve) {
  Run best;
  double sum = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < curve.position.size(); ++i) {
    if (sum <= 0) {
      sum = 0;
      first = i;
    }
    sum += curve.error_share[i] - 1.2 * curve.sample_share[i];
    if (sum > best.excess) best = {first, i, sum};
  }
  return best;
}

// The sample `k` by the clock of its file.
double time_of(std::span<const Piece> pieces, double period_s, std::size_t k) {
  const Piece* at = &pieces[0];
  for (const Piece& piece : pieces) {
    if (k >= piece.first) at = &piece;
  }
  return at->start_s + static_cast<double>(k - at->first) * period_s;
}

// The twentieth of the recording with most error among the chosen samples.
void locate(const Binning& binning, const Run& run, std::span<const double> residual,
            const Situation& situation, Failure& failure) {
  const std::size_t n = residual.size();
  const std::size_t window = std::max<std::size_t>(n / 20, 2);
  const auto weight = [&](std::size_t k) {
    const int bin = binning.bin[k];
    const bool inside =
        bin >= static_cast<int>(run.first) && bin <= static_cast<int>(run.last);
    return inside ? residual[k] * residual[k] : 0;
  };
  double sum = 0;
  double most = -1;
  std::size_t at = 0;
  for (std::size_t k = 0; k < n; ++k) {
    sum += weight(k);
    if (k >= window) sum -= weight(k - window);
    if (sum > most) {
      most = sum;
      at = k;
    }
  }
  const std::span<const Piece> pieces = situation.pieces;
  std::size_t first = at >= window ? at - window + 1 : 0;
  for (const Piece& piece : pieces) {
    if (at >= piece.first && at < piece.last) first = std::max(first, piece.first);
    if (at >= piece.first && pieces.front().recording != pieces.back().recording) {
      failure.recording = piece.recording;
    }
  }
  failure.first = first;
  failure.last = at + 1;
  failure.t_from = time_of(pieces, situation.period_s, first);
  failure.t_to = time_of(pieces, situation.period_s, at);
}

// Shares of the squared error by period, in bands a factor of two wide.
ViewCurve spectrum_of(std::span<const double> residual, double period_s,
                      const Work& work) {
  ViewCurve curve{View::kFrequency, "period, s", {}, {}, {}, {}};
  const std::size_t n = residual.size();
  // Differences between moving means of doubling length split the signal into octaves.
  std::vector<double> smooth(residual.begin(), residual.end());
  const double total = std::max(dot(residual, residual), 1e-300);
  for (std::size_t width = 2; width < n / 2; width *= 2) {
    work.check();
    std::vector<double> next(n);
    std::vector<double> sums(n + 1, 0.0);
    for (std::size_t k = 0; k < n; ++k) sums[k + 1] = sums[k] + residual[k];
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t first = k > width / 2 ? k - width / 2 : 0;
      const std::size_t last = std::min(n, k + width / 2 + 1);
      next[k] = (sums[last] - sums[first]) / static_cast<double>(last - first);
    }
    double band = 0;
    for (std::size_t k = 0; k < n; ++k) {
      band += smooth[k] * smooth[k] - next[k] * next[k];
    }
    curve.position.push_back(1.5 * static_cast<double>(width) * period_s);
    curve.mean.push_back(0);
    curve.error_share.push_back(std::max(0.0, band) / total);
    curve.sample_share.push_back(1 / static_cast<double>(width));
    smooth = std::move(next);
  }
  curve.position.push_back(static_cast<double>(n) * period_s);
  curve.mean.push_back(0);
  curve.error_share.push_back(dot(smooth, smooth) / total);
  curve.sample_share.push_back(0);
  return curve;
}

// A run of bins over the time of several pieces.
std::string stretch_in_words(const Situation& situation, std::span<const double> t,
                             const Binning& binning, const Run& run) {
  const double width = binning.position[1] - binning.position[0];
  const auto when = [&](double time) { return situation.when(time - t.front()); };
  return filled("t from {0} to {1}", {when(binning.position[run.first] - width / 2),
                                      when(binning.position[run.last] + width / 2)});
}

// Correlation of the residual with u, both whitened, at lags after u.
ViewCurve lags_of(std::span<const double> residual, std::span<const double> u,
                  double period_s) {
  ViewCurve curve{View::kLag, "lag behind u, s", {}, {}, {}, {}};
  const std::vector<double> e = whitened(colour_of(residual), residual);
  const std::vector<double> w = whitened(colour_of(u), u);
  const double scale = std::sqrt(std::max(dot(e, e) * dot(w, w), 1e-300));
  for (std::size_t lag = 0; lag <= 2 * kLags && lag < e.size(); ++lag) {
    const double r =
        dot(std::span(e).subspan(lag), std::span(w).first(w.size() - lag)) / scale;
    curve.position.push_back(static_cast<double>(lag) * period_s);
    curve.mean.push_back(r);
    curve.error_share.push_back(r * r);
    curve.sample_share.push_back(1 / static_cast<double>(e.size()));
  }
  return curve;
}

Whiteness whiteness_of(const Fit& fit, std::span<const double> u, const Work& work) {
  Whiteness test;
  const auto n = static_cast<double>(fit.residual.size());
  test.bound = kNormal95 / std::sqrt(n);
  test.autocorrelation = autocorrelation(fit.residual, kLags);
  work.check();
  test.white = is_white(fit.residual);
  work.check();
  test.follows_u = follows_u(fit.residual, u);
  work.check();
  const NoiseColour colour = colour_of(fit.residual);
  double sum = 0;
  for (const double a : colour.a) sum += a;
  const double slow = colour.variance / std::max(sum * sum, 1e-6);
  test.effective_samples =
      slow > 0 ? std::min(n, dot(fit.residual, fit.residual) / slow) : n;
  return test;
}

void tell_frequency(const ViewCurve& curve, const Situation& situation,
                    std::vector<Failure>& failures) {
  const auto most = std::max_element(curve.error_share.begin(), curve.error_share.end());
  const auto i = static_cast<std::size_t>(most - curve.error_share.begin());
  if (*most < curve.sample_share[i] + 0.2) return;
  Failure failure;
  failure.view = View::kFrequency;
  failure.share_of_error = *most;
  failure.share_of_samples = curve.sample_share[i];
  failure.where =
      i + 1 == curve.position.size()
          ? filled("slow drift, periods above {0} s", {number(curve.position[i] / 2, 3)})
          : filled("swings with periods around {0} s", {number(curve.position[i], 3)});
  const std::span<const Piece> pieces = situation.pieces;
  failure.t_from = pieces.front().start_s;
  failure.t_to =
      time_of(pieces, situation.period_s, situation.samples() - 1) + situation.period_s;
  failures.push_back(failure);
}

}  // namespace

std::string_view name_of(View view) {
  switch (view) {
    case View::kTime:
      return "time";
    case View::kPhase:
      return "phase";
    case View::kLevel:
      return "level";
    case View::kDirection:
      return "direction";
    case View::kSpeed:
      return "speed";
    case View::kTravel:
      return "travel";
    case View::kFrequency:
      return "frequency";
    case View::kLag:
      return "lag";
  }
  return "time";
}

Comparison compare(const Recording& recording, const Model& model,
                   const Catalogue& catalogue, const Work& work) {
  const Fitter fitter(recording, model.output, work);
  const Fit fit = fitter.apply(model, catalogue);
  Comparison out;
  out.quality = quality(fitter, fit);
  out.effects = model.effect_codes();
  for (const std::string& code : out.effects) {
    const auto is_it = [&code](const Effect* effect) { return effect->code() == code; };
    if (std::none_of(fit.effects.begin(), fit.effects.end(), is_it)) {
      out.stayed_behind.push_back(code);
    }
  }
  out.residual = fit.residual;
  out.simulated = fitter.simulated(fit);
  out.residual_test = whiteness_of(fit, recording.u, work);
  const Situation here = fitter.situation(fit);
  for (Binning& binning : binnings_of(here, recording.t, work)) {
    work.check();
    for (const SampleRange& range : fitter.blocks().left_out()) {
      std::fill(binning.bin.begin() + static_cast<std::ptrdiff_t>(range.first),
                binning.bin.begin() + static_cast<std::ptrdiff_t>(range.last), -1);
    }
    ViewCurve curve = curve_of(binning, fit.residual, fitter.blocks().samples());
    const Run run = worst_run(curve);
    if (run.excess > kExcess) {
      Failure failure;
      failure.view = binning.view;
      failure.where = binning.view == View::kTime && fitter.pieces().size() > 1
                          ? stretch_in_words(here, recording.t, binning, run)
                          : place_in_words(binning, run.first, run.last);
      double weighted = 0;
      for (std::size_t i = run.first; i <= run.last; ++i) {
        failure.share_of_error += curve.error_share[i];
        failure.share_of_samples += curve.sample_share[i];
        weighted += curve.mean[i] * curve.sample_share[i];
      }
      failure.mean_residual = weighted / std::max(failure.share_of_samples, 1e-300);
      locate(binning, run, fit.residual, here, failure);
      out.failures.push_back(std::move(failure));
    }
    out.views.push_back(std::move(curve));
  }
  out.views.push_back(spectrum_of(fit.residual, recording.period_s, work));
  if (!out.residual_test.white) {
    tell_frequency(out.views.back(), here, out.failures);
  }
  out.views.push_back(lags_of(fit.residual, recording.u, recording.period_s));
  std::stable_sort(out.failures.begin(), out.failures.end(),
                   [](const Failure& a, const Failure& b) {
                     return a.share_of_error > b.share_of_error;
                   });
  return out;
}

}  // namespace workbench
