#include "firmware/command_line.hpp"

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/event_loop.hpp"
#include "firmware/replay.hpp"
#include "firmware/replay_report.hpp"

namespace firmware {
namespace {

enum ExitCode : int { kDone = 0, kFailed = 1, kWrongUsage = 2, kBadInput = 3 };

constexpr const char* kUsage =
    R"(usage: stickbandd --config gateway.toml [--check [--offline] | --replay REC.log [--json] [--ask HEX]...]

  --config FILE   the configuration; firmware/gateway.toml shows every key
  --check         validates it, looks for the devices and the folders to write into, then
                  exits
  --offline       with --check: on a desk, without the devices; folders that are not
                  there are told only
  --replay LOG    runs on a candump log as fast as possible, with a line in memory
  --ask HEX       after the replay, asks the diagnostic server, e.g. --ask 22FD10
  --json          prints one object per line
  --version       prints the version

Signals: SIGHUP validates the configuration anew and swaps it in; SIGTERM ends.
Exit codes: 0 done, 1 failed (a device is not there, another daemon has the state file:
trying again may help), 2 wrong usage, 3 bad input (says where).
)";

struct Options {
  std::string config;
  std::string replay;
  std::vector<std::vector<std::uint8_t>> requests;
  bool check = false;
  bool offline = false;
  bool json = false;
  bool help = false;
  bool version = false;
};

int complain(const std::string& message, ExitCode code) {
  std::fprintf(stderr, "stickbandd: %s\n", message.c_str());
  return code;
}

// Empty, or what is wrong with the arguments.
std::string parse(const std::vector<std::string_view>& words, Options& options) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string_view word = words[k];
    const bool has_value = k + 1 < words.size();
    if (word == "--check") {
      options.check = true;
    } else if (word == "--offline") {
      options.offline = true;
    } else if (word == "--json") {
      options.json = true;
    } else if (word == "--help" || word == "-h") {
      options.help = true;
    } else if (word == "--version") {
      options.version = true;
    } else if (word != "--config" && word != "--replay" && word != "--ask") {
      return "expected an option, found \"" + std::string(word) + "\"; see --help";
    } else if (!has_value) {
      return "expected a value after " + std::string(word) +
             ", found nothing; see --help";
    } else if (word == "--config") {
      options.config = words[++k];
    } else if (word == "--replay") {
      options.replay = words[++k];
    } else {
      options.requests.push_back(bytes_of(words[++k]));
      if (options.requests.back().empty()) {
        return "expected pairs of hex digits after --ask, found \"" +
               std::string(words[k]) + "\"; write e.g. 22FD10";
      }
    }
  }
  if (options.help || options.version) return {};
  if (options.config.empty()) return "expected --config FILE; see --help";
  if (options.check && !options.replay.empty())
    return "--check and --replay exclude each other";
  if (options.offline && !options.check) return "--offline belongs to --check";
  if (options.replay.empty() && (options.json || !options.requests.empty())) {
    return "--json and --ask belong to --replay";
  }
  return {};
}

int replay(const Options& options) {
  const config::Gateway gateway = config::read_gateway(options.config);
  Replay replay(gateway);
  const auto print = [](const std::string& text) { std::fputs(text.c_str(), stdout); };
  const bool good = replay.play(options.replay, [&](const Notice& notice, double t_s) {
    print(event_line(notice, t_s, gateway, options.json));
  });
  if (!good) return complain(replay.error(), kBadInput);
  for (std::size_t k = 0; k < gateway.loops.size(); ++k) {
    print(summary_line(replay, k, options.json));
  }
  for (const auto& request : options.requests) {
    if (!gateway.uds) {
      return complain(options.config + ": expected [uds] for --ask, found none; add it",
                      kBadInput);
    }
    print(answer_line(request, replay.ask(request), options.json));
  }
  return std::fflush(stdout) == 0 ? kDone : complain("cannot write to stdout", kFailed);
}

int act(const Options& options) {
  const hal::SystemClock clock;
  if (!options.replay.empty()) return replay(options);
  if (options.check) {
    const std::string missing = check_gateway(options.config, clock, options.offline);
    if (!missing.empty()) std::fprintf(stderr, "%s\n", missing.c_str());
    std::printf(
        "%s: valid%s\n", options.config.c_str(),
        options.offline ? "; no device was looked for" : ", every device is there");
    return kDone;
  }
  Log log;
  EventLoop(clock, log).run(options.config);
  return kDone;
}

}  // namespace

int run(int argc, char** argv) {
  Options options;
  const std::string wrong = parse({argv + 1, argv + argc}, options);
  if (!wrong.empty()) return complain(wrong, kWrongUsage);
  if (options.help || options.version) {
    std::fputs(options.help ? kUsage : "stickbandd " STICKBAND_VERSION "\n", stdout);
    return kDone;
  }
  try {
    return act(options);
  } catch (const config::ConfigError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    return complain(error.what(), kFailed);
  }
}

}  // namespace firmware
