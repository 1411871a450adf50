#include "firmware/metrics.hpp"

#include <array>
#include <charconv>
#include <span>

namespace firmware {
namespace {

constexpr std::size_t kBytesPerLine = 160;  // at most, names and tag included

void put_number(std::optional<double> number, std::string& out) {
  if (!number) {
    out += "NaN";
    return;
  }
  std::array<char, 32> text;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), *number);
  out.append(text.data(), error == std::errc() ? end : text.data());
}

// `choices`: what the codes mean; none: it is no code. `grows`: it is a counter.
void put_head(std::string_view subject, std::string_view name, std::string_view meaning,
              std::string_view unit, std::string& out,
              std::span<const wire::Choice> choices = {}, bool grows = false) {
  for (const std::string_view part :
       {std::string_view("# HELP stickband_"), subject, std::string_view("_"), name,
        std::string_view(" "), meaning}) {
    out += part;
  }
  if (!unit.empty()) {
    out += ", ";
    out += unit;
  }
  for (const wire::Choice& choice : choices) {
    out += &choice == choices.data() ? ": " : ", ";
    put_number(choice.value, out);
    out += ' ';
    out += choice.name;
  }
  out += "\n# TYPE stickband_";
  out += subject;
  out += '_';
  out += name;
  out += grows ? " counter\n" : " gauge\n";
}

// The value of a label: as the text format has it.
void put_label(std::string_view text, std::string& out) {
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else {
      out += c;
    }
  }
}

void put_flag(const wire::LoopStatus& loop, std::string& out) {
  out += loop.flag ? "1" : "0";
}

template <class Put>
void put_loops(const wire::GatewayView& view, std::string_view name, std::string& out,
               Put put) {
  for (const wire::LoopStatus& loop : view.loops) {
    out += "stickband_loop_";
    out += name;
    out += "{loop=\"";
    put_number(loop.id, out);
    out += "\",tag=\"";
    put_label(loop.tag.view(), out);
    out += "\"} ";
    put(loop);
    out += '\n';
  }
}

}  // namespace

void write_metrics(const wire::GatewayView& view, std::string_view group,
                   std::string& out) {
  out.clear();
  out.reserve(kBytesPerLine * (wire::loop_fields().size() + 2) * (view.loops.size() + 2));
  put_head("gateway", "info", "name and group of the gateway", "", out);
  out += "stickband_gateway_info{group=\"";
  put_label(group, out);
  out += "\",name=\"";
  put_label(view.gateway.name.view(), out);
  out += "\"} 1\n";
  for (const wire::GatewayField& field : wire::gateway_fields()) {
    if (!field.number) continue;
    put_head("gateway", field.name, field.meaning, field.unit, out, field.choices,
             field.grows);
    out += "stickband_gateway_";
    out += field.name;
    out += ' ';
    put_number(wire::shown(field, view), out);
    out += '\n';
  }
  put_head("loop", "flag", "the flag is raised", "", out);
  put_loops(view, "flag", out, [&out](const wire::LoopStatus& l) { put_flag(l, out); });
  for (const wire::LoopField& field : wire::loop_fields()) {
    if (!field.number) continue;
    put_head("loop", field.name, field.meaning, field.unit, out, field.choices,
             field.grows);
    put_loops(view, field.name, out, [&](const wire::LoopStatus& loop) {
      put_number(wire::shown(field, loop), out);
    });
  }
}

}  // namespace firmware
