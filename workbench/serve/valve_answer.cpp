#include "workbench/serve/valve_answer.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/longest_part.hpp"
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

}  // namespace

namespace {

// What was recorded in one go, between the stretches that are left out; short ends say
// nothing.
std::vector<Recording> parts_of(const Recording& recording) {
  constexpr std::size_t kShortest = 10;  // of the longest, times shorter
  std::vector<Part> parts;
  std::size_t longest = 0;
  std::size_t from = 0;
  const auto add = [&](std::size_t to) {
    if (to > from) parts.push_back({from, to - from, 0});
    longest = std::max(longest, to > from ? to - from : 0);
  };
  const auto add_all = [&](SampleRange piece) {
    from = piece.first;
    for (const SampleRange& range : recording.left_out) {
      if (range.last <= piece.first || range.first >= piece.last) continue;
      add(range.first);
      from = range.last;
    }
    add(piece.last);
  };
  for (const Piece& piece : recording.pieces) add_all({piece.first, piece.last});
  if (recording.pieces.empty()) add_all({0, recording.size()});
  std::vector<Recording> out;
  for (const Part& part : parts) {
    if (kShortest * part.length < longest) continue;
    out.push_back(cut_out(recording, part));
    out.back().pieces.clear();
  }
  return out;
}

ValveAnswer answered(Analysis analysis) {
  Simulation simulation = analysis.simulate();
  return {std::move(analysis), std::move(simulation)};
}

}  // namespace

namespace {

bool in_one_go(const Recording& recording) {
  return recording.left_out.empty() && recording.pieces.size() < 2;
}

}  // namespace

ValveAnswer valve_answer(const Recording& recording, const Progress& progress) {
  return in_one_go(recording) ? answered(Analysis(recording, progress))
                              : answered(Analysis(parts_of(recording), progress));
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
          {"headline", headline(r.verdict)},
          {"reason", ident::sentence(r.reason)},
          {"cause", ident::sentence(r.cause)},
          {"advice", advice(r.reason, r.cause)},
          {"span", span},
          {"detectable_band", identification["detectable_band"]},
          {"band",
           {{"ascending", band_json(r.stick_band.ascending, span)},
            {"descending", band_json(r.stick_band.descending, span)}}},
          {"identification", identification},
          {"picture", picture_json(answer)}};
}

}  // namespace workbench
