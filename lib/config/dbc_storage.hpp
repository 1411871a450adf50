// A DBC file parsed into storage of its own.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "wire/dbc.hpp"

namespace config {

/// Reserves what the text can need at the most, some megabytes, and parses it.
class DbcStorage {
 public:
  /// A DBC file is no larger.
  static constexpr std::size_t kMaxBytes = std::size_t{32} << 20;

  /// `text` must outlive it.
  explicit DbcStorage(std::string_view text);
  DbcStorage(const DbcStorage&) = delete;
  DbcStorage& operator=(const DbcStorage&) = delete;

  [[nodiscard]] const wire::Dbc& content() const { return dbc_; }
  /// What parse() came to.
  [[nodiscard]] const wire::DbcStatus& status() const { return status_; }

 private:
  std::vector<wire::DbcMessage> messages_;
  std::vector<wire::DbcSignal> signals_;
  wire::Dbc dbc_;
  wire::DbcStatus status_;
};

}  // namespace config
