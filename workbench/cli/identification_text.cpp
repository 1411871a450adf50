#include "workbench/cli/identification_text.hpp"

#include <cmath>

#include "workbench/analysis/wording.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

using Estimate = ident::Estimate<double>;

constexpr std::size_t kLabel = 15;  // width of the left column
constexpr std::size_t kBands = 56;  // where a window's stick bands stand

std::string line(std::string_view label, std::string_view text) {
  return padded(label, kLabel) + wrapped(text, kLabel) + '\n';
}

std::string share(const Estimate& estimate, double span) {
  if (!estimate.known || !(span > 0)) return {};
  return fixed(100 * estimate.value / span, 1) + " %";
}

std::string estimate_row(std::string_view label, const Estimate& estimate, double span) {
  const EstimateText text = text_of(estimate);
  return "  " + padded(label, kLabel + 8) + padded(text.value, 10) +
         padded(text.interval, 22) + share(estimate, span) + '\n';
}

bool any_known(const ident::PerStroke<double>& strokes) {
  return strokes.ascending.known || strokes.descending.known;
}

std::string numbers_table(const Analysis& analysis) {
  const Identification& r = analysis.result();
  const double span = analysis.span();
  if (!any_known(r.stick_band) && !any_known(r.slip_jump)) return {};
  return '\n' + std::string(kLabel + 10, ' ') +
         "in u      95 % interval         of the span\n" +
         estimate_row("stick band, ascending", r.stick_band.ascending, span) +
         estimate_row("stick band, descending", r.stick_band.descending, span) +
         estimate_row("slip jump, ascending", r.slip_jump.ascending, span) +
         estimate_row("slip jump, descending", r.slip_jump.descending, span) +
         "  ascending: before the valve moves with rising u; span of u" +
         (analysis.span_is_told() ? " as configured: " : ": ") + number(span, 4) + '\n';
}

std::string detectable_text(const Analysis& analysis) {
  const double band = analysis.result().detectable_band;
  return "a stick band above " + number(band, 3) + " in u, " +
         fixed(100 * band / analysis.span(), 1) + " % of the span, would have shown";
}

// One row a window, where there are several; a second one for its descending stroke.
std::string windows_table(const Analysis& analysis) {
  if (analysis.windows() < 2) return {};
  std::string text =
      "  recording from, s    to, s      evidence  verdict     stick band up\n" +
      std::string(kBands, ' ') + "and down\n";
  const double period_s = analysis.period_s();
  for (const WindowFinding& window : analysis.findings()) {
    text +=
        "  " + padded(std::to_string(window.recording + 1), 10) +
        padded(instant(window.from_s, period_s), 11) +
        padded(instant(window.to_s, period_s), 11) +
        padded(std::isnan(window.nats)
                   ? "too short"
                   : fixed(std::fmax(window.nats, window.stem_nats), 1),
               10) +
        (any_known(window.stick_band)
             ? padded(ident::name(window.verdict), 12) +
                   with_interval(window.stick_band.ascending) + '\n' +
                   std::string(kBands, ' ') + with_interval(window.stick_band.descending)
             : std::string(ident::name(window.verdict))) +
        '\n';
  }
  const auto& together = analysis.pooled();
  const std::string nats = together.predicted == 0 ? "none counts"
                           : together.nats > 0     ? fixed(together.nats, 1)
                                                   : "for no stick band";
  return text + "  one band for all" + std::string(16, ' ') + nats + "\n\n" +
         line("Evidence",
              "how much better a sticking valve foretells y than one that follows u, in "
              "nats: 0 or below is no better, 10 is beyond chance. The verdict weighs "
              "what else looks alike, too.");
}

std::string oscillation_text(const Identification& r, double period_s) {
  if (r.reason == ident::Reason::kOneStroke) return "u turns back too little to tell";
  if (!r.oscillation.detected) {
    const double regularity = r.oscillation.regularity;
    return regularity > 1    ? "none: u repeats itself, but hardly turns back"
           : regularity == 0 ? "none seen in u, no two cycles to compare"
                             : "none seen in u (regularity " + fixed(regularity, 1) + ")";
  }
  return "of u, period " + duration(r.oscillation.period_samples * period_s) + ", " +
         fixed(r.cycles, 0) + " cycles, regularity " +
         fixed(r.oscillation.regularity, 1) + " (regular above 1)";
}

std::string fit_text(const Identification& r) {
  std::string text;
  if (r.valve.known) {
    text += fixed(r.fit_valve_percent, 1) + " % physical valve, ";
  }
  return text + fixed(r.fit_percent, 1) + " % two-path model, " +
         fixed(r.fit_linear_percent, 1) +
         " % a valve that follows its signal (100 = y follows from u alone)";
}

// When it began and in what units, as far as the file says.
std::string origin_text(const RecordingView& recording) {
  std::string text = recording.tags.empty() ? "" : ", " + recording.tags;
  if (!recording.start.empty()) text += ", from " + recording.start;
  for (const Column column : {Column::u, Column::y}) {
    const std::string& unit = recording.unit(column);
    if (!unit.empty()) text += ", " + std::string(name_of(column)) + " in " + unit;
  }
  return text;
}

// What comes before the name of the recording where it is one of several.
std::string first_of(const Analysis& analysis) {
  const std::size_t last = analysis.findings().back().recording;
  return last == 0 ? ""
                   : "The first of " + std::to_string(last + 1) + " recordings with " +
                         std::to_string(analysis.samples()) + " samples in all, ";
}

}  // namespace

std::string with_interval(const ident::Estimate<double>& estimate) {
  const EstimateText text = text_of(estimate);
  return text.value + (text.interval.empty() ? "" : " (" + text.interval + ")");
}

std::string identification_text(const RecordingView& recording,
                                const Analysis& analysis) {
  const Identification& r = analysis.result();
  std::string text =
      wrapped(first_of(analysis) + recording.name + ": " +
                  std::to_string(recording.size()) + " samples, one every " +
                  number(recording.period_s) + " s, " +
                  duration(recording.period_s * static_cast<double>(recording.size())) +
                  origin_text(recording),
              0) +
      "\n\n" + std::string(headline_of(r)) + '\n' + numbers_table(analysis) + '\n' +
      windows_table(analysis);
  text += line("Why", ident::sentence(r.reason));
  if (r.evidence.ladder.predicted > 0 && r.detectable_band > 0) {
    text += line("Seen", detectable_text(analysis));
  }
  text += line("Oscillation", oscillation_text(r, analysis.period_s()));
  if (!ident::sentence(r.cause).empty()) text += line("Cause", ident::sentence(r.cause));
  if (has_model(r)) text += line("Explained", fit_text(r));
  const std::string_view next = advice_of(r);
  if (!next.empty()) text += line("What to do", next);
  for (const std::string& note : recording.notes) text += line("Note", note);
  for (const std::string& note : analysis.notes()) text += line("Note", note);
  return text;
}

int exit_code_for(ident::Verdict verdict, ident::Reason reason, bool is_told) {
  if (verdict != ident::Verdict::kUndecided && verdict != ident::Verdict::kBadData) {
    return kDone;
  }
  if (is_told && is_read_beside_messages()) return kCannotAnswer;
  return cannot_answer(ident::sentence(reason));
}

}  // namespace workbench::cli
