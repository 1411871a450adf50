// How often state, windows and history are written, whatever happens.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "firmware/daemon.hpp"
#include "firmware/history_keeper.hpp"
#include "firmware/state_keeper.hpp"
#include "firmware/sticking_plant.hpp"
#include "support/base/fixed_random.hpp"
#include "support/base/temporary_folder.hpp"
#include "support/ident/microseconds.hpp"

namespace firmware {
namespace {

using test::kSecond;
constexpr int kHour_s = 3600;

class Kept : public testing::Test {
 protected:
  // A daemon with a fast loop and, on request, a slow one; what it keeps goes to files.
  void start(bool slow = false, const std::string& gateway = "") {
    const auto loop = [](int id, const char* tag, int period_s) {
      const std::string signal =
          " = { source = \"can\", start = 0, length = 16, scale = 0.01, frame_id = ";
      return "[[loop]]\nid = " + std::to_string(id) + "\ntag = \"" + tag +
             "\"\nsample_period_s = " + std::to_string(period_s) + "\nu" + signal +
             "0x204 }\ny" + signal + "0x205 }\n";
    };
    configuration = config::parse_gateway(
        gateway + "[bus.a]\nbackend = \"slcan\"\nport = 0\n[uds]\n[state]\npath = \"" +
            path + "\"\nperiod_s = 1.0\n[history]\npath = \"" + path + ".history\"\n" +
            loop(1, "A", 1) + (slow ? loop(2, "B", 20) : ""),
        "g.toml");
    budget.set(configuration.writes_per_hour);
    daemon = std::make_unique<Daemon>(configuration, random, "1");
    state = std::make_unique<StateKeeper>(configuration, log);
    history = std::make_unique<HistoryKeeper>(*configuration.history, log);
    state->restore(*daemon, now);
    ASSERT_TRUE(history->open(*daemon, now.us));
  }
  // One second, with samples or without.
  void turn(bool samples) {
    now.us += kSecond;
    now.epoch_us += kSecond;
    plant.next();
    std::vector<BusFrame> frames;
    if (samples) {
      frames = {{0, now.us, percent_frame(0x204, plant.u)},
                {0, now.us, percent_frame(0x205, plant.y)}};
    }
    const Outputs& out = daemon->step(now, {frames, {}, buses});
    state->keep(*daemon, now, budget);
    history->take(out.rows);
    history->keep(now.us, budget);
    state->settle();
    history->settle();
  }
  // Its DTC is raised and given up once in 16 s.
  [[nodiscard]] static bool flickers(int second) { return second % 16 < 10; }
  void take_row(int loop) {
    LoopRow row{loop, {}};
    row.row.verdict = wire::LoopVerdict::kStiction;
    row.row.time_s = static_cast<std::uint32_t>(now.epoch_us / kSecond);
    history->take({&row, 1});
  }
  // Of the log so far.
  [[nodiscard]] int lines_with(const char* text) const {
    std::rewind(told.get());
    std::array<char, 256> line;
    int lines = 0;
    while (std::fgets(line.data(), line.size(), told.get()) != nullptr) {
      lines += std::string(line.data()).find(text) != std::string::npos;
    }
    return lines;
  }
  [[nodiscard]] std::uint32_t writes() const {
    return state->writes() + history->writes();
  }

  TemporaryFolder folder;
  std::string path = folder.file("state");
  Now now{kSecond, 1'700'000'000 * kSecond};
  config::Gateway configuration;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> told{std::tmpfile(), std::fclose};
  Log log{told.get()};
  FixedRandom random;
  WriteBudget budget{60};
  std::unique_ptr<Daemon> daemon;
  std::unique_ptr<StateKeeper> state;
  std::unique_ptr<HistoryKeeper> history;
  Plant plant{true};
  std::vector<BusState> buses = {{.up = true}};
};

TEST_F(Kept, WhateverHappensThereAreSixtyWritesAnHourAtMost) {
  start(true);
  std::uint32_t before = 0;
  std::string windows;
  int age_s = 0;  // of them
  int oldest_s = 0;
  for (int hour = 0; hour < 2; ++hour) {
    for (int second = 0; second < kHour_s; ++second) {
      turn(flickers(second));
      take_row(1 + second % 2);
      // Their bytes tell a write; two may fall into one tick of the file's clock.
      std::ifstream file(path + ".windows", std::ios::binary);
      std::string bytes{std::istreambuf_iterator<char>(file), {}};
      age_s = bytes == windows ? age_s + 1 : 0;
      windows = std::move(bytes);
      oldest_s = std::max(oldest_s, age_s);
    }
    std::printf("writes in hour %d: %u, of which the history %u\n", hour,
                writes() - before, history->writes());
    EXPECT_LE(writes() - before, 60U);
    EXPECT_GE(writes() - before, 50U) << "what may be written is";
    before = writes();
  }
  EXPECT_TRUE(std::filesystem::exists(path));
  std::printf("windows of the slow loop: %d s old at most\n", oldest_s);
  EXPECT_LE(oldest_s, 400);
  EXPECT_GE(history->writes(), 20U);
  EXPECT_EQ(history->failures(), 0U) << "no row is lost";
}

TEST_F(Kept, WhereNothingHappensNothingIsWritten) {
  start();
  for (int second = 0; second < 300; ++second) turn(second < 10);
  const std::uint32_t before = writes();
  EXPECT_LE(before, 5U);
  for (int second = 0; second < kHour_s; ++second) turn(false);
  EXPECT_EQ(writes(), before);
}

TEST_F(Kept, AChangeAfterAQuietTimeIsInTheFileAtOnce) {
  start();
  for (int second = 0; second < 600; ++second) {
    turn(true);
    if (second % 50 == 0) take_row(1);
  }
  const auto saved = [&] {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string before = saved();
  ASSERT_FALSE(before.empty());
  for (int second = 0; second < 6; ++second) turn(false);  // stale after five
  ASSERT_EQ(daemon->loops()[0].input, wire::InputStatus::kMissing);
  turn(false);
  turn(false);
  EXPECT_NE(saved(), before);
}

TEST_F(Kept, WhatCannotBeSavedAtTheEndIsTold) {
  start();
  for (int second = 0; second < 60; ++second) turn(true);
  state->finish(*daemon, now);
  EXPECT_EQ(lines_with("cannot be written"), 0);
  std::filesystem::create_directories(path + ".new/inside");
  for (int second = 0; second < 6; ++second) {
    now.us += kSecond;
    (void)daemon->step(now, {{}, {}, buses});
  }
  state->finish(*daemon, now);
  EXPECT_EQ(lines_with("cannot be written"), 1);
  EXPECT_EQ(lines_with("what was saved before"), 1);
}

TEST_F(Kept, WhatFailsIsTriedAgainLessAndLessOften) {
  std::filesystem::create_directories(path + ".new/inside");
  start();
  for (int second = 0; second < kHour_s; ++second) turn(flickers(second));
  EXPECT_GE(state->failures(), 50U);
  EXPECT_LE(state->failures(), 70U);
  EXPECT_EQ(lines_with("cannot be written"), 1) << "told once";
  std::filesystem::remove_all(path + ".new");
  for (int second = 0; second < 61; ++second) turn(false);
  EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(Kept, MoreMayBeAllowed) {
  start(false, "[gateway]\nwrites_per_hour = 3600\n");
  for (int second = 0; second < 600; ++second) turn(flickers(second));
  EXPECT_GE(state->writes(), 60U);
}

}  // namespace
}  // namespace firmware
