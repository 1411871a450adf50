// A reboot costs neither the flag nor what earlier windows said.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "firmware/daemon.hpp"
#include "firmware/history_file.hpp"
#include "firmware/metrics.hpp"
#include "firmware/notice_text.hpp"
#include "firmware/process.hpp"
#include "firmware/sticking_plant.hpp"
#include "support/base/fixed_random.hpp"
#include "support/base/temporary_folder.hpp"
#include "support/ident/microseconds.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"
#include "wire/history_csv.hpp"

namespace firmware {
namespace {

using test::kSecond;

std::string text_with(const std::string& more) {
  return "[bus.a]\nbackend = \"slcan\"\nport = 0\n[uds]\n"
         "[broadcast]\ndetail_base_id = 0x1B0\n"
         "[[loop]]\nid = 1\ntag = \"A\"\nsample_period_s = 1.0\n"
         "u = { source = \"can\", frame_id = 0x204, start = 0, length = 16, scale = 0.01 "
         "}\ny = { source = \"can\", frame_id = 0x205, start = 0, length = 16, scale = "
         "0.01 }\n" +
         more;  // of the loop, or tables
}

class Restarted {
 public:
  explicit Restarted(const std::string& more = "")
      : configuration_(config::parse_gateway(text_with(more), "g.toml")),
        daemon_(std::make_unique<Daemon>(configuration_, random_, "1")) {}

  // That many seconds of a sticking loop.
  void run(int seconds) {
    for (int k = 0; k < seconds; ++k) {
      plant_.next();
      now.us += kSecond;
      now.epoch_us += kSecond;
      step({{0, now.us, percent_frame(0x204, plant_.u)},
            {0, now.us, percent_frame(0x205, plant_.y)}});
      while (daemon_->work(1000)) {
      }
    }
  }
  const Outputs& step(std::vector<BusFrame> frames = {}) {
    const Outputs& out = daemon_->step(now, {frames, {}, buses_});
    for (const Notice& notice : out.notices) notices.push_back(notice);
    for (const LoopRow& row : out.rows) rows.push_back(row);
    return out;
  }
  void recall(std::span<const wire::HistoryRow> history) { daemon_->recall(0, history); }
  [[nodiscard]] std::vector<std::uint8_t> save() const {
    std::vector<std::uint8_t> image(wire::kMostStateBytes);
    image.resize(daemon_->save(image));
    return image;
  }
  [[nodiscard]] std::vector<std::uint8_t> save_windows() const {
    std::vector<std::uint8_t> image(wire::windows_bytes(1, Monitor::kCapacity));
    const std::size_t size = daemon_->save_windows(now, 0, image);
    image.resize(size + 4);
    wire::put_big_endian(wire::crc32(std::span(image).first(size)),
                         std::span(image).subspan(size));
    return image;
  }
  [[nodiscard]] Daemon::Resumed restore_windows(std::span<const std::uint8_t> image,
                                                bool calendar = false) {
    return daemon_->restore_windows(image, now, calendar);
  }
  [[nodiscard]] const Monitor& monitor() const { return daemon_->loop(0).monitor(); }
  [[nodiscard]] const Daemon& daemon() const { return *daemon_; }
  [[nodiscard]] Daemon& daemon() { return *daemon_; }
  [[nodiscard]] wire::StateError restore(std::span<const std::uint8_t> image) {
    return daemon_->restore(image, now);
  }
  [[nodiscard]] const wire::LoopStatus& status() const { return daemon_->loops()[0]; }
  [[nodiscard]] bool told(NoticeKind kind, const std::string& text) const {
    for (const Notice& notice : notices) {
      const std::string line(text_of(notice, configuration_).view());
      if (notice.kind == kind && line.find(text) != std::string::npos) return true;
    }
    return false;
  }

