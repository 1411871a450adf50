// A program that is tested from outside.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "support/base/temporary_folder.hpp"

/// The content of a file; empty when it cannot be read.
[[nodiscard]] std::string text_of(const std::string& path);

/// A TCP port of this machine that nobody listens on.
[[nodiscard]] std::uint16_t free_port();

/// A child process with its output in files, killed with the object.
class Process {
 public:
  struct Result {
    int code = -1;  ///< exit code; −1: ended by a signal
    std::string out;
    std::string err;
  };

  /// `arguments` begin with the path of the program.
  explicit Process(const std::vector<std::string>& arguments);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int number) const;
  [[nodiscard]] std::string err() const { return text_of(folder_.file("err")); }
  /// Waits, for up to 10 s, until `text` stands in stderr.
  [[nodiscard]] bool says(const std::string& text) const;
  /// Waits until it ends.
  Result wait();
  [[nodiscard]] pid_t id() const { return id_; }
  /// A line of /proc/PID/status in KiB, e.g. "VmRSS"; −1: there is none.
  [[nodiscard]] long memory_kib(const std::string& line) const;
  /// Processor time so far, user and system.
  [[nodiscard]] double cpu_s() const;

 private:
  TemporaryFolder folder_;
  pid_t id_ = -1;
};
