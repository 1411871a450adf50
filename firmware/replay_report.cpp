#include "firmware/replay_report.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "firmware/notice_text.hpp"
#include "wire/diagnostics.hpp"
#include "wire/text.hpp"

namespace firmware {
namespace {

using Json = nlohmann::ordered_json;

std::string number_text(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

std::string_view choice_name(std::span<const wire::Choice> choices, double value) {
  for (const wire::Choice& choice : choices) {
    if (choice.value == value) return choice.name;
  }
  return {};
}

// Without a fraction where there is none: 98, not 98.0.
Json json_number(double value) {
  constexpr double kExact = 9'007'199'254'740'992;  // 2⁵³
  if (std::abs(value) < kExact && value == std::trunc(value)) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

Json json_value(const wire::LoopField& field, std::optional<double> number) {
  if (!number) return nullptr;
  const std::string_view name = choice_name(field.choices, *number);
  if (!name.empty()) return std::string(name);
  return json_number(*number);
}

// The shortest decimal that reads back as the same float: no more digits are printed than
// there are.
Json shortest(float value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double out = static_cast<double>(value);
  (void)std::from_chars(text.data(), end, out);
  return json_number(out);
}

Json band_json(const ident::Estimate<float>& e) {
  if (!e.known) return {{"value", nullptr}, {"low", nullptr}, {"high", nullptr}};
  return {
      {"value", shortest(e.value)}, {"low", shortest(e.low)}, {"high", shortest(e.high)}};
}

Json strokes_json(const ident::PerStroke<float>& strokes) {
  return {{"ascending", band_json(strokes.ascending)},
          {"descending", band_json(strokes.descending)}};
}

std::string value_text(const wire::LoopField& field, std::optional<double> number) {
  if (!number) return "not available";
  const std::string_view name = choice_name(field.choices, *number);
  if (!name.empty()) return std::string(name);
  return number_text(*number) + (field.unit.empty() ? "" : " " + std::string(field.unit));
}

std::string hex_of(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    std::array<char, 4> two;
    std::snprintf(two.data(), two.size(), "%02X", byte);
    text += two.data();
  }
  return text;
}

// The numbers of a loop's object, read from the bytes of the answer.
template <class Take>
void decode_object(int offset, std::span<const std::uint8_t> data, Take take) {
  for (const wire::LoopField& field : wire::loop_fields()) {
    if (field.object != offset || !field.number) continue;
    const std::size_t size = wire::size_of(field.type);
    if (data.size() < size) return;
    std::uint64_t raw = 0;
    for (const std::uint8_t byte : data.first(size)) raw = raw << 8 | byte;
    data = data.subspan(size);
    take(field, wire::from_raw(field.type, field.scale, raw));
  }
}

Json interval_json(double low, double high) {
  return {{"low", json_number(low)}, {"high", json_number(high)}};
}

Json intervals_json(const Notice& notice) {
  const wire::StrokeValues& low = notice.band_low_pct;
  const wire::StrokeValues& high = notice.band_high_pct;
  return {{"ascending", interval_json(low.ascending, high.ascending)},
          {"descending", interval_json(low.descending, high.descending)}};
}

void put_event(const ident::Event<float>& event, double period_s, Json& line) {
  switch (event.kind) {
    case ident::EventKind::kStictionRaised:
    case ident::EventKind::kStictionCleared:
      line["verdict"] = ident::name(event.verdict);
      line["reason"] = ident::sentence(event.reason);
      line["stick_band"] = strokes_json(event.stick_band);
      line["slip_jump"] = strokes_json(event.slip_jump);
      break;
    case ident::EventKind::kUndecided:
      line["reason"] = ident::sentence(event.reason);
      break;
    default:
      line["period_s"] = shortest(
          static_cast<float>(static_cast<double>(event.period_samples) * period_s));
      break;
  }
}

}  // namespace

std::vector<std::uint8_t> bytes_of(std::string_view hex) {
  std::vector<std::uint8_t> bytes;
  int high = -1;
  for (const char c : hex) {
    if (c == ' ') continue;
    const int digit = wire::hex_value(c);
    if (digit < 0) return {};
    if (high < 0) {
      high = digit;
    } else {
      bytes.push_back(static_cast<std::uint8_t>(high << 4 | digit));
      high = -1;
    }
  }
  return high < 0 ? bytes : std::vector<std::uint8_t>{};
}

std::string event_line(const Notice& notice, double t_s, const config::Gateway& gateway,
                       bool json) {
  if (!json) {
    std::array<char, 32> time;
    std::snprintf(time.data(), time.size(), "%12.1f s  ", t_s);
    return time.data() + std::string(text_of(notice, gateway).view()) + '\n';
  }
  Json line = {{"t", json_number(t_s)}, {"event", name_of(notice)}};
  if (notice.kind == NoticeKind::kAccess) {
    line["what"] = text_of(notice, gateway).c_str();
    return line.dump() + '\n';
  }
  if (notice.kind == NoticeKind::kGap) {
    line["seconds"] = json_number(notice.gap_s);
    return line.dump() + '\n';
  }
  if (notice.kind >= NoticeKind::kBusUp) {
    line["bus"] = gateway.buses[notice.index].name;
    return line.dump() + '\n';
  }
  const config::Loop& loop = gateway.loops[notice.index];
  line["loop"] = loop.id;
  line["tag"] = loop.tag;
  if (notice.kind == NoticeKind::kInputFault ||
      notice.kind == NoticeKind::kInputRestored) {
    line["fault"] = name_of(notice.input);
  } else if (notice.kind == NoticeKind::kBandChanged) {
    line["stick_band_pct"] = intervals_json(notice);
  } else if (notice.kind == NoticeKind::kTrend) {
    line["pct_per_day"] = {{"value", json_number(notice.trend.slope)},
                           {"low", json_number(notice.trend.low)},
                           {"high", json_number(notice.trend.high)}};
    line["days_to_limit"] = json_number(notice.trend.days);
  } else if (notice.kind == NoticeKind::kSlowSignal) {
    line["signal"] = name_of(notice.slow.role);
    line["interval_s"] = shortest(static_cast<float>(notice.slow.interval_s));
  } else if (notice.kind == NoticeKind::kTwoSenders) {
    line["signal"] = name_of(notice.senders.role);
    line["source_addresses"] = {notice.senders.used, notice.senders.other};
  } else if (notice.kind == NoticeKind::kSuspended ||
             notice.kind == NoticeKind::kResumed) {
    line["mode"] = json_number(notice.mode);
  } else if (notice.kind == NoticeKind::kSpanDoubted) {
    line["u"] = interval_json(notice.u_range[0], notice.u_range[1]);
  } else if (notice.kind == NoticeKind::kMonitor) {
    put_event(notice.event, loop.sample_period_s, line);
  }
  return line.dump() + '\n';
}

std::string summary_line(const Replay& replay, std::size_t loop, bool json) {
  const wire::LoopStatus& status = replay.daemon().loops()[loop];
  const hal::FakeOutput& line = replay.line(loop);
  if (json) {
    Json out = {{"event", "summary"}, {"loop", status.id}};
    out["tag"] = std::string(status.tag.view());
    out["stiction_raised"] = status.flag;
    out["gpio"] = line.is_open ? Json(line.level ? 1 : 0) : Json(nullptr);
    for (const wire::LoopField& field : wire::loop_fields()) {
      if (field.number) {
        out[std::string(field.name)] = json_value(field, wire::shown(field, status));
      }
    }
    return out.dump() + '\n';
  }
  std::string text =
      "\nloop " + std::to_string(status.id) + ' ' + std::string(status.tag.view()) + '\n';
  for (const wire::LoopField& field : wire::loop_fields()) {
    if (!field.number || (field.object != 0 && field.object != 3)) continue;
    const std::string name(field.name);
    text += "  " + name + std::string(name.size() < 28 ? 28 - name.size() : 1, ' ') +
            value_text(field, wire::shown(field, status)) + '\n';
  }
  if (status.mode == wire::LoopMode::kManual) {
    const double mode = replay.daemon().loop(loop).live(Role::kMode);
    const config::Loop& configured = replay.daemon().configuration().loops[loop];
    text += "  evaluation                  " +
            std::string(text_of_mode(configured, true, mode).view()) + '\n';
  }
  return text + "  flag                        " + (status.flag ? "raised" : "down") +
         (line.is_open ? (line.level ? ", line active" : ", line inactive")
                       : ", no line") +
         '\n';
}

std::string answer_line(std::span<const std::uint8_t> request,
                        std::span<const std::uint8_t> answer, bool json) {
  const bool object = answer.size() > 3 && request.size() == 3 && answer[0] == 0x62 &&
                      answer[1] == 0xFD && answer[2] >= 0x10;
  const int offset = object ? answer[2] & 0x0F : -1;
  if (json) {
    Json out = {{"event", "answer"}, {"request", hex_of(request)}};
    out["answer"] = answer.empty() ? Json(nullptr) : Json(hex_of(answer));
    if (object) {
      decode_object(offset, answer.subspan(3), [&](const auto& field, auto number) {
        out["fields"][std::string(field.name)] = json_value(field, number);
      });
    }
    return out.dump() + '\n';
  }
  const std::string hex = hex_of(answer);
  constexpr std::size_t kMostDigits = 56;
  std::string text = "\n" + hex_of(request) + " -> " +
                     (answer.empty()              ? "no answer"
                      : hex.size() <= kMostDigits ? hex
                                                  : hex.substr(0, kMostDigits) + " ...") +
                     '\n';
  if (object) {
    decode_object(offset, answer.subspan(3), [&](const auto& field, auto number) {
      const std::string name(field.name);
      text += "  " + name + std::string(name.size() < 28 ? 28 - name.size() : 1, ' ') +
              value_text(field, number) + '\n';
    });
  }
  return text;
}

}  // namespace firmware
