// The terminal: answers to stdout, messages and progress to stderr.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace workbench::cli {

/// Writes `text` to stdout and flushes it. Throws OutputError.
void print(std::string_view text);

/// Writes "stickband: `message`" to stderr, as one line.
void complain(std::string_view message);

/// Complains that the data cannot answer, and `why`; returns kCannotAnswer.
[[nodiscard]] int cannot_answer(std::string_view why);

/// True where one terminal shows both: what is printed need not be complained about.
[[nodiscard]] bool is_read_beside_messages();

/// `text` broken at spaces into lines of at most `width` characters, each but the first
/// line indented by `indent`. Ends without a line feed.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent,
                                  std::size_t width = 80);

/// `text` with blanks behind it up to `width` bytes.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);

/// A line of a table less the blanks at its end.
[[nodiscard]] std::string without_end_blanks(std::string line);

/// A line on stderr that is rewritten while work goes on: only if stderr is a terminal,
/// only for work longer than half a second; erased at the end.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::string_view text);
  /// Which of the effects is tried.
  void trying(std::string_view effect, int number, int of);

 private:
  using Clock = std::chrono::steady_clock;
  const bool terminal_;
  const Clock::time_point start_;
  Clock::time_point next_;
  bool shown_ = false;
};

}  // namespace workbench::cli
