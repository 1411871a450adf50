#include <gtest/gtest.h>

#include "support/uds/bus.hpp"
#include "workbench/pull/pulled_recording.hpp"
#include "workbench/recording/csv.hpp"

namespace workbench {
namespace {

using support::UdsBus;

constexpr auto kQuiet = [](std::size_t, std::size_t) {};

TEST(PulledRecording, IsTheWindowOfTheGateway) {
  for (const std::uint16_t block : {std::uint16_t{7}, std::uint16_t{1024}}) {
    wire::UdsSettings settings;
    settings.block_bytes = block;
    UdsBus bus({}, settings);
    UdsClient client(bus, {});
    std::size_t told = 0;
    const PulledRecording recording =
        pull_recording(client, 1, [&](std::size_t at, std::size_t all) {
          EXPECT_LE(at, all);
          told = all;
        });
    EXPECT_EQ(recording.tag, "FIC-211");
    EXPECT_EQ(recording.header.loop, 1);
    ASSERT_EQ(recording.samples.size(), support::UdsDaemon::kSamples);
    EXPECT_EQ(recording.samples[8].u, 2);
    EXPECT_EQ(recording.samples[8].y, -2);
    EXPECT_EQ(recording.samples[8].sp, 50);
    EXPECT_EQ(told, wire::recording_bytes(support::UdsDaemon::kSamples));
    EXPECT_FALSE(bus.daemon.recording_open);
  }
}

TEST(PulledRecording, AHistoryComesByTime) {
  UdsBus bus;
  bus.daemon.history.resize(wire::kHistoryHeaderBytes + 3 * wire::kHistoryRowBytes);
  const auto image = std::span(bus.daemon.history);
  wire::encode_history_header(1, 3, image.first<wire::kHistoryHeaderBytes>());
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
    wire::HistoryRow row;
    row.verdict = wire::LoopVerdict::kBacklash;
    row.time_s = 5000 - static_cast<std::uint32_t>(k);
    wire::encode_history_row(
        row, image.subspan(wire::kHistoryHeaderBytes + k * wire::kHistoryRowBytes)
                 .first<wire::kHistoryRowBytes>());
  }
  UdsClient client(bus, {});
  const PulledHistory history = pull_history(client, 1, kQuiet);
  EXPECT_EQ(history.tag, "FIC-211");
  ASSERT_EQ(history.rows.size(), 2U) << "the empty one is left out";
  EXPECT_EQ(history.rows[0].time_s, 4998U);
  const std::string csv = csv_of(history);
  EXPECT_TRUE(csv.starts_with("time,verdict,"));
  EXPECT_NE(csv.find("1970-01-01T01:23:20Z,backlash,0,"), std::string::npos) << csv;
}

TEST(PulledRecording, SurvivesLostFrames) {
  UdsBus bus;
  int frames = 0;
  bus.change = [&](wire::CanFrame&) { return ++frames % 200 != 150; };
  UdsClient client(bus, {});
  EXPECT_EQ(pull_recording(client, 1, kQuiet).samples.size(),
            support::UdsDaemon::kSamples);
}

TEST(PulledRecording, RefusesDamage) {
  UdsBus bus;
  bus.change = [&](wire::CanFrame& frame) {
    if (frame.data[0] == 0x25 && frame.data[1] != 0x7F) frame.data[4] ^= 1;
    return true;
  };
  UdsClient client(bus, {});
  try {
    (void)pull_recording(client, 31, kQuiet);
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("CRC"), std::string::npos) << error.what();
  }
}

TEST(PulledRecording, SaysWhatTheGatewayRefuses) {
  UdsBus bus;
  UdsClient client(bus, {});
  EXPECT_THROW((void)pull_recording(client, 2, kQuiet), DeviceError) << "no such loop";
  bus.daemon.willing = false;
  try {
    (void)pull_recording(client, 1, kQuiet);
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("nothing recorded yet"), std::string::npos);
  }
}

TEST(PulledRecording, CsvIsARecording) {
  PulledRecording recording;
  recording.header = {1, true, 5, 500'000, 0};
  recording.samples = {
      {50.1F, 20, 50}, {51, 22.25F, NAN}, {NAN, 21, 50}, {52, 23, 50}, {53, 24, 50}};
  const std::string text = csv_of(recording);
  EXPECT_EQ(text, "t,u,y,sp\n0,50.1,20,50\n0.5,51,22.25,\n1.5,52,23,50\n2,53,24,50\n");
  recording.header.has_setpoint = false;
  EXPECT_EQ(csv_of(recording), "t,u,y\n0,50.1,20\n0.5,51,22.25\n1.5,52,23\n2,53,24\n");
  const Recording read = parse_csv(csv_of(recording), "pulled.csv", {});
  EXPECT_EQ(read.period_s, 0.5);
}

}  // namespace
}  // namespace workbench
