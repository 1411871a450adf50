// What a restart costs: loops that are sampled faster than a program starts, and the time
// that a program with all loops, windows and years of history takes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "firmware/daemon.hpp"
#include "firmware/history_file.hpp"
#include "firmware/process.hpp"
#include "firmware/sticking_plant.hpp"
#include "hal/clock.hpp"
#include "support/base/fixed_random.hpp"
#include "support/base/temporary_folder.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"

namespace firmware {
namespace {

class Sampled {
 public:
  Sampled(double period_s, Now at)
      : now(at),
        period_us_(static_cast<std::int64_t>(period_s * 1e6)),
        configuration_(config::parse_gateway(
            "[bus.a]\nbackend = \"slcan\"\nport = 0\n[[loop]]\nid = 1\ntag = \"A\"\n"
            "sample_period_s = " +
                std::to_string(period_s) +
                "\nstale_after_s = 60.0\nu = { source = \"can\", frame_id = 0x204, start "
                "= 0, length = 16, scale = 0.01 }\ny = { source = \"can\", frame_id = "
                "0x205, start = 0, length = 16, scale = 0.01 }\n",
            "g.toml")),
        daemon_(configuration_, random_, "1") {}

  // As many samples, with everything that falls due.
  void run(int samples) {
    for (int k = 0; k < samples; ++k) {
      plant_.next();
      pass(period_us_);
      const std::vector<BusFrame> frames = {{0, now.us, percent_frame(0x204, plant_.u)},
                                            {0, now.us, percent_frame(0x205, plant_.y)}};
      (void)daemon_.step(now, {frames, {}, buses_});
      while (daemon_.work(1000)) {
      }
    }
  }
  void pass(std::int64_t us) {
    now.us += us;
    now.epoch_us += us;
  }
  [[nodiscard]] std::vector<std::uint8_t> save() const {
    std::vector<std::uint8_t> image(wire::kMostStateBytes);
    image.resize(daemon_.save(image));
    return image;
  }
  [[nodiscard]] std::vector<std::uint8_t> save_windows() {
    std::vector<std::uint8_t> image(wire::windows_bytes(1, Monitor::kCapacity));
    const std::size_t size = daemon_.save_windows(now, 0, image);
    image.resize(size + 4);
    wire::put_big_endian(wire::crc32(std::span(image).first(size)),
                         std::span(image).subspan(size));
    return image;
  }
  // Another one with what this one kept, after so long; the plant goes on.
  [[nodiscard]] std::unique_ptr<Sampled> restarted(std::int64_t after_us) {
    auto next = std::make_unique<Sampled>(static_cast<double>(period_us_) * 1e-6, now);
    next->pass(after_us);
    next->plant_ = plant_;
    EXPECT_EQ(next->daemon_.restore(save(), next->now), wire::StateError::kNone);
    EXPECT_EQ(next->daemon_.restore_windows(save_windows(), next->now, false).loops, 1);
    return next;
  }
  [[nodiscard]] const Monitor& monitor() const { return daemon_.loop(0).monitor(); }
  [[nodiscard]] const wire::LoopStatus& status() const { return daemon_.loops()[0]; }
  [[nodiscard]] wire::LoopMemory memory() const { return daemon_.loop(0).memory(); }

  Now now;

