#include "firmware/command_line.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "firmware/event_loop.hpp"
#include "firmware/history_file.hpp"
#include "firmware/learn/learn.hpp"
#include "firmware/replay.hpp"
#include "firmware/replay_report.hpp"
#include "wire/history_csv.hpp"
#include "wire/text.hpp"

namespace firmware {
namespace {

enum ExitCode : int { kDone = 0, kFailed = 1, kWrongUsage = 2, kBadInput = 3 };

constexpr std::chrono::seconds kPause(1);

constexpr const char* kUsage =
    R"(usage: stickbandd --config gateway.toml [--check [--offline]
                  | --replay REC.log [--json] [--ask HEX]... | --history LOOP]
       stickbandd --learn (--can IF [--seconds N] | --replay REC.log)
                  [--dbc FILE] [--json]

  --config FILE   the configuration; firmware/gateway.toml shows every key
  --check         validates it, looks for the devices and the folders to write
                  into, then exits
  --offline       with --check: on a desk, without the devices; folders that are
                  not there are told only
  --replay LOG    runs on a candump log as fast as possible, with a line in memory
  --ask HEX       after the replay, asks the diagnostic server: --ask 22FD10
  --history LOOP  prints what the windows of that loop said, for years, as CSV,
                  from the file of the configuration; a daemon may be writing it
  --learn         before there is a configuration: lists the frames of a bus or a
                  log and the signals in them, and proposes u and y of loops with a
                  configuration to paste; sends nothing, writes nothing
  --can IF        a CAN interface that is up, or slcan:PORT
  --seconds N     to listen, 1 to 86400, default 60; Ctrl-C ends it sooner
  --dbc FILE      names the signals; without it 16-bit numbers are guessed
  --json          prints one object per line
  --version       prints the version

Signals: SIGHUP validates the configuration anew and swaps it in; SIGTERM ends.
Exit codes: 0 done, 1 failed (a device is not there, another daemon has the state
file: trying again may help), 2 wrong usage, 3 bad input (says where).
)";

struct Options {
  std::string config;
  std::string replay;
  std::string history;
  std::string can;
  std::string dbc;
  std::string seconds;
  double listen_s = LearnSettings{}.seconds;
  std::string ask;  // the last one
  std::vector<std::vector<std::uint8_t>> requests;
  bool learn = false;
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

bool parse_seconds(std::string_view text, double& seconds) {
  seconds = wire::number_of<double>(text).value_or(0);
  return seconds >= 1 && seconds <= 86400;
}

std::string check_learning(const Options& options) {
  if (options.can.empty() == options.replay.empty()) {
    return "expected one of --can IF and --replay LOG with --learn; see --help";
  }
  if (!options.config.empty() || options.check || options.offline ||
      !options.history.empty() || !options.requests.empty()) {
    return "expected only --dbc, --seconds and --json beside --learn; see --help";
  }
  return {};
}

// Empty, or which options do not go together.
std::string check_together(const Options& options) {
  if (options.help || options.version) return {};
  if (options.learn) return check_learning(options);
  if (!options.can.empty() || !options.dbc.empty()) {
    return "--can and --dbc belong to --learn";
  }
  if (options.config.empty()) return "expected --config FILE; see --help";
  if (options.check + !options.replay.empty() + !options.history.empty() > 1) {
    return "expected one of --check, --replay and --history, found more; see --help";
  }
  if (options.offline && !options.check) return "--offline belongs to --check";
  if (options.replay.empty() && (options.json || !options.requests.empty())) {
    return "--json and --ask belong to --replay";
  }
  return {};
}

struct Word {
  std::string_view name;
  bool Options::*flag;  // null: a value follows, for
  std::string Options::*text;
};

constexpr std::array kWords = {
    Word{"--check", &Options::check, nullptr},
    Word{"--offline", &Options::offline, nullptr},
    Word{"--learn", &Options::learn, nullptr},
    Word{"--json", &Options::json, nullptr},
    Word{"--help", &Options::help, nullptr},
    Word{"-h", &Options::help, nullptr},
    Word{"--version", &Options::version, nullptr},
    Word{"--config", nullptr, &Options::config},
    Word{"--replay", nullptr, &Options::replay},
    Word{"--history", nullptr, &Options::history},
    Word{"--can", nullptr, &Options::can},
    Word{"--dbc", nullptr, &Options::dbc},
    Word{"--seconds", nullptr, &Options::seconds},
    Word{"--ask", nullptr, &Options::ask},
};

// Empty, or what is wrong with the arguments.
std::string parse(const std::vector<std::string>& words, Options& options) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    const auto* const known = std::ranges::find(kWords, word, &Word::name);
    if (known == kWords.end()) {
      return "expected an option, found \"" + word + "\"; see --help";
    }
    if (known->flag != nullptr) {
      options.*known->flag = true;
      continue;
    }
    if (++k == words.size()) {
      return "expected a value after " + word + ", found nothing; see --help";
    }
    const std::string& value = options.*known->text = words[k];
    if (word == "--seconds" && !parse_seconds(value, options.listen_s)) {
      return "expected 1 to 86400 after --seconds, found \"" + value + '"';
    }
    if (word != "--ask") continue;
    options.requests.push_back(bytes_of(value));
    if (options.requests.back().empty()) {
      return "expected pairs of hex digits after --ask, found \"" + value +
             "\"; write e.g. 22FD10";
    }
  }
  return check_together(options);
}

