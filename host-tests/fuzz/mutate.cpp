// mutate [N] [SEED]: reads N (default 100000) mutated files, the same ones for the same
// SEED (default 1), and prints one line. A broken promise aborts and leaves the input
// in mutate_input.bin.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "feed.hpp"
#include "seeds.hpp"

namespace {

constexpr std::size_t kLongestInput = 32768;

// splitmix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9;
    z = (z ^ z >> 27) * 0x94D049BB133111EB;
    return z ^ z >> 31;
  }
  std::size_t below(std::size_t bound) {
    return bound == 0 ? 0 : static_cast<std::size_t>(next() % bound);
  }
  template <class Container>
  const auto& pick(const Container& from) {
    return from[below(from.size())];
  }

 private:
  std::uint64_t state_;
};

std::pair<std::size_t, std::size_t> any_line(const std::string& text, Random& random) {
  const std::size_t at = random.below(text.size());
  const std::size_t before = text.rfind('\n', at == 0 ? 0 : at - 1);
  const std::size_t start = before == std::string::npos || at == 0 ? 0 : before + 1;
  const std::size_t end = text.find('\n', at);
  return {start, (end == std::string::npos ? text.size() : end + 1) - start};
}

void mutate_once(std::string& text, const std::vector<std::string>& seeds,
                 Random& random) {
  const std::size_t at = random.below(text.size() + 1);
  const std::size_t some = 1 + random.below(random.below(4) == 0 ? 400 : 6);
  switch (random.below(16)) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(random.next());
      break;
    case 1:
      if (at < text.size()) {
        text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^
                                     1U << random.below(8));
      }
      break;
    case 2:
      text.insert(at, random.pick(fuzz::words()));
      break;
    case 3:
      text.erase(at, some);
      break;
    case 4:
      text.insert(at, text.substr(random.below(text.size() + 1), some));
      break;
    case 5: {  // a number becomes another one
      const std::size_t digit = text.find_first_of("0123456789", at);
      if (digit == std::string::npos) break;
      const std::size_t end =
          std::min(text.find_first_not_of("0123456789.", digit), text.size());
      text.replace(digit, end - digit, random.pick(fuzz::words()));
      break;
    }
    case 6: {  // a line goes
      const auto [start, length] = any_line(text, random);
      text.erase(start, length);
      break;
    }
    case 7: {  // a line appears elsewhere
      const auto [start, length] = any_line(text, random);
      const std::string line = text.substr(start, length);
      text.insert(any_line(text, random).first, line);
      break;
    }
    case 8: {  // the rest of another file
      const std::string& other = random.pick(seeds);
      text = text.substr(0, at) + other.substr(random.below(other.size() + 1));
      break;
    }
    case 9:
      if (random.below(4) == 0) text.resize(at);
      break;
    default: {  // a digit becomes another one: the file mostly stays readable
      const std::size_t digit = text.find_first_of("0123456789", at);
      if (digit != std::string::npos) {
        text[digit] = static_cast<char>('0' + random.below(10));
      }
      break;
    }
  }
  if (text.size() > kLongestInput) text.resize(kLongestInput);
}

std::string current_input;

void keep_input(int signal) {
  if (std::FILE* file = std::fopen("mutate_input.bin", "wb")) {
    std::fwrite(current_input.data(), 1, current_input.size(), file);
    std::fclose(file);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

struct Family {
  const char* name;
  fuzz::Outcome (*feed)(std::string_view);
  std::vector<std::string> seeds;
  long read = 0;
  long refused = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const long count = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 100'000;
  Random random(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  std::signal(SIGABRT, keep_input);
  std::signal(SIGSEGV, keep_input);

  const auto csv = [](std::string_view text) {
    return fuzz::feed_csv(text, &fuzz::survive_identification);
  };
  const auto candump = [](std::string_view text) {
    return fuzz::feed_candump(text, &fuzz::survive_identification);
  };
  std::array<Family, 7> families = {
      Family{"csv", csv, fuzz::csv_seeds()},
      Family{"candump", candump, fuzz::candump_seeds()},
      Family{"frames", &fuzz::feed_frames, fuzz::frames_seeds()},
      Family{"dbc", &fuzz::feed_dbc, fuzz::dbc_seeds()},
      Family{"uds", &fuzz::feed_uds, fuzz::uds_seeds()},
      Family{"isotp", &fuzz::feed_isotp, fuzz::isotp_seeds()},
      Family{"toml", &fuzz::feed_toml, fuzz::toml_seeds()}};
  for (const Family& family : families) {
    for (const std::string& seed : family.seeds) {
      if (family.feed(seed) == fuzz::Outcome::kAccepted) continue;
      std::fprintf(stderr, "a seed of %s is refused\n", family.name);
      return 1;
    }
  }

  double slowest_ms = 0;
  for (long i = 0; i < count; ++i) {
    Family& family = families[static_cast<std::size_t>(i) % families.size()];
    current_input = random.pick(family.seeds);
    for (std::size_t n = 1 + random.below(1 + random.below(6)); n > 0; --n) {
      mutate_once(current_input, family.seeds, random);
    }
    const auto start = std::chrono::steady_clock::now();
    const fuzz::Outcome outcome = family.feed(current_input);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    slowest_ms = std::max(slowest_ms, spent.count());
    ++(outcome == fuzz::Outcome::kAccepted ? family.read : family.refused);
  }

  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%ld mutations:", count);
  for (const Family& f : families)
    std::printf(" %s %ld read %ld refused,", f.name, f.read, f.refused);
  std::printf(" slowest %.1f ms, peak %ld MiB\n", slowest_ms, usage.ru_maxrss / 1024);
  return 0;
}