 private:
  std::int64_t period_us_;
  Plant plant_{true};
  FixedRandom random_;
  config::Gateway configuration_;
  Daemon daemon_;
  std::vector<BusState> buses_ = {{.up = true}};
};

class FastRestart : public testing::TestWithParam<int> {
 protected:
  std::int64_t period_us = GetParam() * std::int64_t{1000};
  // Not on a whole millisecond.
  Sampled before{GetParam() * 1e-3, {1'000'377, 1'700'000'000'000'777}};
};

TEST_P(FastRestart, TheWindowGoesOnOverThreePeriodsOnAnyGrid) {
  before.run(2500);
  ASSERT_EQ(before.monitor().window().size(), Monitor::kCapacity);
  for (const int periods : {0, 1, 2}) {
    const auto after = before.restarted(periods * period_us);
    after->run(10);
    EXPECT_EQ(after->monitor().window().size(), Monitor::kCapacity) << periods;
    EXPECT_EQ(after->monitor().report().samples.restarts, 0U) << periods;
    EXPECT_EQ(after->monitor().report().samples.repeats, 0U) << periods;
  }
}

TEST_P(FastRestart, AStartOfASecondKeepsFlagAndVerdictAndAsksForNewCycles) {
  before.run(4500);
  ASSERT_TRUE(before.status().flag);
  const auto after = before.restarted(1'050'000);
  EXPECT_TRUE(after->status().flag);
  EXPECT_EQ(after->monitor().window().size(), Monitor::kCapacity) << "to be pulled";
  after->run(20);
  EXPECT_LE(after->monitor().window().size(), 20U) << "a gap is a gap";
  EXPECT_TRUE(after->status().flag);
  int samples = 20;
  while (after->monitor().report().counters.evaluations == 0 && samples < 3000) {
    after->run(1);
    ++samples;
    EXPECT_TRUE(after->status().flag) << samples;
  }
  std::printf("period %d ms: judged anew after %d samples, %.1f s\n", GetParam(), samples,
              samples * GetParam() * 1e-3);
  EXPECT_LE(samples, static_cast<int>(Monitor::kCapacity));
  after->run(2100);
  EXPECT_TRUE(after->status().flag);
}

INSTANTIATE_TEST_SUITE_P(Periods, FastRestart, testing::Values(10, 20, 50),
                         [](const auto& about) {
                           return std::to_string(about.param) + "ms";
                         });

using Bytes = std::vector<std::uint8_t>;

void write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

// 31 loops as one that has raised its flag, each with a full window and five years of
// history, in files as a daemon that is killed now leaves them.
class Everything : public testing::Test {
 protected:
  void SetUp() override {
    std::string text =
        "[bus.a]\nbackend = \"slcan\"\nport = " + std::to_string(free_port()) +
        "\n[uds]\n[broadcast]\n[metrics]\npath = \"a.prom\"\n[state]\n"
        "path = \"state\"\n[history]\npath = \"history\"\n";
    for (int id = 1; id <= kLoops; ++id) {
      const std::string signal =
          " = { source = \"can\", start = 0, length = 16, scale = 0.01, frame_id = ";
      text += "[[loop]]\nid = " + std::to_string(id) + "\ntag = \"L" +
              std::to_string(id) + "\"\nu" + signal + std::to_string(0x200 + 2 * id) +
              " }\ny" + signal + std::to_string(0x201 + 2 * id) + " }\n";
    }
    std::ofstream(files.file("g.toml")) << text << std::flush;
    const config::Gateway configuration = config::read_gateway(files.file("g.toml"));
    FixedRandom random;
    const Daemon target(configuration, random, "1");
    for (int k = 0; k < kLoops; ++k) {
      const MonitoredLoop& loop = target.loop(static_cast<std::size_t>(k));
      loops.push_back(
          {loop.configuration().id, loop.configuration().tag, loop.configuration_crc()});
    }
    source.run(2100);
    ASSERT_TRUE(source.status().flag);
    write_state();
    write_windows();
    write_history();
  }
  // The window of the source ended now.
  [[nodiscard]] std::int64_t shift_ms() const {
    return (hal::SystemClock().realtime_us() - source.now.epoch_us) / 1000;
  }
  void write_state() const {
    std::vector<wire::LoopStatus> status(loops.size(), source.status());
    std::vector<wire::LoopMemory> memories(loops.size(), source.memory());
    std::vector<wire::LoopParameters> parameters;
    for (std::size_t k = 0; k < loops.size(); ++k) {
      status[k].id = static_cast<std::uint8_t>(loops[k].id);
      status[k].tag.assign(loops[k].tag);
      memories[k].configuration = loops[k].configuration;
      memories[k].ended_ms += shift_ms();
      memories[k].evidence_ms += shift_ms();
      parameters.push_back(status[k].parameters);
    }
    Bytes image(wire::kMostStateBytes);
    image.resize(
        wire::write_state(status, parameters, memories, wire::DtcStore(), image));
    write_file(files.file("state"), image);
  }
  void write_windows() {
    const Bytes one = source.save_windows();
    wire::WindowReader reader(one);
    ASSERT_EQ(reader.check(), wire::StateError::kNone);
    ASSERT_TRUE(reader.next());
    wire::WindowMark mark = reader.mark();
    wire::RecordingHeader header = reader.header();
    mark.judged_ms += shift_ms();
    header.first_ms += static_cast<std::uint64_t>(shift_ms());
    Bytes image(wire::kWindowsHeaderBytes);
    const hal::SystemClock clock;
    wire::encode_windows_header(loops.size(), clock.realtime_us() - clock.monotonic_us(),
                                std::span(image).first<wire::kWindowsHeaderBytes>());
    constexpr std::size_t kHeads = wire::kWindowMarkBytes + wire::kRecordingHeaderBytes;
    for (const HistoryLoop& loop : loops) {
      std::array<std::uint8_t, kHeads> heads{};
      mark.tag.assign(loop.tag);
      mark.configuration = loop.configuration;
      header.loop = static_cast<std::uint8_t>(loop.id);
      wire::encode_window_mark(mark, std::span(heads).first<wire::kWindowMarkBytes>());
      wire::encode_recording_header(header,
                                    std::span(heads).last<wire::kRecordingHeaderBytes>());
      image.insert(image.end(), heads.begin(), heads.end());
      image.insert(image.end(), one.begin() + wire::kWindowsHeaderBytes + kHeads,
                   one.end() - 4);
    }
    const std::uint32_t checksum = wire::crc32(image);
    image.resize(image.size() + 4);
    wire::put_big_endian(checksum, std::span(image).last(4));
    write_file(files.file("state.windows"), image);
  }
  void write_history() const {
    const std::string path = files.file("history");
    {
      HistoryFile file(path);
      ASSERT_EQ(file.open(loops), HistoryFile::Opened::kNew);
      wire::HistoryRow row = wire::history_row(source.status());
      const auto now_s =
          static_cast<std::uint32_t>(hal::SystemClock().realtime_us() / 1'000'000);
      // Rows far apart, then closer: every ring is full in the end.
      for (std::size_t ring = kHistoryRings.size(); ring-- > 0;) {
        const std::uint32_t apart_s = std::max(kHistoryRings[ring].apart_s, 600U);
        const auto rows = static_cast<std::uint32_t>(kHistoryRings[ring].rows);
        for (std::uint32_t k = rows; k > 0; --k) {
          row.time_s = now_s - k * apart_s;
          file.add(1, row);
          if (k % 100 == 0) file.finish();
        }
        file.finish();
      }
      ASSERT_EQ(file.failures(), 0U);
    }
    const std::string text = text_of(path);
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    for (std::size_t k = 1; k < loops.size(); ++k) {
      file.seekp(static_cast<std::streamoff>(kHistoryHeader + k * kHistoryLoopBytes));
      file.write(text.data() + kHistoryHeader, kHistoryLoopBytes);
    }
  }
  // Lines of the textfile with that metric and value.
  [[nodiscard]] int shown(const std::string& metric, const std::string& value) const {
    std::istringstream text(text_of(files.file("a.prom")));
    int count = 0;
    for (std::string line; std::getline(text, line);) {
      count += line.starts_with("stickband_loop_" + metric + '{') &&
               line.ends_with(' ' + value);
    }
    return count;
  }

  static constexpr int kLoops = 31;
  TemporaryFolder files;
  std::vector<HistoryLoop> loops;
  Sampled source{1.0, {1'000'000, 1'700'000'000'000'000}};
};

TEST_F(Everything, FlagsAreBackWithinTwoSecondsMarkedWithTheirAge) {
  double slowest_s = 0;
  for (int k = 0; k < 3; ++k) {
    std::filesystem::remove(files.file("a.prom"));
    const auto start = std::chrono::steady_clock::now();
    const auto took_s = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
          .count();
    };
    Process daemon({STICKBAND_DAEMON, "--config", files.file("g.toml")});
    // It is written in the turn in which the lines are driven, after them.
    while (shown("flag", "1") < kLoops && took_s() < 10) usleep(1'000);
    slowest_s = std::max(slowest_s, took_s());
    std::printf("31 flags after %.3f s\n", took_s());
    EXPECT_EQ(shown("flag", "1"), kLoops) << daemon.err();
    EXPECT_EQ(shown("age_s", "NaN"), 0) << "the age is known";
    EXPECT_TRUE(daemon.says("windows of samples that are back: 31")) << daemon.err();
    EXPECT_TRUE(daemon.says("started"));
    daemon.signal(SIGKILL);
    (void)daemon.wait();
  }
  EXPECT_LT(slowest_s, 1.0) << "the service manager waits for a second before";
}

}  // namespace
}  // namespace firmware
