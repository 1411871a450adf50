#include "workbench/cli/console.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "workbench/cli/exit_code.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench::cli {
namespace {

constexpr std::chrono::milliseconds kPatience{500};
constexpr std::chrono::milliseconds kRefresh{200};

}  // namespace

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw OutputError(std::string("cannot write to standard output: ") +
                      std::strerror(errno));
  }
}

void complain(std::string_view message) {
  std::fprintf(stderr, "stickband: %.*s\n", static_cast<int>(message.size()),
               message.data());
}

int cannot_answer(std::string_view why) {
  complain("the data cannot answer: " + std::string(why));
  return kCannotAnswer;
}

bool is_read_beside_messages() {
  return isatty(STDOUT_FILENO) == 1 && isatty(STDERR_FILENO) == 1;
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  std::string out;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::string_view word = wire::take_until(text, ' ');
    const std::size_t length = characters(word);
    if (column > indent && column + 1 + length > width) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      out += ' ';
      ++column;
    }
    out += word;
    column += length;
  }
  return out;
}

std::string padded(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, text.size()), ' ');
}

std::string without_end_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

ProgressLine::ProgressLine()
    : terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      next_(start_ + kPatience) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(std::string_view text) {
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + kRefresh;
  shown_ = true;
  const std::chrono::duration<double> spent = Clock::now() - start_;
  std::fprintf(stderr, "\r\033[K%.*s, %.0f s", static_cast<int>(text.size()), text.data(),
               spent.count());
}

void ProgressLine::trying(std::string_view effect, int number, int of) {
  show("trying " + std::string(effect) + ", " + std::to_string(number) + " of " +
       std::to_string(of));
}

}  // namespace workbench::cli
