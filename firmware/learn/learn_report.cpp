#include "firmware/learn/learn_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "config/source_reader.hpp"
#include "firmware/learn/braille_plot.hpp"

namespace firmware {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPlotColumns = 66;
constexpr std::size_t kPlotRows = 3;
constexpr std::size_t kMostSignals = 40;
constexpr double kOften = 0.05;  // share of the frames in which a byte changes

[[gnu::format(printf, 1, 2)]] std::string print(const char* format, ...) {
  char text[256];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

// "X" a byte that changes often, "x" seldom, "." never.
std::string changing_bytes(const SurveyedFrame& frame) {
  std::string out;
  for (std::size_t k = 0; k < frame.longest; ++k) {
    const double share = static_cast<double>(frame.changes[k]) /
                         static_cast<double>(std::max<std::uint64_t>(frame.count, 2) - 1);
    out += share >= kOften ? 'X' : share > 0 ? 'x' : '.';
  }
  return out;
}

std::string frames_table(const FrameSurvey& survey) {
  std::string out =
      "  bus      id          frames    per s  bytes  which change\n"
      "                                               (X often, x seldom, . never)\n";
  for (const SurveyedFrame* frame : survey.all()) {
    const std::string length =
        frame->shortest == frame->longest
            ? std::to_string(frame->longest)
            : std::to_string(frame->shortest) + '-' + std::to_string(frame->longest);
    const std::string head = print("  %-8.8s %-8s%10llu %8.3g  %5s  ", frame->bus.c_str(),
                                   config::hex_id(frame->id, frame->extended).c_str(),
                                   static_cast<unsigned long long>(frame->count),
                                   frame->rate_hz(), length.c_str());
    const std::string bytes = changing_bytes(*frame);
    constexpr std::size_t kPerLine = 32;
    for (std::size_t at = 0; at < std::max<std::size_t>(bytes.size(), 1);
         at += kPerLine) {
      out += at == 0 ? head : std::string(head.size(), ' ');
      out += bytes.substr(at, kPerLine) + (at == 0 && frame->fd ? "  FD" : "") + '\n';
    }
  }
  if (survey.passed_over() > 0) {
    out += print("  %llu frames of further identifiers were passed over\n",
                 static_cast<unsigned long long>(survey.passed_over()));
  }
  return out;
}

std::string range_text(const SeenSignal& signal) {
  return print("%.5g … %.5g", signal.low, signal.high) +
         (signal.unit.empty() ? "" : ' ' + signal.unit);
}

// Columns that the text takes in a terminal.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(std::string text, std::size_t columns) {
  const std::size_t width = width_of(text);
  if (width < columns) text.append(columns - width, ' ');
  return text;
}

std::string signals_table(const Learned& learned) {
  constexpr std::size_t kTrace = 22;
  std::string out;
  std::size_t still = 0;
  std::size_t shown = 0;
  for (const SeenSignal& signal : learned.signals) {
    if (!(signal.high > signal.low)) {
      ++still;
      continue;
    }
    if (++shown > kMostSignals) continue;
    out += "  " + padded(signal.title().substr(0, 27), 28) +
           padded(range_text(signal), 27) + braille_plot(signal.value, kTrace, 1)[0] +
           '\n';
  }
  if (shown > kMostSignals) {
    out += "  … and " + std::to_string(shown - kMostSignals) + " more; --json has all\n";
  }
  if (still > 0) out += "  " + std::to_string(still) + " more stand still\n";
  return out;
}

std::string plot(const char* label, const SeenSignal& signal) {
  std::string out = std::string("  ") + label + "  " + signal.title() + '\n';
  const auto lines = braille_plot(signal.value, kPlotColumns, kPlotRows);
  for (std::size_t row = 0; row < lines.size(); ++row) {
    const bool first = row == 0;
    const bool last = row + 1 == lines.size();
    const std::string axis = first  ? print("%8.5g ", signal.high)
                             : last ? print("%8.5g ", signal.low)
                                    : std::string(9, ' ');
    out += "  " + axis + lines[row] + '\n';
  }
  return out;
}

std::string reasons(const LoopProposal& loop) {
  std::string out = print("  y follows u %.3g s later (correlation %.2f). ", loop.lag_s,
                          loop.correlation);
  out += loop.controller_pct >= 60
             ? print(
                   "%.0f %% of the moves of u follow\n"
                   "  from y as a controller computes them (of y from u: %.0f %%).\n",
                   loop.controller_pct, std::max(loop.process_pct, 0.0))
             : print(
                   "Little shows which of the\n"
                   "  two is u: %.0f %% of its moves follow from y, %.0f %% the other "
                   "way round.\n",
                   std::max(loop.controller_pct, 0.0), std::max(loop.process_pct, 0.0));
  if (loop.names_agree) out += "  The names say so, too.\n";
  out += loop.period_s > 0
             ? print("  u oscillates, one cycle in %.3g s.\n", loop.period_s)
             : std::string("  No oscillation of u was seen.\n");
  return out;
}

std::string key_of(const std::string& bus) {
  std::string out;
  for (const char c : bus) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       (c >= '0' && c <= '9') || c == '_' || c == '-';
    out += plain ? c : '_';
  }
  return out;
}

std::string source_of(const SeenSignal& signal) {
  std::string out = R"({ source = "can", bus = ")" + key_of(signal.bus) + "\", ";
  if (!signal.dbc.empty()) {
    return out + "dbc = \"" + signal.dbc + "\", message = \"" + signal.message +
           "\", signal = \"" + signal.name + "\" }";
  }
  const wire::Signal& s = signal.signal.signal;
  out += "frame_id = 0x" + config::hex_id(signal.signal.frame_id, signal.signal.extended);
  if (signal.signal.extended) out += ", extended = true";
  out += print(", start = %u, length = %u", unsigned{s.start}, unsigned{s.length});
  if (s.byte_order == wire::ByteOrder::kBigEndian)
    out += R"(, byte_order = "big_endian")";
  if (s.is_signed) out += ", is_signed = true";
  return out + print(", scale = %.6g }", s.scale);
}

