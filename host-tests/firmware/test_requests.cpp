// What a stranger may ask changes nothing that the alarm rests on.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "firmware/daemon.hpp"
#include "firmware/notice_text.hpp"
#include "firmware/replay.hpp"
#include "firmware/sticking_plant.hpp"
#include "support/base/fixed_random.hpp"
#include "support/base/temporary_folder.hpp"
#include "support/ident/microseconds.hpp"
#include "wire/sha256.hpp"

namespace firmware {
namespace {

using test::kSecond;

const std::string kSampleText =
    "[bus.a]\nbackend = \"socketcan\"\ninterface = \"can0\"\n[uds]\n"
    "[[loop]]\nid = 1\ntag = \"A\"\nsample_period_s = 1.0\n"
    "u = { source = \"can\", frame_id = 0x204, start = 0, length = 16, scale = 0.01 }\n"
    "y = { source = \"can\", frame_id = 0x205, start = 0, length = 16, scale = 0.01 }\n";

// A gateway with one loop; each evaluation takes `cost_us` of a core.
class Asked {
 public:
  explicit Asked(bool sticks = true, std::int64_t cost_us = 400'000)
      : plant_(sticks),
        cost_us_(cost_us),
        configuration_(config::parse_gateway(kSampleText, "g.toml")),
        daemon_(std::make_unique<Daemon>(configuration_, random_, "1")) {}

  // One second; with a request for an evaluation or without.
  void run(bool asks) {
    plant_.next();
    now_.us += kSecond;
    now_.epoch_us = now_.us;
    std::vector<BusFrame> frames = {{0, now_.us, percent_frame(0x204, plant_.u)},
                                    {0, now_.us, percent_frame(0x205, plant_.y)}};
    if (asks) {
      frames.push_back(
          {0, now_.us, {.id = 0x7E0, .dlc = 8, .data = {5, 0x31, 0x01, 0xF0, 0x01, 1}}});
    }
    const Outputs& out = daemon_->step(now_, {frames, {}, buses_});
    for (const Notice& notice : out.notices) {
      if (notice.kind == NoticeKind::kFlagRaised) raised_s = notice.t_us / kSecond;
    }
    const std::uint32_t before = evaluations();
    while (daemon_->work(1000)) {
      if (evaluations() == before) continue;
      daemon_->charge(cost_us_);
      break;
    }
  }
  [[nodiscard]] std::uint32_t evaluations() const {
    return daemon_->loop(0).monitor().report().counters.evaluations;
  }
  [[nodiscard]] const wire::LoopStatus& status() const { return daemon_->loops()[0]; }

  std::int64_t raised_s = 0;

 private:
  Plant plant_;
  std::int64_t cost_us_;
  FixedRandom random_;
  config::Gateway configuration_;
  std::unique_ptr<Daemon> daemon_;
  std::vector<BusState> buses_ = {{.up = true}};
  Now now_{kSecond, 0};
};

TEST(Requests, TheFlagIsRaisedAtTheSameTimeHoweverOftenSomebodyAsks) {
  std::int64_t without_s = 0;
  for (const int pace : {0, 1, 120, 400}) {
    Asked gateway;
    for (int k = 1; k < 3000 && gateway.raised_s == 0; ++k) {
      gateway.run(pace > 0 && k % pace == 0);
    }
    if (pace == 0) without_s = gateway.raised_s;
    RecordProperty("asked_every_" + std::to_string(pace),
                   std::to_string(gateway.raised_s));
    std::printf("asked every %d s: raised after %lld s, %u evaluations\n", pace,
                static_cast<long long>(gateway.raised_s), gateway.evaluations());
    ASSERT_GT(without_s, 0);
    EXPECT_NEAR(static_cast<double>(gateway.raised_s), static_cast<double>(without_s), 1)
        << "asked every " << pace << " s";
  }
}

TEST(Requests, DoNotConfirmADtcBeforeItsTime) {
  Asked gateway(false);
  while (gateway.status().window_verdict == wire::LoopVerdict::kNotEvaluated) {
    gateway.run(false);
  }
  ASSERT_FALSE(gateway.status().confirmed);
  for (int k = 0; k < 50; ++k) gateway.run(k % 10 == 0);
  EXPECT_FALSE(gateway.status().confirmed);
}

TEST(Requests, EachUseOfTheKeyIsCountedAndHasItsLine) {
  const TemporaryFolder own;
  std::ofstream(own.file("uds.key")) << std::string(64, 'a');
  std::filesystem::permissions(own.file("uds.key"), std::filesystem::perms(0600));
  std::string text = kSampleText;
  text.replace(text.find("[uds]\n"), 6, "[uds]\nwrites = true\nkey_file = \"uds.key\"\n");
  const config::Gateway gateway = config::parse_gateway(text, own.file("g.toml"));
  Replay tester(gateway);
  const auto ask = [&](std::vector<std::uint8_t> request) { return tester.ask(request); };
  EXPECT_EQ(ask({0x14, 0xFF, 0xFF, 0xFF}).at(2), 0x7F);
  (void)ask({0x10, 0x03});
  std::vector<std::uint8_t> wrong(18);
  wrong[0] = 0x27;
  wrong[1] = 0x02;
  (void)ask({0x27, 0x01});
  EXPECT_EQ(ask(wrong).at(2), 0x35);
  const std::vector<std::uint8_t> seed = ask({0x27, 0x01});
  const auto key = wire::hmac_sha256(gateway.uds->key, std::span(seed).subspan(2));
  std::copy_n(key.begin(), 16, wrong.begin() + 2);
  EXPECT_EQ(ask(wrong).at(0), 0x67);
  EXPECT_EQ(ask({0x14, 0xFF, 0xFF, 0xFF}).at(0), 0x54);
  EXPECT_EQ(ask({0x31, 0x01, 0xF0, 0x00, 1}).at(0), 0x71);
  EXPECT_EQ(ask({0x2E, 0xFD, 0x15, 0, 3, 0, 9, 0, 100, 4, 3, 0, 1}).at(0), 0x6E);
  const wire::AccessCounters& counters = tester.daemon().gateway().access;
  EXPECT_EQ(counters.unlocks, 1U);
  EXPECT_EQ(counters.refused_keys, 1U);
  EXPECT_EQ(counters.clears, 1U);
  EXPECT_EQ(counters.resets, 1U);
  EXPECT_EQ(counters.writes, 1U);
  EXPECT_EQ(counters.simulations, 0U);
  Notice notice;
  notice.kind = NoticeKind::kAccess;
  notice.tester = 0xF1;
  const auto line = [&](wire::UdsAct act, int loop) {
    notice.act = act;
    notice.loop = loop;
    return std::string(text_of(notice, gateway).c_str());
  };
  EXPECT_EQ(line(wire::UdsAct::kRefusedKey, 0), "tester F1 sent a wrong key");
  EXPECT_EQ(line(wire::UdsAct::kCleared, 0), "tester F1 cleared DTCs, all loops");
  EXPECT_EQ(line(wire::UdsAct::kWritten, 7), "tester F1 wrote parameters, loop 7");
}

}  // namespace
}  // namespace firmware
