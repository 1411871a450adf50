#include "workbench/screen/screened_loop.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "workbench/analysis/identification_json.hpp"

namespace workbench {
namespace {

using Ordered = nlohmann::ordered_json;
using Json = nlohmann::json;

template <class Any>
Any number_or_null(double value, bool known) {
  return known && std::isfinite(value) ? Any(value) : Any(nullptr);
}

Ordered known(double value) {
  return number_or_null<Ordered>(value, true);
}

template <class Any>
Any text_or_null(const std::string& text) {
  return text.empty() ? Any(nullptr) : Any(text);
}

double number_of(const Json& json) {
  return json.is_number() ? json.get<double>() : std::nan("");
}

Json estimates(const ident::PerStroke<double>& strokes) {
  const auto one = [](const ident::Estimate<double>& e) {
    return Json{e.known, e.value, e.low, e.high};
  };
  return {one(strokes.ascending), one(strokes.descending)};
}

ident::PerStroke<double> estimates(const Json& json) {
  const auto one = [](const Json& e) {
    return ident::Estimate<double>{e.at(0).get<bool>(), e.at(1).get<double>(),
                                   e.at(2).get<double>(), e.at(3).get<double>()};
  };
  return {one(json.at(0)), one(json.at(1))};
}

// A signal of the rhythm as 12-bit numbers, two characters each.
std::string packed(const std::vector<float>& values) {
  std::string out;
  if (values.empty()) return out;
  const auto [low, high] = std::ranges::minmax_element(values);
  const float range = *high - *low;
  for (const float value : values) {
    const int level =
        range > 0 ? static_cast<int>(std::lround((value - *low) / range * 4095)) : 0;
    out += static_cast<char>('0' + level / 64);
    out += static_cast<char>('0' + level % 64);
  }
  return out;
}

std::vector<float> unpacked(const std::string& text) {
  std::vector<float> out;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    out.push_back(static_cast<float>((text[i] - '0') * 64 + (text[i + 1] - '0')) / 4095);
  }
  return out;
}

Ordered trend_json(const std::vector<Stretch>& trend) {
  Ordered out = Ordered::array();
  for (const Stretch& stretch : trend) {
    out.push_back({{"month", stretch.name},
                   {"verdict", stretch.verdict},
                   {"nats", known(stretch.nats)},
                   {"stick_band", known(stretch.stick_band)},
                   {"oscillating_share", stretch.oscillating}});
  }
  return out;
}

// What a journal carries as it stands.
constexpr auto kFields =
    std::tuple{std::pair{"loop", &ScreenedLoop::loop},
               std::pair{"files", &ScreenedLoop::files},
               std::pair{"error", &ScreenedLoop::error},
               std::pair{"verdict", &ScreenedLoop::verdict},
               std::pair{"reason", &ScreenedLoop::reason},
               std::pair{"cause", &ScreenedLoop::cause},
               std::pair{"unit", &ScreenedLoop::unit},
               std::pair{"detectable_band", &ScreenedLoop::detectable_band},
               std::pair{"span", &ScreenedLoop::span},
               std::pair{"error_ratio", &ScreenedLoop::error_ratio},
               std::pair{"regularity", &ScreenedLoop::regularity},
               std::pair{"windows", &ScreenedLoop::windows},
               std::pair{"period_s", &ScreenedLoop::period_s},
               std::pair{"oscillating_share", &ScreenedLoop::oscillating_share},
               std::pair{"samples", &ScreenedLoop::samples},
               std::pair{"sample_period_s", &ScreenedLoop::sample_period_s},
               std::pair{"from", &ScreenedLoop::from},
               std::pair{"notes", &ScreenedLoop::notes}};

}  // namespace

