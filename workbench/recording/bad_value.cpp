#include "workbench/recording/bad_value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

using namespace std::string_view_literals;

constexpr double kGoodCode = 192;  // OPC Data Access
constexpr double kUncertainCode = 64;
constexpr double kOpcUaBad = 2147483648.0;  // severity bits of OPC UA
constexpr double kOpcUaUncertain = 1073741824.0;

constexpr std::array kWords = {
    "null"sv,        "<null>"sv,      "none"sv,           "nil"sv,
    "n/a"sv,         "n.a."sv,        "nodata"sv,         "void"sv,
    "invalid"sv,     "missing"sv,     "unknown"sv,        "shutdown"sv,
    "off-line"sv,    "offline"sv,     "off-scan"sv,       "off scan"sv,
    "oos"sv,         "err"sv,         "schlecht"sv,       "fehler"sv,
    "fehlend"sv,     "keine daten"sv, "kein wert"sv,      "--"sv,
    "---"sv,         "----"sv,        "-----"sv,          "***"sv,
    "****"sv,        "???"sv,         "????"sv,           "ung\xC3\xBCltig"sv,
    "ung\xFCltig"sv, "ungueltig"sv,   "gest\xC3\xB6rt"sv, "gest\xF6rt"sv,
    "gestoert"sv};

constexpr std::array kBeginnings = {
    "bad"sv,           "no data"sv,       "no good"sv,    "no result"sv,   "no value"sv,
    "no sample"sv,     "i/o timeout"sv,   "io timeout"sv, "timeout"sv,     "timed out"sv,
    "digital state"sv, "digital set"sv,   "pt created"sv, "scan "sv,       "comm"sv,
    "out of serv"sv,   "not connect"sv,   "not avail"sv,  "not collect"sv, "configure"sv,
    "calc "sv,         "over range"sv,    "overrange"sv,  "under range"sv, "underrange"sv,
    "intf"sv,          "equip"sv,         "failed"sv,     "error"sv,       "arc "sv,
    "set to bad"sv,    "access denied"sv, "resize to"sv,  "no_data"sv,     "<bad"sv,
    "<no"sv,           "trace off"sv,     "doubtful"sv};

constexpr std::array kExportWords = {"nan"sv,     "-nan"sv,    "+nan"sv,   "nan(ind)"sv,
                                     "1.#qnan"sv, "-1.#ind"sv, "1.#ind"sv, "-1.#qnan"sv,
                                     "1.#nan"sv,  "-"sv,       "*"sv,      "?"sv};

constexpr std::size_t kLongest = 48;

}  // namespace

bool says_no_value(std::string_view cell, bool export_file) {
  if (cell.empty()) return false;
  const char first = cell.front();
  if ((first >= '0' && first <= '9' && cell.find('#') == std::string_view::npos)) {
    return false;
  }
  const std::string lower = lower_case(cell.substr(0, kLongest));
  const auto is = [&lower](std::string_view word) { return lower == word; };
  const auto begins = [&lower](std::string_view word) { return lower.starts_with(word); };
  if (lower[0] == '#' && lower.size() > 1 && lower[1] >= 'a' && lower[1] <= 'z') {
    return true;
  }
  return std::any_of(kWords.begin(), kWords.end(), is) ||
         std::any_of(kBeginnings.begin(), kBeginnings.end(), begins) ||
         (export_file && std::any_of(kExportWords.begin(), kExportWords.end(), is));
}

double QualityScale::add(std::string_view cell) {
  double code = kGoodCode;
  if (!cell.empty()) {
    const auto [stop, status] =
        std::from_chars(cell.data(), cell.data() + cell.size(), code);
    if (status != std::errc{} || stop != cell.data() + cell.size() || !(code >= 0)) {
      const std::string lower = lower_case(cell.substr(0, kLongest));
      const bool bad = says_no_value(cell, true) || lower == "false" || lower == "falsch";
      const bool uncertain = lower.starts_with("uncertain");
      code = bad ? 0 : uncertain ? kUncertainCode : kGoodCode;
      most_ = std::max(most_, kGoodCode);
    } else {
      most_ = std::max(most_, code);
    }
  }
  return code;
}

Quality QualityScale::meaning(double code) const {
  bool bad = false;
  if (most_ >= kOpcUaUncertain) {
    bad = code >= kOpcUaBad;
  } else if (most_ >= kGoodCode) {
    bad = code < kUncertainCode;
  } else {
    bad = most_ > 0 && code == 0;
  }
  return bad ? Quality::kBad : Quality::kGood;
}

}  // namespace workbench
