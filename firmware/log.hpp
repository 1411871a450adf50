// Lines on stderr with the priority prefixes of the journal, rate-limited.
#pragma once

#include <cstdint>
#include <cstdio>

namespace firmware {

enum class Priority : int { kError = 3, kWarning = 4, kNotice = 5, kInfo = 6 };

/// One thread; writing a line does not allocate.
class Log {
 public:
  static constexpr int kBurst = 40;     ///< lines at once
  static constexpr int kPerSecond = 4;  ///< lines, in the long run

  explicit Log(std::FILE* out = stderr) : out_(out) {}

  /// Writes `text` as one line, or counts it as suppressed. `now_us`: monotonic.
  void write(std::int64_t now_us, Priority priority, const char* text);
  [[nodiscard]] std::uint64_t suppressed() const { return suppressed_; }

 private:
  std::FILE* out_;
  std::int64_t credit_us_ = 0;  // time earned and not spent
  std::int64_t last_us_ = 0;
  std::uint64_t suppressed_ = 0;
  std::uint64_t told_ = 0;
  bool started_ = false;
};

}  // namespace firmware
