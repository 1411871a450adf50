// A DBC file with the storage it needs, and messages about what it lacks.
#pragma once

#include <string>

#include "config/dbc_storage.hpp"
#include "wire/dbc.hpp"

namespace config {

class DbcFile {
 public:
  static constexpr std::size_t kMaxBytes = DbcStorage::kMaxBytes;

  /// Parses `text`; error() tells if that failed.
  DbcFile(std::string text, std::string name);
  DbcFile(const DbcFile&) = delete;
  DbcFile& operator=(const DbcFile&) = delete;

  [[nodiscard]] const wire::Dbc& content() const { return storage_.content(); }
  /// Finds MESSAGE.SIGNAL. False: error() says what was expected and found.
  [[nodiscard]] bool find(const std::string& reference, wire::FrameSignal& out);
  /// Finds the signal with the attribute SPN of that number in a message of the J1939
  /// parameter group. False: error() says what was expected.
  [[nodiscard]] bool find_spn(std::uint32_t pgn, std::uint32_t spn,
                              wire::FrameSignal& out);
  /// Whether the last find() failed for the message, not for its signal.
  [[nodiscard]] bool misses_message() const { return misses_message_; }
  /// One line, with the place in the DBC file; empty: no error.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  void explain(const wire::DbcStatus& status);

  std::string text_;
  std::string name_;
  DbcStorage storage_;
  std::string error_;
  bool misses_message_ = false;
};

}  // namespace config
