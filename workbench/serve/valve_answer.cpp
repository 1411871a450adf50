#include "workbench/serve/valve_answer.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/uncut_parts.hpp"
#include "workbench/analysis/wording.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;
using Values = std::vector<double>;

constexpr double kPictureCycles = 4;

Json band_json(const ident::Estimate<double>& band, double span) {
  if (!band.known || !(span > 0)) return nullptr;
  const double percent = 100 / span;
  return {{"value", band.value},
          {"low", band.low},
          {"high", band.high},
          {"percent", percent * band.value},
          {"percent_low", percent * band.low},
          {"percent_high", percent * band.high}};
}

struct Pictured {
  std::size_t first;
  std::size_t last;
  std::size_t every;
};

Pictured pictured(const ValveAnswer& answer) {
  const std::size_t size = answer.simulation.t.size();
  const auto& oscillation = answer.analysis.result().oscillation;
  std::size_t length = size;
  if (oscillation.detected) {
    length = std::min(
        size, static_cast<std::size_t>(kPictureCycles * oscillation.period_samples));
  }
  const std::size_t first = (size - length) / 2;
  return {first, first + length,
          (length + kMostPictureSamples - 1) / kMostPictureSamples};
}

Json picture_json(const ValveAnswer& answer) {
  const Simulation& s = answer.simulation;
  if (s.t.empty()) return nullptr;
  const Pictured part = pictured(answer);
  Json out = {{"period_s", s.period_s}};
  const auto add = [&](const char* name, const Values& values) {
    if (values.empty()) return;
    Json& list = out[name] = Json::array();
    for (std::size_t k = part.first; k < part.last; k += part.every) {
      list.push_back(values[k]);
    }
  };
  add("t", s.t);
  add("u", s.u);
  add("y", s.y);
  add("sp", s.sp);
  add("stem", s.stem);
  add("x", s.x);
  return out;
}

ValveAnswer answered(Analysis analysis) {
  Simulation simulation = analysis.simulate();
  return {std::move(analysis), std::move(simulation)};
}

}  // namespace

ValveAnswer valve_answer(const Recording& recording, const Progress& progress) {
  return in_one_go(recording) ? answered(Analysis(recording, progress))
                              : answered(Analysis(uncut_parts(recording), progress));
}

bool takes_long(const Recording& recording) {
  return recording.size() > 2 * Identifier::kCapacity && in_one_go(recording);
}

ValveAnswer first_answer(const Recording& recording, const Progress& progress) {
  return answered(Analysis(recording, progress, 1));
}

std::string_view mood_name(ident::Verdict verdict) {
  switch (verdict) {
    case ident::Verdict::kStiction:
    case ident::Verdict::kBacklash:
      return "bad";
    case ident::Verdict::kNoStiction:
      return "good";
    case ident::Verdict::kUndecided:
    case ident::Verdict::kBadData:
      break;
  }
  return "open";
}

Json valve_json(const Recording& recording, const ValveAnswer& answer) {
  const Identification& r = answer.analysis.result();
  const double span = answer.analysis.span();
  const Json identification = identification_json(recording, answer.analysis);
  return {{"schema", 1},
          {"verdict", ident::name(r.verdict)},
          {"mood", mood_name(r.verdict)},
          {"headline", headline_of(r)},
          {"reason", ident::sentence(r.reason)},
          {"cause", ident::sentence(r.cause)},
          {"advice", advice_of(r)},
          {"span", span},
          {"detectable_band", identification["detectable_band"]},
          {"band",
           {{"ascending", band_json(r.stick_band.ascending, span)},
            {"descending", band_json(r.stick_band.descending, span)}}},
          {"identification", identification},
          {"picture", picture_json(answer)}};
}

}  // namespace workbench
