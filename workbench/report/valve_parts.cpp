#include "workbench/report/valve_parts.hpp"

#include "workbench/analysis/wording.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/page_parts.hpp"

namespace workbench {
namespace {

using Estimate = ident::Estimate<double>;

Mood mood(ident::Verdict verdict) {
  switch (verdict) {
    case ident::Verdict::kStiction:
    case ident::Verdict::kBacklash:
      return Mood::kBad;
    case ident::Verdict::kNoStiction:
      return Mood::kGood;
    case ident::Verdict::kUndecided:
    case ident::Verdict::kBadData:
      break;
  }
  return Mood::kOpen;
}

std::string band_tile(const char* label, const Estimate& estimate, double span) {
  if (!estimate.known) return {};
  const EstimateText t = text_of(estimate);
  return tile(label, t.value,
              "95 %: " + t.interval + " · " + fixed(100 * estimate.value / span, 1) +
                  " % of the range of u");
}

}  // namespace

std::string valve_verdict(const ReportData& data) {
  const Identification& r = data.analysis.result();
  return verdict_box(mood(r.verdict), headline_of(r),
                     {{"", std::string(ident::sentence(r.reason))},
                      {"Cause.", std::string(ident::sentence(r.cause))},
                      {"What to do.", std::string(advice_of(r))}});
}

std::string valve_tiles(const ReportData& data) {
  const Identification& r = data.analysis.result();
  const double span = data.analysis.span();
  std::string out = band_tile("Stick band, ascending", r.stick_band.ascending, span) +
                    band_tile("Stick band, descending", r.stick_band.descending, span);
  if (r.detectable_band > 0 && !r.stick_band.ascending.known) {
    out += tile("Would have shown", "above " + number(r.detectable_band, 3),
                "a stick band of " + fixed(100 * r.detectable_band / span, 1) +
                    " % of the range of u or more");
  }
  const auto& o = r.oscillation;
  out += o.detected
             ? tile("Oscillation period of u",
                    duration(o.period_samples * data.analysis.period_s()),
                    fixed(r.cycles, 0) + " cycles, regularity " + fixed(o.regularity, 1))
             : tile("Oscillation", "none", "regularity " + fixed(o.regularity, 1));
  if (has_model(r)) {
    const double valve = r.valve.known ? r.fit_valve_percent : r.fit_percent;
    out += tile("Explained by the valve", fixed(valve, 1) + " %",
                filled("from u alone; {0} % by a valve that follows u",
                       {fixed(r.fit_linear_percent, 1)}));
  }
  return tile_row(out);
}

}  // namespace workbench
