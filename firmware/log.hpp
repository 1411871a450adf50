// Lines on stderr with the priority prefixes of the journal, rate-limited: each topic by
// itself, so that a device that fails every second takes no line from the flags.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>

namespace firmware {

enum class Priority : int { kError = 3, kWarning = 4, kNotice = 5, kInfo = 6 };

/// What a line is about.
enum class Topic : std::uint8_t {
  kGateway,  ///< itself: start, configuration, files, buses, testers
  kDevices,  ///< errors of buses, converters, servers and lines
  kInputs,   ///< of loops: faults, restored, suspended, resumed
  kLoops,    ///< what monitors and trends say
  kFlags,    ///< raised and lowered
};
inline constexpr std::size_t kTopics = 5;

/// One thread; writing a line does not allocate.
class Log {
 public:
  static constexpr int kBurst = 40;     ///< lines of a topic at once
  static constexpr int kPerSecond = 4;  ///< lines of a topic, in the long run

  explicit Log(std::FILE* out = stderr) : out_(out) {}

  /// Writes `text` as one line, or counts it as suppressed. `now_us`: monotonic.
  void write(std::int64_t now_us, Priority priority, const char* text,
             Topic topic = Topic::kGateway);
  /// The same of the gateway, as printf does; cut as a message is.
  [[gnu::format(printf, 4, 5)]] void print(std::int64_t now_us, Priority priority,
                                           const char* format, ...);
  /// Lines of all topics.
  [[nodiscard]] std::uint64_t suppressed() const;

 private:
  struct Budget {
    std::int64_t credit_us = 0;  // time earned and not spent
    std::int64_t last_us = 0;
    std::uint64_t suppressed = 0;
    std::uint64_t told = 0;
    bool started = false;
  };

  std::FILE* out_;
  std::array<Budget, kTopics> budgets_{};
};

}  // namespace firmware