  Now now{kSecond, 1'700'000'000 * kSecond};
  std::vector<Notice> notices;
  std::vector<LoopRow> rows;

 private:
  Plant plant_{true};
  FixedRandom random_;
  config::Gateway configuration_;
  std::unique_ptr<Daemon> daemon_;
  std::vector<BusState> buses_ = {{.up = true}};
};

// One gateway whose flag is raised; it is made once.
const Restarted& flagged() {
  static const auto gateway = [] {
    auto out = std::make_unique<Restarted>();
    out->run(2100);
    return out;
  }();
  return *gateway;
}

TEST(Restart, TheFlagIsBackWithTheFirstStepMarkedWithItsAge) {
  ASSERT_TRUE(flagged().status().flag);
  Restarted gateway;
  gateway.now = {50 * kSecond, flagged().now.epoch_us + 600 * kSecond};
  ASSERT_EQ(gateway.restore(flagged().save()), wire::StateError::kNone);
  EXPECT_TRUE(gateway.daemon().flags()[0]) << "line, before any step";
  const Outputs& out = gateway.step();
  EXPECT_TRUE(out.flags[0]) << "line";
  const wire::LoopStatus& status = gateway.status();
  EXPECT_TRUE(status.flag);
  EXPECT_EQ(status.verdict, wire::LoopVerdict::kStiction);
  EXPECT_NEAR(status.age_s, flagged().status().age_s + 600, 0.01);
  EXPECT_EQ(status.changed_ms, flagged().status().changed_ms) << "since then";
  EXPECT_NEAR(status.stick_band_pct.ascending,
              flagged().status().stick_band_pct.ascending, 1e-4);
  ASSERT_GE(out.frames.size(), 3U);
  EXPECT_EQ(out.frames[0].frame.id, 0x191U);
  EXPECT_EQ(out.frames[0].frame.data[0], 4) << "status frame";
  EXPECT_EQ(out.frames[2].frame.id, 0x1D1U);
  const auto age =
      static_cast<double>(out.frames[2].frame.data[2] << 8 | out.frames[2].frame.data[3]);
  EXPECT_NEAR(age, status.age_s, 0.5) << "third status frame";
  std::string metrics;
  write_metrics({gateway.daemon().gateway(), gateway.daemon().loops()}, "g", metrics);
  EXPECT_NE(metrics.find("stickband_loop_flag{loop=\"1\",tag=\"A\"} 1"),
            std::string::npos);
  EXPECT_TRUE(gateway.told(NoticeKind::kFlagKept, "FLAG RAISED as before, by a window"));
  EXPECT_FALSE(gateway.told(NoticeKind::kFlagRaised, ""));
}

TEST(Restart, NothingElseIsCountedTwice) {
  Restarted gateway;
  gateway.now = {kSecond, flagged().now.epoch_us};
  ASSERT_EQ(gateway.restore(flagged().save()), wire::StateError::kNone);
  gateway.step();
  const auto urgent = [](const std::vector<std::uint8_t>& image) {
    return std::vector(image.begin(), image.begin() + static_cast<std::ptrdiff_t>(
                                                          wire::urgent_bytes(1)));
  };
  EXPECT_EQ(urgent(gateway.save()), urgent(flagged().save())) << "no confirmation more";
}

TEST(Restart, TheEvidenceFadesAsIfWindowsHadBeenMissed) {
  const ident::EvidencePool before = flagged().daemon().loop(0).monitor().memory().pool;
  ASSERT_GT(before.windows(), 0);
  Restarted gateway;
  gateway.now = {kSecond, flagged().now.epoch_us + 20 * 2048 * kSecond};
  ASSERT_EQ(gateway.restore(flagged().save()), wire::StateError::kNone);
  const ident::MonitorMemory after = gateway.daemon().loop(0).monitor().memory();
  EXPECT_LT(after.pool.windows(), 0.13F * before.windows());
  EXPECT_GT(after.pool.windows(), 0.1F * before.windows());
  EXPECT_TRUE(gateway.status().flag) << "until windows speak against it";

  Restarted again;
  again.now = gateway.now;
  ASSERT_EQ(again.restore(gateway.save()), wire::StateError::kNone);
  EXPECT_EQ(again.daemon().loop(0).monitor().memory().pool.windows(),
            after.pool.windows())
      << "faded once";
}

TEST(Restart, ACalendarThatIsNotSetYetFadesNothingAndKnowsNoAge) {
  Restarted gateway;
  gateway.now = {kSecond, 1000 * kSecond};
  ASSERT_EQ(gateway.restore(flagged().save()), wire::StateError::kNone);
  gateway.step();
  EXPECT_TRUE(gateway.status().flag);
  EXPECT_TRUE(std::isnan(gateway.status().age_s));
  EXPECT_TRUE(gateway.told(NoticeKind::kFlagKept, "unknown age"));
  EXPECT_EQ(gateway.daemon().loop(0).monitor().memory().pool.windows(),
            flagged().daemon().loop(0).monitor().memory().pool.windows());
}

TEST(Restart, WhatAnotherConfigurationKnewIsNotTakenOver) {
  for (const char* other :
       {"span = [0.0, 50.0]\n", "y_span = [0.0, 10.0]\n", "gain_sign = \"positive\"\n"}) {
    Restarted gateway(other);
    ASSERT_EQ(gateway.restore(flagged().save()), wire::StateError::kNone);
    gateway.step();
    EXPECT_FALSE(gateway.status().flag) << other;
    EXPECT_EQ(gateway.status().window_verdict, wire::LoopVerdict::kNotEvaluated) << other;
    EXPECT_EQ(gateway.daemon().loop(0).monitor().memory().pool.windows(), 0) << other;
  }
}

// The program itself, from its start to what others see.
TEST(Restart, TheProgramRaisesItWithinTwoSeconds) {
  const TemporaryFolder files;
  const auto image = flagged().save();
  std::ofstream(files.file("state"), std::ios::binary)
      .write(reinterpret_cast<const char*>(image.data()),
             static_cast<std::streamsize>(image.size()));
  std::ofstream(files.file("g.toml"))
      << text_with("[metrics]\npath = \"a.prom\"\n[state]\npath = \"state\"\n")
      << std::flush;
  const auto start = std::chrono::steady_clock::now();
  const Process daemon({STICKBAND_DAEMON, "--config", files.file("g.toml")});
  ASSERT_TRUE(daemon.says("A: FLAG RAISED as before")) << daemon.err();
  std::string metrics;
  while (metrics.find("stickband_loop_flag{loop=\"1\",tag=\"A\"} 1") ==
             std::string::npos &&
         std::chrono::steady_clock::now() - start < std::chrono::seconds(2)) {
    metrics = ::text_of(files.file("a.prom"));
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::printf("flag in the textfile %.2f s after the start\n", took.count());
  EXPECT_LT(took.count(), 2.0);
  EXPECT_NE(metrics.find("stickband_loop_age_s{loop=\"1\",tag=\"A\"} "),
            std::string::npos);
}

TEST(Restart, WindowsOfTheHistoryMakeTheTrend) {
  std::vector<wire::HistoryRow> rows(150);
  std::uint32_t time_s = 1'690'000'000;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].verdict = wire::LoopVerdict::kStiction;
    rows[k].time_s = time_s += 86'400;
    const double band =
        0.5 + 0.005 * static_cast<double>(k) + 0.01 * static_cast<double>(k % 3);
    rows[k].stick_band_pct = {band, band - 0.1};
  }
  Restarted gateway;
  gateway.recall(rows);
  gateway.step();
  EXPECT_NEAR(gateway.status().trend_pct_per_day, 0.005, 0.0002);
  EXPECT_LE(gateway.status().trend_low_pct_per_day, 0.005);
  EXPECT_GE(gateway.status().trend_high_pct_per_day, 0.005);
  EXPECT_NEAR(gateway.status().days_to_limit, (2 - 1.25) / 0.005, 8);
  EXPECT_FALSE(gateway.told(NoticeKind::kTrend, "")) << "it is not new";

  rows[60].verdict = wire::LoopVerdict::kNotEvaluated;  // a reset
  Restarted mended;
  mended.recall(rows);
  EXPECT_GT(
      mended.status().trend_high_pct_per_day - mended.status().trend_low_pct_per_day,
      gateway.status().trend_high_pct_per_day - gateway.status().trend_low_pct_per_day)
      << "of the days after it alone";
}

TEST(Restart, DueWindowsAreRowsOfTheHistory) {
  const Restarted& gateway = flagged();
  ASSERT_EQ(gateway.rows.size(),
            gateway.daemon().loop(0).monitor().report().counters.evaluations);
  EXPECT_EQ(gateway.rows.back().loop, 1);
  const wire::HistoryRow& row = gateway.rows.back().row;
  EXPECT_EQ(row.verdict, wire::LoopVerdict::kStiction);
  EXPECT_TRUE(row.flag);
  EXPECT_EQ(row.stick_band_pct.ascending, gateway.status().stick_band_pct.ascending);
  EXPECT_NEAR(static_cast<double>(row.time_s),
              static_cast<double>(gateway.now.epoch_us) / 1e6 - gateway.status().age_s,
              1);
}

TEST(Restart, TheProgramPrintsAHistory) {
  const TemporaryFolder files;
  std::ofstream(files.file("g.toml"))
      << text_with("[history]\npath = \"history\"\n") << std::flush;
  const auto ask = [&](const char* loop) {
    return Process(
               {STICKBAND_DAEMON, "--config", files.file("g.toml"), "--history", loop})
        .wait();
  };
  EXPECT_EQ(ask("1").code, 3) << "there is no file yet";
  {
    const Process daemon({STICKBAND_DAEMON, "--config", files.file("g.toml")});
    ASSERT_TRUE(daemon.says("started")) << daemon.err();
    EXPECT_EQ(ask("A").out, wire::history_csv_header()) << "while it runs";
  }
  {
    HistoryFile file(files.file("history"));
    const std::vector<HistoryLoop> loops = {
        {1, "A", flagged().daemon().loop(0).configuration_crc()}};
    ASSERT_EQ(file.open(loops), HistoryFile::Opened::kGood);
    for (const LoopRow& row : flagged().rows) file.add(1, row.row);
    file.finish();
  }
  const Process::Result result = ask("1");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find(",stiction,1,"), std::string::npos) << result.out;
  const Process::Result unknown = ask("2");
  EXPECT_EQ(unknown.code, 3);
  EXPECT_NE(unknown.err.find("g.toml has 1 (A)"), std::string::npos) << unknown.err;
}

// `flagged` stopped; the program is back so many seconds later. `anew`: the machine, too.
std::unique_ptr<Restarted> back_after(int seconds, bool anew = false) {
  auto gateway = std::make_unique<Restarted>();
  gateway->now = flagged().now;
  gateway->now.us = anew ? 5 * kSecond : gateway->now.us + seconds * kSecond;
  gateway->now.epoch_us += seconds * kSecond;
  EXPECT_EQ(gateway->restore(flagged().save()), wire::StateError::kNone);
  return gateway;
}

TEST(Restart, TheWindowGoesOnAsIfNothingHadBeen) {
  const auto gateway = back_after(1);
  const Daemon::Resumed resumed = gateway->restore_windows(flagged().save_windows());
  EXPECT_EQ(resumed.error, wire::StateError::kNone);
  EXPECT_EQ(resumed.loops, 1);
  EXPECT_NEAR(resumed.age_s, 1, 0.6);
  const Monitor& monitor = gateway->monitor();
  EXPECT_EQ(monitor.window().size(), Monitor::kCapacity);
  EXPECT_EQ(monitor.unjudged(), flagged().monitor().unjudged()) << "no evidence twice";
  const float known = flagged().monitor().memory().pool.windows();
  EXPECT_NEAR(monitor.memory().pool.windows(), known, 0.01F * known);
  EXPECT_EQ(monitor.report().samples.gaps, 0U);
  EXPECT_EQ(monitor.report().counters.evaluations, 0U);
  EXPECT_TRUE(gateway->notices.empty());
  gateway->run(10);
  EXPECT_EQ(monitor.window().size(), Monitor::kCapacity) << "a second is held";
  gateway->run(520);
  EXPECT_GE(monitor.report().counters.evaluations, 1U);
  EXPECT_EQ(monitor.report().window_samples, Monitor::kCapacity);
  EXPECT_TRUE(gateway->status().flag);
}

// While a loop is in manual u keeps its value: those samples say nothing of the valve.
TEST(Restart, SamplesOfBeforeAFaultAreGone) {
  Restarted gateway;
  gateway.run(300);
  for (int k = 0; k < 1000; ++k) {
    gateway.now.us += kSecond;
    gateway.now.epoch_us += kSecond;
    gateway.step({{0, gateway.now.us, percent_frame(0x204, 50)},
                  {0, gateway.now.us, percent_frame(0x205, 40 + k % 7)}});
  }
  ASSERT_EQ(gateway.monitor().report().fault, ident::InputFault::kFrozenU);
  gateway.run(300);
  ASSERT_EQ(gateway.monitor().report().fault, ident::InputFault::kNone);
  ASSERT_LE(gateway.monitor().usable(), 300U);
  Restarted again;
  again.now = gateway.now;
  again.now.us += kSecond;
  again.now.epoch_us += kSecond;
  ASSERT_EQ(again.restore_windows(gateway.save_windows()).loops, 1);
  EXPECT_EQ(again.monitor().usable(), gateway.monitor().usable());
}

TEST(Restart, AGapOfTheWindowIsAGap) {
  const auto gateway = back_after(60);
  EXPECT_EQ(gateway->restore_windows(flagged().save_windows()).loops, 1);
  EXPECT_EQ(gateway->monitor().window().size(), Monitor::kCapacity) << "to be pulled";
  gateway->run(20);
  EXPECT_LE(gateway->monitor().window().size(), 20U);
  EXPECT_EQ(gateway->monitor().report().samples.restarts, 1U);
  EXPECT_TRUE(gateway->status().flag);
}

TEST(Restart, AMachineThatWasOffKnowsTheAgeByItsCalendarOrNotAtAll) {
  const auto without = back_after(7, true);
  const Daemon::Resumed unknown = without->restore_windows(flagged().save_windows());
  EXPECT_EQ(unknown.error, wire::StateError::kNone);
  EXPECT_EQ(unknown.loops, 0);
  EXPECT_TRUE(without->monitor().window().empty());

  const auto with = back_after(7, true);
  const Daemon::Resumed known = with->restore_windows(flagged().save_windows(), true);
  EXPECT_EQ(known.loops, 1);
  EXPECT_NEAR(known.age_s, 7, 0.6);

  // A calendar that was set back says that the window ended after this start.
  const auto wrong = back_after(3, true);
  const Daemon::Resumed least = wrong->restore_windows(flagged().save_windows(), true);
  EXPECT_GE(least.age_s, 5) << "the machine has been on for so long";
}

TEST(Restart, AWindowOfAnotherConfigurationOrTimeIsNotTakenOver) {
  Restarted other("span = [0.0, 50.0]\n");
  other.now = flagged().now;
  EXPECT_EQ(other.restore_windows(flagged().save_windows()).loops, 0);
  Restarted early;
  early.now = flagged().now;
  early.now.us -= 100 * kSecond;
  early.now.epoch_us -= 100 * kSecond;
  EXPECT_EQ(early.restore_windows(flagged().save_windows()).loops, 0)
      << "samples to come";
}

TEST(Restart, AWindowWithoutItsEvidenceIsNewWithAnotherItIsKnown) {
  Restarted fresh;
  fresh.now = flagged().now;
  EXPECT_EQ(fresh.restore_windows(flagged().save_windows()).loops, 1);
  EXPECT_EQ(fresh.monitor().unjudged(), Monitor::kCapacity) << "no state";

  Restarted further;
  further.now = flagged().now;
  ASSERT_EQ(further.restore(flagged().save()), wire::StateError::kNone);
  further.run(2100);
  Restarted mixed;
  mixed.now = flagged().now;
  ASSERT_EQ(mixed.restore(further.save()), wire::StateError::kNone);
  EXPECT_EQ(mixed.restore_windows(flagged().save_windows()).loops, 1);
  EXPECT_EQ(mixed.monitor().unjudged(), 0U) << "the state is of a later window";
}

TEST(Restart, OnlySlowLoopsAreSavedWhereThatIsAsked) {
  std::vector<std::uint8_t> image(wire::windows_bytes(1, Monitor::kCapacity));
  Restarted gateway;
  EXPECT_EQ(gateway.daemon().save_windows(gateway.now, 0, image), 0U) << "no sample yet";
  gateway.run(20);
  EXPECT_GT(gateway.save_windows().size(), 100U);
  EXPECT_EQ(gateway.daemon().save_windows(gateway.now, 20, image), 0U);
  EXPECT_EQ(gateway.daemon().save_windows(gateway.now, 0, std::span(image).first(64)), 0U)
      << "no room";
}

TEST(Restart, WindowsAfterItDecideAgain) {
  Restarted gateway;
  gateway.now = {kSecond, flagged().now.epoch_us + 60 * kSecond};
  ASSERT_EQ(gateway.restore(flagged().save()), wire::StateError::kNone);
  gateway.run(2100);
  EXPECT_TRUE(gateway.status().flag);
  EXPECT_LT(gateway.status().age_s, 2100) << "a new window";
  EXPECT_FALSE(gateway.told(NoticeKind::kFlagLowered, ""));
}

}  // namespace
}  // namespace firmware