Ordered json_of(const ScreenedLoop& loop) {
  const bool answered = loop.error.empty();
  const auto either = [answered](Ordered value) {
    return answered ? std::move(value) : Ordered(nullptr);
  };
  return {
      {"schema", 1},
      {"loop", loop.loop},
      {"files", loop.files},
      {"u", text_or_null<Ordered>(loop.u_tag)},
      {"y", text_or_null<Ordered>(loop.y_tag)},
      {"verdict", text_or_null<Ordered>(loop.verdict)},
      {"reason", text_or_null<Ordered>(loop.reason)},
      {"cause", text_or_null<Ordered>(loop.cause)},
      {"stick_band", json_of(loop.stick_band)},
      {"slip_jump", json_of(loop.slip_jump)},
      {"unit", text_or_null<Ordered>(loop.unit)},
      {"detectable_band",
       {{"value",
         number_or_null<Ordered>(loop.detectable_band, loop.detectable_band > 0)},
        {"percent_of_span",
         number_or_null<Ordered>(100 * loop.detectable_band / loop.span,
                                 loop.detectable_band > 0 && loop.span > 0)}}},
      {"evidence",
       {{"nats", known(answered ? loop.nats : std::nan(""))},
        {"stem_nats", known(answered ? loop.stem_nats : std::nan(""))},
        {"windows", loop.windows}}},
      {"period_s", number_or_null<Ordered>(loop.period_s, loop.period_s > 0)},
      {"oscillating_share", either(loop.oscillating_share)},
      {"suspicion", either(loop.suspicion)},
      {"cost", either(loop.cost)},
      {"trend", trend_json(loop.trend)},
      {"group", loop.group > 0 ? Ordered(loop.group) : Ordered(nullptr)},
      {"leads", loop.leads},
      {"group_is", text_or_null<Ordered>(loop.group_is)},
      {"lag_s", loop.group > 0 ? Ordered(loop.lag_s) : Ordered(nullptr)},
      {"samples", either(loop.samples)},
      {"sample_period_s", either(loop.sample_period_s)},
      {"from", text_or_null<Ordered>(loop.from)},
      {"notes", loop.notes},
      {"error", text_or_null<Ordered>(loop.error)},
  };
}

Json journal_json(const ScreenedLoop& loop) {
  Json trend = Json::array();
  for (const Stretch& s : loop.trend) {
    trend.push_back({s.name, s.verdict, number_or_null<Json>(s.nats, true),
                     number_or_null<Json>(s.stick_band, true), s.oscillating});
  }
  const Rhythm& r = loop.rhythm;
  Json out = {
      {"tags", {loop.u_tag, loop.y_tag}},
      {"stick_band", estimates(loop.stick_band)},
      {"slip_jump", estimates(loop.slip_jump)},
      {"nats", number_or_null<Json>(loop.nats, true)},
      {"stem_nats", number_or_null<Json>(loop.stem_nats, true)},
      {"trend", trend},
      {"rhythm",
       {r.period_s, r.start_s, r.step_s, r.clock, r.zone, packed(r.u), packed(r.y)}},
      {"picture", {loop.picture_u, loop.picture_y}}};
  const auto put = [&](const auto&... field) {
    ((out[field.first] = loop.*field.second), ...);
  };
  std::apply(put, kFields);
  return out;
}

ScreenedLoop from_journal(const Json& json) {
  ScreenedLoop out;
  const auto take = [&](const auto&... field) {
    (json.at(field.first).get_to(out.*field.second), ...);
  };
  std::apply(take, kFields);
  out.u_tag = json.at("tags").at(0);
  out.y_tag = json.at("tags").at(1);
  out.stick_band = estimates(json.at("stick_band"));
  out.slip_jump = estimates(json.at("slip_jump"));
  out.nats = number_of(json.at("nats"));
  out.stem_nats = number_of(json.at("stem_nats"));
  for (const Json& s : json.at("trend")) {
    out.trend.push_back({s.at(0), s.at(1), number_of(s.at(2)), number_of(s.at(3)),
                         s.at(4).get<double>()});
  }
  const Json& r = json.at("rhythm");
  out.rhythm = {r.at(0).get<double>(),
                r.at(1).get<double>(),
                r.at(2).get<double>(),
                r.at(3).get<std::string>(),
                r.at(4).get<std::string>(),
                unpacked(r.at(5).get<std::string>()),
                unpacked(r.at(6).get<std::string>())};
  out.picture_u = json.at("picture").at(0);
  out.picture_y = json.at("picture").at(1);
  return out;
}

std::string picture_of(const std::vector<double>& values, std::size_t first) {
  if (first >= values.size()) return {};
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  const auto [low, high] = std::minmax_element(begin, values.end());
  if (!(*high > *low)) return {};
  const std::size_t count = values.size() - first;
  const std::size_t points = std::min(count, ScreenedLoop::kPicturePoints);
  std::string out;
  for (std::size_t k = 0; k < points; ++k) {
    const double value = values[first + k * count / points];
    const auto level =
        static_cast<int>(std::lround((value - *low) / (*high - *low) * 93));
    out += static_cast<char>('!' + level);
  }
  return out;
}

}  // namespace workbench
