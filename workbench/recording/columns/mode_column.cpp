#include "workbench/recording/columns/mode_column.hpp"

#include <algorithm>
#include <string>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

using Pieces = std::vector<std::string>;

constexpr std::string_view kModeWords =
    "mode|modus|md|amode|betriebsart|automan|automanual|am";
constexpr std::string_view kAutoWords = "auto|automatic|automatik";
constexpr std::string_view kManualWords = "man|manual|hand";
constexpr std::string_view kSaidBehind = "actual|act|ist|cv|value";
constexpr std::string_view kAutomaticModes =
    "a|aut|auto|automatic|automatik|cas|csc|casc|cascade|rcas|kaskade|prd";
constexpr std::string_view kManualModes =
    "m|man|manual|manuell|hand|iman|rman|lo|h|oos|o/s";

enum class Says { kNothing, kMode, kAuto, kManual };

// What the name of a column says, and the pieces before that.
Says said_by(Pieces pieces, Pieces& tag) {
  if (pieces.size() > 1 && is_one_of(pieces.back(), kSaidBehind)) pieces.pop_back();
  if (pieces.empty()) return Says::kNothing;
  const std::string last = pieces.back();
  pieces.pop_back();
  const std::string before = pieces.empty() ? "" : pieces.back();
  const bool two = (before == "a" && last == "m") ||
                   (is_one_of(before, kAutoWords) && is_one_of(last, kManualWords)) ||
                   (is_one_of(before, kManualWords) && is_one_of(last, kAutoWords));
  if (two) pieces.pop_back();
  tag = std::move(pieces);
  if (two || is_one_of(last, kModeWords)) return Says::kMode;
  if (is_one_of(last, kAutoWords)) return Says::kAuto;
  return is_one_of(last, kManualWords) ? Says::kManual : Says::kNothing;
}

// The codes under which u rests, where it moves under another.
std::vector<double> resting_codes(std::span<const double> codes,
                                  std::span<const double> u) {
  constexpr double kRests = 0.9;
  constexpr double kMoves = 0.5;
  constexpr std::size_t kMostCodes = 32;
  std::vector<double> known;
  for (const double code : codes) {
    if (std::ranges::find(known, code) != known.end()) continue;
    if (known.size() == kMostCodes) return {};  // this is no mode
    known.push_back(code);
  }
  std::vector<double> out;
  bool moves = false;
  for (const double code : known) {
    if (code == kNoMode) continue;
    double count = 0;
    double rest = 0;
    for (std::size_t k = 1; k < codes.size(); ++k) {
      if (codes[k] != code || codes[k - 1] != code) continue;
      ++count;
      if (u[k] == u[k - 1]) ++rest;
    }
    if (count == 0) continue;
    if (rest >= kRests * count) out.push_back(code);
    if (rest <= kMoves * count) moves = true;
  }
  if (!moves) out.clear();
  return out;
}

}  // namespace

std::optional<std::size_t> mode_column(const std::vector<LayoutColumn>& columns,
                                       std::size_t signal) {
  const Pieces& of = columns[signal].name.pieces;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    Pieces tag;
    if (i == signal || said_by(columns[i].name.pieces, tag) == Says::kNothing) continue;
    if (tag.size() < of.size() && std::equal(tag.begin(), tag.end(), of.begin())) {
      return i;
    }
  }
  return std::nullopt;
}

double mode_code(std::string_view cell) {
  std::string word = lower_case(cell);
  std::erase_if(word, [](char c) { return c == '"' || c == ' '; });
  if (const auto value = wire::number_of<double>(word); value >= 0.0) return *value;
  if (is_one_of(word, kAutomaticModes)) return kAutomatic;
  return is_one_of(word, kManualModes) ? kManual : kNoMode;
}

std::vector<SampleRange> manual_stretches(std::span<const double> codes,
                                          std::span<const double> u,
                                          std::string_view name) {
  if (u.size() != codes.size()) return {};
  std::vector<double> manual = {kManual};
  const bool words = std::ranges::any_of(
      codes, [](double code) { return code == kAutomatic || code == kManual; });
  if (!words) {
    Pieces tag;
    const Says says = said_by(column_name(name).pieces, tag);
    manual = says == Says::kAuto     ? std::vector<double>{0}
             : says == Says::kManual ? std::vector<double>{1}
                                     : resting_codes(codes, u);
  }
  return stretches_where(codes.size(), [&](std::size_t k) {
    return std::ranges::find(manual, codes[k]) != manual.end();
  });
}

}  // namespace workbench
