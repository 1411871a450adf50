#include "can_views.hpp"

#include <array>
#include <cstdio>
#include <span>
#include <stdexcept>
#include <vector>

#include "wire/diagnostics.hpp"
#include "wire/dtc_store.hpp"

namespace can_views {
namespace {

using wire::FieldType;
using wire::LoopField;

constexpr int kBroadcastPeriodMs = 1000;

std::string number(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.15g", value);
  return text.data();
}

std::string hex(unsigned value, int digits) {
  std::array<char, 16> text;
  std::snprintf(text.data(), text.size(), "%0*X", digits, value);
  return text.data();
}

std::string type_name(const auto& field) {
  constexpr std::array<const char*, 7> kNames = {"u8",  "u16",  "u32",  "u64",
                                                 "i16", "text", "knots"};
  std::string name = kNames[static_cast<std::size_t>(field.type)];
  if (field.text_bytes != 0) name += "[" + std::to_string(field.text_bytes) + "]";
  return name;
}

// A signal of a cyclic frame.
struct Placed {
  const LoopField* field = nullptr;
  std::size_t byte = 0;
};

// A cyclic frame: what its messages are called after those of frame 1, and where its
// identifiers begin.
struct Cyclic {
  int frame;
  const char* suffix;
  std::uint32_t base_id;
};
constexpr std::array<Cyclic, wire::kBroadcastFrames> kCyclic = {
    {{1, "", wire::kBroadcastBaseId},
     {2, "Band", wire::kDetailBaseId},
     {3, "Trend", wire::kDetailBaseId + wire::kBroadcastIds}}};

std::vector<Placed> broadcast_signals(int frame) {
  std::vector<Placed> placed;
  std::size_t byte = 0;
  for (const LoopField& field : wire::loop_fields()) {
    if (field.frame != frame) continue;
    placed.push_back({&field, byte});
    byte += wire::size_of(field.type);
  }
  return placed;
}

std::string signal_line(const Placed& placed) {
  const LoopField& field = *placed.field;
  const std::size_t bits = 8 * wire::size_of(field.type);
  const bool is_signed = field.type == FieldType::kI16;
  const double most = static_cast<double>((std::uint64_t{1} << (bits - is_signed)) - 2);
  const double least = is_signed ? -most - 2 : 0;
  return " SG_ " + std::string(field.name) + " : " + std::to_string(8 * placed.byte + 7) +
         "|" + std::to_string(bits) + "@0" + (is_signed ? "-" : "+") + " (" +
         number(field.scale) + ",0) [" + number(least * field.scale) + "|" +
         number(most * field.scale) + "] \"" + std::string(field.unit) +
         "\" Vector__XXX\n";
}

void replace_between(std::string& page, const std::string& name,
                     const std::string& table) {
  const std::string open = "<!-- " + name + " -->\n";
  const std::string close = "<!-- /" + name + " -->";
  const std::size_t start = page.find(open);
  const std::size_t end = page.find(close);
  if (start == std::string::npos || end == std::string::npos || end < start) {
    throw std::runtime_error("expected the marks " + open + close +
                             " on lines of their own, found none");
  }
  page.replace(start + open.size(), end - start - open.size(), table);
}

std::string scale_of(const auto& field) {
  if (field.number == nullptr && field.type != FieldType::kPath) return "";
  if (!field.choices.empty()) return "code";
  const std::string unit(field.unit);
  if (field.scale == 1) return unit;
  return number(field.scale) + (unit.empty() ? "" : " " + unit);
}

std::string row(const auto& field) {
  return "`" + std::string(field.name) + "` | " + type_name(field) + " | " +
         scale_of(field) + " | " + std::string(field.meaning) + " |\n";
}

std::string gateway_table() {
  std::string out = "| DID | field | type | unit | meaning |\n|---|---|---|---|---|\n";
  for (const wire::GatewayField& field : wire::gateway_fields()) {
    out += "| " + hex(field.object, 4) + " | " + row(field);
  }
  return out + "| " + hex(wire::kDirectoryDid, 4) +
         " | `directory` | {u16, u16}… | | every DID and its length in bytes |\n";
}

std::string loop_table() {
  std::string out = "| offset | field | type | unit | meaning |\n|---|---|---|---|---|\n";
  for (const LoopField& field : wire::loop_fields()) {
    const wire::LoopObject& object = wire::loop_objects()[field.object];
    out += "| +" + std::to_string(field.object) + " " + std::string(object.name) +
           (object.writable ? " (read, write)" : "") + " | " + row(field);
  }
  return out;
}

// Codes that are shared by several fields are listed once, under all their names.
std::string code_table() {
  std::vector<std::pair<std::span<const wire::Choice>, std::string>> lists;
  const auto collect = [&](const auto& fields) {
    for (const auto& field : fields) {
      if (field.choices.empty()) continue;
      const std::string name = "`" + std::string(field.name) + "`";
      bool known = false;
      for (auto& [choices, names] : lists) {
        if (choices.data() != field.choices.data()) continue;
        names += ", " + name;
        known = true;
      }
      if (!known) lists.emplace_back(field.choices, name);
    }
  };
  collect(wire::gateway_fields());
  collect(wire::loop_fields());
  std::string out = "| field | codes |\n|---|---|\n";
  for (const auto& [choices, names] : lists) {
    out += "| " + names + " | ";
    for (const wire::Choice& choice : choices) {
      out += (choice.value == choices.front().value ? "" : " · ") +
             std::to_string(choice.value) + " " + std::string(choice.name);
    }
    out += " |\n";
  }
  return out;
}

std::string broadcast_table() {
  std::string out =
      "| frame | byte | field | type | unit | meaning |\n|---|---|---|---|---|---|\n";
  for (const Cyclic& cyclic : kCyclic) {
    for (const Placed& placed : broadcast_signals(cyclic.frame)) {
      out += "| " + std::to_string(cyclic.frame) + " | " + std::to_string(placed.byte) +
             " | " + row(*placed.field);
    }
  }
  return out;
}

std::string dtc_table() {
  std::string out = "| DTC of loop 9 | meaning |\n|---|---|\n";
  for (const wire::FailureKind& kind : wire::failure_kinds()) {
    out += "| " + hex(wire::DtcStore::number_of(9, kind.type), 6) + " | " +
           std::string(kind.name) + " |\n";
  }
  return out;
}

}  // namespace

std::string dbc() {
  std::string out =
      "VERSION \"\"\n\nNS_ :\n\tCM_\n\tBA_DEF_\n\tBA_\n\tVAL_\n\tBA_DEF_DEF_\n\nBS_:\n\n"
      "BU_: Stickband\n\n";
  std::string comments =
      "CM_ \"Cyclic status of the loops; all ones: not available.\";\n";
  std::string periods;
  std::string choices;
  const auto add = [&](const Cyclic& cyclic, int loop) {
    const std::string id =
        std::to_string(cyclic.base_id + static_cast<std::uint32_t>(loop));
    const std::string message = "StickbandLoop" + std::to_string(loop) + cyclic.suffix;
    out += "BO_ " + id + " " + message + ": 8 Stickband\n";
    for (const Placed& placed : broadcast_signals(cyclic.frame)) {
      const LoopField& field = *placed.field;
      const std::string signal = id + " " + std::string(field.name);
      out += signal_line(placed);
      comments += "CM_ SG_ " + signal + " \"" + std::string(field.meaning) + "\";\n";
      if (field.choices.empty()) continue;
      choices += "VAL_ " + signal;
      for (const wire::Choice& choice : field.choices) {
        choices +=
            " " + std::to_string(choice.value) + " \"" + std::string(choice.name) + "\"";
      }
      choices += " ;\n";
    }
    out += "\n";
    periods += "BA_ \"GenMsgCycleTime\" BO_ " + id + " " +
               std::to_string(kBroadcastPeriodMs) + ";\n";
  };
  for (const Cyclic& cyclic : kCyclic) {
    for (int loop = 1; loop <= wire::kMostLoops; ++loop) add(cyclic, loop);
  }
  return out + comments +
         "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n"
         "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n" +
         periods + choices;
}

std::string page(std::string page) {
  replace_between(page, "gateway", gateway_table());
  replace_between(page, "loop", loop_table());
  replace_between(page, "codes", code_table());
  replace_between(page, "broadcast", broadcast_table());
  replace_between(page, "dtcs", dtc_table());
  return page;
}

}  // namespace can_views
