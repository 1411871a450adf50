#include "workbench/recording/flux_tables.hpp"

#include <algorithm>
#include <string_view>

namespace workbench {
namespace {

constexpr std::size_t kMostTables = 10'000;

std::optional<std::size_t> named(const CsvLayout& layout, std::string_view name) {
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    if (layout.columns[i].name.text == name) return i;
  }
  return std::nullopt;
}

}  // namespace

FluxTables::FluxTables(const CsvLayout& layout)
    : layout_(layout),
      result_(named(layout, "result")),
      table_(named(layout, "table")),
      timed_(named(layout, "_time").has_value()) {
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const LayoutColumn& column = layout.columns[i];
    const bool text = column.content == Content::kText;
    if (text && column.name.part != Part::kQuality) texts_.push_back(i);
  }
}

bool FluxTables::are_there() const {
  return result_ && table_ && timed_ && tables_.size() <= kMostTables;
}

void FluxTables::add(const std::vector<LineCell>& cells) {
  const std::string id =
      std::string(cells[*result_].text) + '\n' + std::string(cells[*table_].text);
  const auto [at, is_new] = tables_.try_emplace(id);
  std::vector<std::string>& known = at->second;
  for (std::size_t k = 0; is_new && k < texts_.size(); ++k) {
    known.emplace_back(cells[texts_[k]].text);
  }
  for (std::size_t k = 0; k < texts_.size(); ++k) {
    if (known[k] != cells[texts_[k]].text) moving_.insert(k);
  }
}

std::vector<std::size_t> FluxTables::keys() const {
  if (!are_there()) return {};
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < texts_.size(); ++k) {
    if (!moving_.contains(k)) order.push_back(k);
  }
  std::ranges::stable_sort(
      order, [this](std::size_t a, std::size_t b) { return merit(a) > merit(b); });
  const std::size_t most = told_apart(order);
  std::vector<std::size_t> chosen;
  for (std::size_t k : order) {
    const std::size_t before = told_apart(chosen);
    if (before == most) break;
    chosen.push_back(k);
    if (told_apart(chosen) == before) chosen.pop_back();
  }
  for (std::size_t& k : chosen) k = texts_[k];
  return chosen;
}

int FluxTables::merit(std::size_t k) const {
  const LayoutColumn& column = layout_.columns[texts_[k]];
  if (column.name.part == Part::kTag) return 2;
  return is_signal(column_name(column.first).part) ? 1 : 0;
}

std::size_t FluxTables::told_apart(const std::vector<std::size_t>& by) const {
  std::set<std::vector<std::string>> seen;
  for (const auto& [id, texts] : tables_) {
    std::vector<std::string> some;
    for (const std::size_t k : by) some.push_back(texts[k]);
    seen.insert(std::move(some));
  }
  return seen.size();
}

}  // namespace workbench
