// replay_host (f32|f64) (whole|last) BUDGET RECORDING: the board's replay on the host.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "host-tests/targets/replay.hpp"

namespace {

constexpr int kUsage = 2;
constexpr int kBadInput = 3;

template <class Real>
bool run(std::FILE* file, targets::Life life, int budget) {
  const auto read = [file](std::span<std::byte> out) {
    return std::fread(out.data(), 1, out.size(), file) == out.size();
  };
  const auto say = [](const char* text) { std::fputs(text, stdout); };
  targets::NoMeter meter;
  return targets::replay<ident::Monitor<Real, ident::STICKBAND_WINDOW>, Real>(
      read, say, meter, life, budget);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: replay_host (f32|f64) (whole|last) BUDGET RECORDING\n", stderr);
    return kUsage;
  }
  std::FILE* file = std::fopen(argv[4], "rb");
  if (file == nullptr) {
    std::fprintf(stderr, "%s: expected a packed recording, cannot open it\n", argv[4]);
    return kBadInput;
  }
  const auto life =
      std::string_view(argv[2]) == "whole" ? targets::Life::kWhole : targets::Life::kLast;
  const int budget = std::atoi(argv[3]);
  const bool good = std::string_view(argv[1]) == "f32" ? run<float>(file, life, budget)
                                                       : run<double>(file, life, budget);
  std::fclose(file);
  return good ? 0 : kBadInput;
}
