// image (replay|count) (whole|last) BUDGET RECORDING
//
// Replays a packed recording through the monitor and prints what it found; `count` adds
// instructions and stack of push, step and report.
#include "host-tests/targets/image/meter.hpp"
#include "host-tests/targets/image/semihosting.hpp"
#include "host-tests/targets/replay.hpp"

namespace {

using Monitor = ident::Monitor<float, ident::STICKBAND_WINDOW>;
constexpr int kUsage = 2;
constexpr int kBadInput = 3;

void say_figures(const targets::CallMeter& meter) {
  for (const targets::CallFigures& figures : meter.figures()) {
    if (figures.name != nullptr) {
      semihosting::write((targets::Line("calls")
                          << figures.name << figures.calls << figures.instructions
                          << std::int64_t{figures.most}
                          << std::int64_t{figures.stack_bytes})
                             .text());
    }
  }
}

// Cuts the next word off a line.
const char* next_word(char*& line) {
  while (*line == ' ') {
    ++line;
  }
  const char* word = line;
  while (*line != ' ' && *line != '\0') {
    ++line;
  }
  if (*line == ' ') {
    *line++ = '\0';
  }
  return word;
}

int number(const char* word) {
  int value = 0;
  for (; *word >= '0' && *word <= '9' && value < 100'000; ++word) {
    value = value * 10 + (*word - '0');
  }
  return value;
}

}  // namespace

int main() {
  static std::array<char, 1024> line;
  if (!semihosting::command_line(line)) {
    semihosting::write("error: the command line is too long\n");
    return kUsage;
  }
  char* rest = line.data();
  next_word(rest);  // the program's own name
  const bool counts = std::strcmp(next_word(rest), "count") == 0;
  const bool whole = std::strcmp(next_word(rest), "whole") == 0;
  const int budget = number(next_word(rest));
  const char* path = next_word(rest);
  const int file = semihosting::open(path);
  if (file < 0) {
    semihosting::write("error: expected a recording that can be opened, found ");
    semihosting::write(path);
    semihosting::write("\n");
    return kBadInput;
  }
  const auto read = [file](std::span<std::byte> out) {
    return semihosting::read(file, out) == out.size();
  };
  const targets::Life life = whole ? targets::Life::kWhole : targets::Life::kLast;
  static targets::CallMeter meter;
  if (counts) {
    meter.start();
  }
  if (!targets::replay<Monitor, float>(read, semihosting::write, meter, life, budget)) {
    return kBadInput;
  }
  say_figures(meter);
  return 0;
}