// A round range around what was seen.
std::string span_of(const SeenSignal& signal) {
  if (signal.low >= 0 && signal.high <= 100 && signal.high > 10) return "[0.0, 100.0]";
  const double step = std::pow(10.0, std::floor(std::log10(signal.high - signal.low)));
  return print("[%.10g, %.10g]", step * std::floor(signal.low / step),
               step * std::ceil(signal.high / step));
}

std::string loop_toml(const Learned& learned, std::size_t index) {
  const LoopProposal& loop = learned.proposals[index];
  const SeenSignal& u = learned.signals[loop.u];
  const SeenSignal& y = learned.signals[loop.y];
  const std::string number = std::to_string(index + 1);
  std::string out = "[[loop]]\nid = " + number + "\ntag = \"LOOP-" + number + "\"\n";
  out += print("sample_period_s = %.6g\n", loop.sample_period_s);
  out += "span = " + span_of(u) + "                # of u; look it up\n";
  out += "y_span = " + span_of(y) + '\n';
  out += "u = " + source_of(u) + '\n';
  out += "y = " + source_of(y) + '\n';
  if (loop.sp) out += "sp = " + source_of(learned.signals[*loop.sp]) + '\n';
  return out;
}

Json frame_json(const SurveyedFrame& frame) {
  return {{"bus", frame.bus},
          {"id", config::hex_id(frame.id, frame.extended)},
          {"extended", frame.extended},
          {"fd", frame.fd},
          {"frames", frame.count},
          {"rate_hz", frame.rate_hz()},
          {"shortest", frame.shortest},
          {"longest", frame.longest},
          {"changing_bytes", changing_bytes(frame)}};
}

Json signal_json(const SeenSignal& signal) {
  return {{"title", signal.title()},
          {"guess", signal.dbc.empty()},
          {"bus", signal.bus},
          {"id", config::hex_id(signal.signal.frame_id, signal.signal.extended)},
          {"unit", signal.unit},
          {"low", signal.low},
          {"high", signal.high},
          {"interval_s", signal.interval_s},
          {"moving_share", signal.moving}};
}

}  // namespace

std::string learned_toml(const Learned& learned) {
  std::set<std::string> buses;
  std::string loops;
  for (std::size_t k = 0; k < learned.proposals.size(); ++k) {
    const LoopProposal& loop = learned.proposals[k];
    buses.insert(learned.signals[loop.u].bus);
    buses.insert(learned.signals[loop.y].bus);
    loops += '\n' + loop_toml(learned, k);
  }
  std::string out;
  for (const std::string& bus : buses) {
    out += "[bus." + key_of(bus) + "]\nbackend = \"socketcan\"\ninterface = \"" + bus +
           "\"\n";
  }
  return out + loops;
}

std::string learned_text(const Learned& learned) {
  const FrameSurvey& survey = learned.survey;
  std::string out =
      learned.source + print(": %llu frames of %zu identifiers in %.4g s\n\n",
                             static_cast<unsigned long long>(survey.frames()),
                             survey.all().size(), survey.duration_s());
  out += frames_table(survey);
  const bool guesses = learned.dbc.empty();
  out += guesses
             ? "\nGuesses: bytes that read as a 16-bit number. Nothing says that they "
               "are one;\nscale and unit are not known. A DBC file (--dbc) would.\n"
             : "\nSignals of " + learned.dbc + " that move\n";
  const std::string table = signals_table(learned);
  out += table.empty() ? "  none\n" : table;
  if (learned.proposals.empty()) {
    return out +
           "\nNo pair of signals behaves like u and y of a loop. Listen longer, while "
           "the\nplant moves (a setpoint step helps).\n";
  }
  for (std::size_t k = 0; k < learned.proposals.size(); ++k) {
    const LoopProposal& loop = learned.proposals[k];
    out += print("\nProposal %zu\n", k + 1);
    out += plot("u", learned.signals[loop.u]);
    out += plot("y", learned.signals[loop.y]);
    out += reasons(loop);
  }
  return out +
         "\nTo paste into gateway.toml after a look at the plant's documents (nothing "
         "was\nwritten):\n\n" +
         learned_toml(learned);
}

std::string learned_json(const Learned& learned) {
  Json out = {
      {"source", learned.source},          {"duration_s", learned.survey.duration_s()},
      {"frames", learned.survey.frames()}, {"identifiers", Json::array()},
      {"signals", Json::array()},          {"proposals", Json::array()}};
  for (const SurveyedFrame* frame : learned.survey.all()) {
    out["identifiers"].push_back(frame_json(*frame));
  }
  for (const SeenSignal& signal : learned.signals) {
    out["signals"].push_back(signal_json(signal));
  }
  for (const LoopProposal& loop : learned.proposals) {
    Json proposal = {{"u", learned.signals[loop.u].title()},
                     {"y", learned.signals[loop.y].title()},
                     {"sp", nullptr},
                     {"guess", learned.dbc.empty()},
                     {"correlation", loop.correlation},
                     {"lag_s", loop.lag_s},
                     {"controller_pct", loop.controller_pct},
                     {"process_pct", loop.process_pct},
                     {"period_s", loop.period_s},
                     {"sample_period_s", loop.sample_period_s},
                     {"names_agree", loop.names_agree}};
    if (loop.sp) proposal["sp"] = learned.signals[*loop.sp].title();
    out["proposals"].push_back(std::move(proposal));
  }
  out["toml"] = learned_toml(learned);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace firmware
