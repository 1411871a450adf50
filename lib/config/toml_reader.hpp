// Typed access to a TOML table that remembers what was asked for, so that unknown keys
// can be refused, and collects what is wrong instead of stopping at the first place.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "config/gateway.hpp"

namespace config {

/// What is wrong with a file, place by place.
class Complaints {
 public:
  explicit Complaints(std::string file) : file_(std::move(file)) {}

  /// `expected …, found …; do …` is the message; line 0: the whole file.
  void add(int line, const std::string& key, const std::string& message);
  [[nodiscard]] bool any() const { return !lines_.empty(); }
  [[nodiscard]] std::size_t count() const { return lines_.size(); }
  /// Throws ConfigError if there are any, in the order of their lines.
  void throw_if_any();
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::vector<std::pair<int, std::string>> lines_;
};

/// Inclusive limits of a number.
struct Range {
  double low;
  double high;
};

/// One table. Keys that are absent leave the default; keys that are wrong too, with a
/// complaint.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string name, Complaints& complaints)
      : table_(table), name_(std::move(name)), complaints_(complaints) {}
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

  [[nodiscard]] bool has(std::string_view key);
  /// Complains if `key` is absent.
  bool require(std::string_view key, std::string_view expected);

  void read(std::string_view key, std::string& value);
  void read(std::string_view key, bool& value);
  void read(std::string_view key, double& value, Range range);
  void read_integer(std::string_view key, std::int64_t& value, std::int64_t low,
                    std::int64_t high);
  template <class T>
  void read_integer(std::string_view key, T& value, std::int64_t low, std::int64_t high) {
    auto wide = static_cast<std::int64_t>(value);
    read_integer(key, wide, low, high);
    value = static_cast<T>(wide);
  }
  /// [a, b], finite; with `ascending`, a < b.
  void read_pair(std::string_view key, std::array<double, 2>& value, bool ascending);
  void read_list(std::string_view key, std::vector<double>& value);
  /// One of `choices`; its index in `value`.
  void read_choice(std::string_view key, std::size_t& value,
                   const std::vector<std::string_view>& choices);
  /// A table, or nullptr.
  [[nodiscard]] const toml::table* table(std::string_view key);
  /// An array of tables; empty when absent.
  [[nodiscard]] std::vector<const toml::table*> tables(std::string_view key);

  /// Complains of every key that was not asked for.
  void refuse_unknown();

  void complain(std::string_view key, const std::string& message);
  [[nodiscard]] std::string path_of(std::string_view key) const;
  [[nodiscard]] Place place() const;
  [[nodiscard]] Place place_of(std::string_view key) const;
  [[nodiscard]] const toml::table& raw() const { return table_; }
  [[nodiscard]] Complaints& complaints() { return complaints_; }

 private:
  const toml::node* find(std::string_view key);
  void wrong_type(std::string_view key, std::string_view expected,
                  const toml::node& node);

  const toml::table& table_;
  std::string name_;
  Complaints& complaints_;
  std::vector<std::string> known_;
};

/// A node as it stands in the file, shortened.
[[nodiscard]] std::string found_text(const toml::node& node);
/// `one of "a", "b"`, for messages.
[[nodiscard]] std::string one_of(const std::vector<std::string_view>& choices);

}  // namespace config
