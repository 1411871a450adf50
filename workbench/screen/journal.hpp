// What a screening has finished, so that it can go on where it was stopped.
#pragma once

#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

#include "workbench/screen/screened_loop.hpp"

namespace workbench {

/// A file with a line of JSON for each finished loop. A key tells a loop and the state of
/// its files; a line that was cut off by a crash is passed over. Thread-safe.
class Journal {
 public:
  /// Reads what is there and appends to it. "": remembers nothing. Throws
  /// std::runtime_error where the file cannot be read or written.
  explicit Journal(const std::string& path);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  [[nodiscard]] std::optional<ScreenedLoop> find(const std::string& key) const;
  /// On the disk when it returns, as far as the system goes: a killed process loses
  /// nothing. Throws std::runtime_error.
  void add(const std::string& key, const ScreenedLoop& loop);

 private:
  std::string path_;
  std::FILE* file_ = nullptr;
  std::unordered_map<std::string, std::string> lines_;
  std::mutex mutex_;
};

}  // namespace workbench