void tell_cut(const std::string& log, std::size_t line) {
  if (line == 0) return;
  std::fprintf(stderr, "stickbandd: %s:%zu: the last line is cut and was left out\n",
               log.c_str(), line);
}

int replay(const Options& options) {
  const config::Gateway gateway = config::read_gateway(options.config);
  Replay replay(gateway);
  const auto print = [](const std::string& text) { std::fputs(text.c_str(), stdout); };
  const bool good = replay.play(options.replay, [&](const Notice& notice, double t_s) {
    print(event_line(notice, t_s, gateway, options.json));
  });
  if (!good) return complain(replay.error(), kBadInput);
  for (const std::string& line : sources_beside_can(gateway)) {
    std::fprintf(stderr, "stickbandd: %s\n", line.c_str());
  }
  tell_cut(options.replay, replay.cut_line());
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

int print_history(const Options& options) {
  const config::Gateway gateway = config::read_gateway(options.config);
  if (!gateway.history) {
    return complain(options.config + ": expected [history], found none; add it",
                    kBadInput);
  }
  const auto loop =
      std::ranges::find_if(gateway.loops, [&](const config::Loop& candidate) {
        return std::to_string(candidate.id) == options.history ||
               candidate.tag == options.history;
      });
  if (loop == gateway.loops.end()) {
    std::string known;
    for (const config::Loop& one : gateway.loops) {
      known +=
          (known.empty() ? "" : ", ") + std::to_string(one.id) + " (" + one.tag + ')';
    }
    return complain("expected the id or the tag of a loop after --history, found \"" +
                        options.history + "\"; " + options.config + " has " + known,
                    kBadInput);
  }
  HistoryFile file(gateway.history->path);
  if (!file.open_to_read()) {
    return complain(file.path() + ": expected a history, found " +
                        (errno != 0 ? std::strerror(errno) : "something else"),
                    kBadInput);
  }
  const std::string_view header = wire::history_csv_header();
  std::fwrite(header.data(), 1, header.size(), stdout);
  for (const HistoryLoop& known : file.loops()) {
    if (known.id != loop->id || known.tag != loop->tag) continue;
    std::array<char, wire::kMostHistoryLine> line;
    for (const wire::HistoryRow& row : file.rows(known.id)) {
      std::fwrite(line.data(), 1, wire::write_history_line(row, line), stdout);
    }
  }
  return std::fflush(stdout) == 0 ? kDone : complain("cannot write to stdout", kFailed);
}

int learn(const Options& options) {
  const Learned learned =
      firmware::learn({options.replay, options.can, options.dbc, options.listen_s});
  tell_cut(options.replay, learned.cut_line);
  std::fputs((options.json ? learned_json(learned) : learned_text(learned)).c_str(),
             stdout);
  return std::fflush(stdout) == 0 ? kDone : complain("cannot write to stdout", kFailed);
}

int act(const Options& options) {
  if (options.learn) return learn(options);
  const hal::SystemClock clock;
  if (!options.history.empty()) return print_history(options);
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
    const int code = complain(error.what(), kFailed);
    // The unit starts at once again what was killed; what waits for a device has time.
    if (std::getenv("NOTIFY_SOCKET") != nullptr) std::this_thread::sleep_for(kPause);
    return code;
  }
}

}  // namespace firmware
