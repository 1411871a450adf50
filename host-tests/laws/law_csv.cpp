// The same recording, however the file spells it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"

namespace workbench {
namespace {

struct Spelling {
  std::vector<int> order;  // of the columns t, u, y, sp, x and one to be ignored
  char separator = ',';
  bool decimal_comma = false;
  std::string line_end = "\n";
  bool mark = false;
  bool quotes = false;
  bool spaces = false;
  bool upper = false;
  bool aliases = false;
  int blank_lines = 0;
};

Spelling any_spelling() {
  Spelling s;
  s.order = {0, 1, 2, 3, 4, 5};
  for (int i = 5; i > 0; --i) std::swap(s.order[i], s.order[*rc::gen::inRange(0, i + 1)]);
  s.separator = *rc::gen::element(',', ';', '\t');
  s.decimal_comma = s.separator != ',' && *rc::gen::arbitrary<bool>();
  s.line_end = *rc::gen::element<std::string>("\n", "\r\n", "\r");
  s.mark = *rc::gen::arbitrary<bool>();
  s.quotes = *rc::gen::arbitrary<bool>();
  s.spaces = *rc::gen::arbitrary<bool>();
  s.upper = *rc::gen::arbitrary<bool>();
  s.aliases = *rc::gen::arbitrary<bool>();
  s.blank_lines = *rc::gen::inRange(0, 3);
  return s;
}

std::string spelled(const std::vector<std::array<double, 5>>& rows, const Spelling& s) {
  const std::array<std::string, 6> names =
      s.aliases ? std::array<std::string, 6>{"t", "op", "pv", "sp", "pos", "note"}
                : std::array<std::string, 6>{"t", "u", "y", "sp", "x", "note"};
  std::string text = s.mark ? "\xEF\xBB\xBF" : "";
  const auto add = [&](std::string cell, std::size_t position) {
    if (s.quotes) cell = '"' + cell + '"';
    if (s.spaces) cell = "  " + cell + ' ';
    text += cell + (position == 5 ? s.line_end : std::string(1, s.separator));
  };
  for (std::size_t c = 0; c < 6; ++c) {
    std::string name = names[s.order[c]];
    if (s.upper) std::transform(name.begin(), name.end(), name.begin(), ::toupper);
    add(name, c);
  }
  for (const std::array<double, 5>& row : rows) {
    for (std::size_t c = 0; c < 6; ++c) {
      if (s.order[c] == 5) {
        add("anything", c);
        continue;
      }
      std::array<char, 40> number;
      std::snprintf(number.data(), number.size(), "%.17g", row[s.order[c]]);
      std::string cell = number.data();
      if (s.decimal_comma) std::replace(cell.begin(), cell.end(), '.', ',');
      add(cell, c);
    }
  }
  for (int i = 0; i < s.blank_lines; ++i) text += s.line_end;
  return text;
}

std::vector<std::array<double, 5>> any_rows(int fewest = 2) {
  const int count = *rc::gen::inRange(fewest, 40);
  std::vector<std::array<double, 5>> rows;
  for (int k = 0; k < count; ++k) {
    std::array<double, 5> row{};
    row[0] = 0.25 * k;
    for (std::size_t c = 1; c < 5; ++c) {
      row[c] = *rc::gen::inRange(-1'000'000, 1'000'000) * 1e-3;
    }
    rows.push_back(row);
  }
  return rows;
}

RC_GTEST_PROP(CsvLaw, SpellingMakesNoDifference, ()) {
  const std::vector<std::array<double, 5>> rows = any_rows();
  const Recording r = parse_csv(spelled(rows, any_spelling()), "rec.csv");
  RC_ASSERT(r.size() == rows.size());
  RC_ASSERT(r.period_s == 0.25);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    RC_ASSERT(r.t[k] == rows[k][0]);
    RC_ASSERT(r.u[k] == rows[k][1]);
    RC_ASSERT(r.y[k] == rows[k][2]);
    RC_ASSERT(r.sp[k] == rows[k][3]);
    RC_ASSERT(r.x[k] == rows[k][4]);
  }
}

RC_GTEST_PROP(CsvLaw, MissingRowsAreHeldAndCounted, ()) {
  const std::vector<std::array<double, 5>> rows = any_rows(10);
  std::vector<std::array<double, 5>> kept;
  int in_a_row = 0;  // three kept before one goes: the median interval stays
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (in_a_row >= 3 && k + 1 < rows.size() && *rc::gen::inRange(0, 3) == 0) {
      in_a_row = 0;
      continue;
    }
    ++in_a_row;
    kept.push_back(rows[k]);
  }
  const Recording r = parse_csv(spelled(kept, any_spelling()), "rec.csv");
  RC_ASSERT(r.size() == rows.size());
  RC_ASSERT(r.resampling.missing == rows.size() - kept.size());
  std::size_t row = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    while (row + 1 < kept.size() && kept[row + 1][0] <= rows[k][0]) ++row;
    RC_ASSERT(r.u[k] == kept[row][1]);
  }
}

RC_GTEST_PROP(CsvLaw, AnyPrefixIsARecordingOrAnInputError, ()) {
  const std::string text = spelled(any_rows(), any_spelling());
  const auto length = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
  try {
    const Recording r = parse_csv(std::string_view(text).substr(0, length), "rec.csv");
    RC_ASSERT(r.size() >= 2U);
  } catch (const InputError& error) {
    RC_ASSERT(std::string(error.what()).find("expected") != std::string::npos);
  }
}

}  // namespace
}  // namespace workbench
