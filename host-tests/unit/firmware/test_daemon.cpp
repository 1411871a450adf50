#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <new>
#include <string>

#include "firmware/daemon.hpp"
#include "firmware/notice_text.hpp"
#include "firmware/sticking_plant.hpp"
#include "support/base/fixed_random.hpp"
#include "support/ident/microseconds.hpp"
#include "support/ident/pi_loop.hpp"

namespace {
std::size_t allocations = 0;
}

#ifdef STICKBAND_COUNTER  // without a sanitizer, which has an allocator of its own
// Counted, so that a test can tell that there were none.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
#endif

namespace firmware {
namespace {

using test::kSecond;

const std::string kText =
    "[bus.a]\nbackend = \"socketcan\"\ninterface = \"can0\"\n"
    "[bus.b]\nbackend = \"socketcan\"\ninterface = \"can1\"\n"
    "[uds]\nbus = \"a\"\n[broadcast]\nbus = \"b\"\nperiod_s = 1.0\n";

std::string loop_text(int id, const std::string& more = "") {
  const auto signal = [id](const char* name, int offset) {
    return std::string(name) + " = { source = \"can\", bus = \"a\", frame_id = " +
           std::to_string(0x200 + 4 * id + offset) +
           ", start = 0, length = 16, scale = 0.01 }\n";
  };
  return "[[loop]]\nid = " + std::to_string(id) + "\ntag = \"LOOP" + std::to_string(id) +
         "\"\nsample_period_s = 0.1\n" + signal("u", 0) + signal("y", 1) + more;
}

class Gateway : public testing::Test {
 protected:
  void start(const std::string& text) {
    configuration = config::parse_gateway(text, "g.toml");
    daemon.emplace(configuration, random, "1.2.3");
  }
  // One step with these frames; what came out is added to `sent` and `notices`.
  void step(std::vector<BusFrame> frames = {}, std::int64_t forward_us = 20'000) {
    now.us += forward_us;
    now.epoch_us = now.us + 1'700'000'000 * kSecond;
    for (BusFrame& frame : frames) frame.t_us = now.us;
    const Outputs& out = daemon->step(now, {frames, {}, buses});
    for (const OutFrame& frame : out.frames) sent.push_back(frame);
    for (const Notice& notice : out.notices) notices.push_back(notice);
    flags.assign(out.flags.begin(), out.flags.end());
    next_us = out.next_us;
  }
  // Values of loop 1 for that long, at 10 Hz.
  void feed(double seconds, double u = 50, double y = 50) {
    for (int k = 0; k < seconds * 10; ++k) {
      step({{0, 0, percent_frame(0x204, u)}, {0, 0, percent_frame(0x205, y)}}, 100'000);
    }
  }
  std::vector<std::uint8_t> ask(std::vector<std::uint8_t> request) {
    wire::CanFrame frame{.id = 0x7E0, .dlc = 8, .data = {}};
    frame.data[0] = static_cast<std::uint8_t>(request.size());
    std::copy(request.begin(), request.end(), frame.data.begin() + 1);
    const std::size_t before = sent.size();
    step({{0, 0, frame}});
    for (std::size_t k = before; k < sent.size(); ++k) {
      const wire::CanFrame& answer = sent[k].frame;
      if (answer.id == 0x7E8 && sent[k].bus == 0) {
        return {answer.data.begin() + 1, answer.data.begin() + 1 + answer.data[0]};
      }
    }
    return {};
  }
  [[nodiscard]] int count(NoticeKind kind) const {
    int n = 0;
    for (const Notice& notice : notices) n += notice.kind == kind;
    return n;
  }
  [[nodiscard]] const wire::LoopStatus& status() const { return daemon->loops()[0]; }

  FixedRandom random;
  config::Gateway configuration;
  std::optional<Daemon> daemon;
  std::vector<BusState> buses = {{.up = true}, {.up = true}};
  std::vector<OutFrame> sent;
  std::vector<Notice> notices;
  std::vector<bool> flags;
  std::int64_t next_us = 0;
  Now now{kSecond, 0};
};

TEST_F(Gateway, ShowsTheLiveValuesAndTheStateOfTheInput) {
  start(kText + loop_text(1));
  feed(3, 40, 60);
  EXPECT_DOUBLE_EQ(status().u_pct, 40);
  EXPECT_DOUBLE_EQ(status().y_pct, 60);
  EXPECT_EQ(status().input, wire::InputStatus::kGood);
  EXPECT_EQ(status().verdict, wire::LoopVerdict::kNotEvaluated);
  EXPECT_GE(daemon->loop(0).monitor().window().size(), 20U);
}

TEST_F(Gateway, TellsOnceThatTheSpanIsNotThatOfU) {
  start(kText + loop_text(1, "span = [0.0, 40.0]\n"));
  feed(450, 50, 50);
  ASSERT_EQ(count(NoticeKind::kSpanDoubted), 1);
  const auto told = std::find_if(
      notices.begin(), notices.end(),
      [](const Notice& notice) { return notice.kind == NoticeKind::kSpanDoubted; });
  EXPECT_EQ(
      text_of(*told, configuration).view(),
      "LOOP1: u ran from 50 to 50, expected most of it in the span 0 to 40, and 2 % of "
      "that; correct `span`");
  EXPECT_EQ(priority_of(*told), Priority::kWarning);
  EXPECT_EQ(name_of(*told), "span_doubted");
}

TEST_F(Gateway, DecidesNothingWhereUAndYAreExchanged) {
  const test::LoopRecord record = test::run({}, 700, 1);
  for (const bool exchanged : {false, true}) {
    notices.clear();
    start(kText + loop_text(1));
    for (std::size_t t = 0; t < record.u.size(); ++t) {
      const double u = 50 + 10 * record.u[t];
      const double y = 50 + 10 * record.y[t];
      step({{0, 0, percent_frame(0x204, exchanged ? y : u)},
            {0, 0, percent_frame(0x205, exchanged ? u : y)}},
           100'000);
    }
    daemon->evaluate_all();
    step();
    step();
    EXPECT_EQ(count(NoticeKind::kSignalsSwapped), exchanged ? 1 : 0);
    if (exchanged) {
      EXPECT_EQ(status().verdict, wire::LoopVerdict::kUndecided);
      EXPECT_TRUE(std::isnan(status().confidence_pct));
      EXPECT_FALSE(status().flag);
    }
  }
}

TEST_F(Gateway, TellsThatAModeSuspendsTheEvaluationAndThatItGoesOn) {
  start(kText +
        loop_text(1,
                  "mode = { source = \"can\", bus = \"a\", frame_id = 0x300, start = 0, "
                  "length = 8 }\nauto_values = [1, 4, 8]\n"));
  const auto mode = [](double value) {
    return BusFrame{0, 0, percent_frame(0x300, value / 100)};
  };
  feed(1);
  EXPECT_EQ(count(NoticeKind::kSuspended), 0) << "a mode that is not known";
  step({mode(4)});
  EXPECT_EQ(count(NoticeKind::kSuspended) + count(NoticeKind::kResumed), 0);
  step({mode(2)});
  ASSERT_EQ(count(NoticeKind::kSuspended), 1);
  EXPECT_EQ(text_of(notices.back(), configuration).view(),
            "LOOP1: suspended: mode reads 2, automatic is 1, 4 or 8");
  EXPECT_EQ(name_of(notices.back()), "suspended");
  step({mode(3)});
  EXPECT_EQ(count(NoticeKind::kSuspended), 1) << "told once";
  step({mode(8)});
  ASSERT_EQ(count(NoticeKind::kResumed), 1);
  EXPECT_EQ(text_of(notices.back(), configuration).view(),
            "LOOP1: resumed: mode reads 8, automatic is 1, 4 or 8");
  EXPECT_EQ(priority_of(notices.back()), Priority::kNotice);
}

TEST_F(Gateway, NamesASignalThatIsFarOutsideItsSpan) {
  start(kText + loop_text(1, "span = [0.0, 10.0]\n"));
  feed(3, 53.53, 50);
  ASSERT_EQ(count(NoticeKind::kInputFault), 1);
  EXPECT_EQ(
      text_of(notices.back(), configuration).view(),
      "LOOP1: input fault: out_of_range: u reads 53.53, a span or more outside 0 to "
      "10; correct scale, offset or `span`, or refuse it by `minimum` and `maximum`");
  EXPECT_EQ(status().input, wire::InputStatus::kOutOfRange);
  EXPECT_TRUE(std::isnan(status().u_pct)) << "535 % cannot be shown";
  feed(3, 5, 50);
  EXPECT_EQ(count(NoticeKind::kInputRestored), 1);
  EXPECT_DOUBLE_EQ(status().u_pct, 50);
}

TEST_F(Gateway, ReceivesOnlyWhatItNeeds) {
  start(kText + loop_text(1) + loop_text(2));
  const auto filters = daemon->filters(0);
  EXPECT_EQ(filters.size(), 4U + 2U)
      << "four signals, the tester, the functional address";
  EXPECT_TRUE(daemon->filters(1).empty());
}

TEST_F(Gateway, AParameterGroupComesFromAnySourceWithAnyPriority) {
  start(
      kText +
      "[[loop]]\nid = 1\ntag = \"A\"\nsample_period_s = 0.1\n"
      "u = { source = \"j1939\", bus = \"a\", pgn = 0xFEF2, start = 0, length = 16, "
      "scale = 0.01 }\n"
      "y = { source = \"j1939\", bus = \"a\", pgn = 0xEF00, source_address = 3, start = "
      "0, length = 16, scale = 0.01 }\n");
  const auto group = [](std::uint32_t id, double percent) {
    wire::CanFrame frame = percent_frame(id, percent);
    frame.extended = true;
    return frame;
  };
  step({{0, 0, group(0x18FEF221, 40)}, {0, 0, group(0x0CEF9903, 60)}}, 100'000);
  step({{0, 0, group(0x18EF9904, 70)}, {0, 0, percent_frame(0x6F2, 70)}}, 100'000);
  EXPECT_DOUBLE_EQ(status().u_pct, 40);
  EXPECT_DOUBLE_EQ(status().y_pct, 60) << "another source address is not it";
  step({{0, 0, group(0x04FEF221, 45)}}, 100'000);
  EXPECT_DOUBLE_EQ(status().u_pct, 45);
  step({{0, 0, group(0x04FEF2FE, 50)}}, 100'000);
  step({{0, 0, group(0x18FEF221, 47)}}, 100'000);
  EXPECT_DOUBLE_EQ(status().u_pct, 47) << "a second sender of the same";
  EXPECT_EQ(count(NoticeKind::kTwoSenders), 1);
  EXPECT_EQ(status().counters.frames, 5U);
  const auto filters = daemon->filters(0);
  EXPECT_EQ(filters.size(), 2U + 2U);
  EXPECT_TRUE(std::any_of(filters.begin(), filters.end(), [](const hal::CanFilter& f) {
    return f.id == 0x00FEF200 && f.mask == 0x03FFFF00 && f.extended;
  }));
}

TEST_F(Gateway, SilentInputsAreAFaultThatIsToldOnceAndEnds) {
  start(kText + loop_text(1, "stale_after_s = 1.0\n"));
  feed(3);
  for (int k = 0; k < 100; ++k) step();
  EXPECT_EQ(count(NoticeKind::kInputFault), 1);
  EXPECT_EQ(notices.back().input, wire::InputStatus::kMissing);
  EXPECT_EQ(topic_of(notices.back()), Topic::kInputs);
  EXPECT_EQ(status().verdict, wire::LoopVerdict::kInputInvalid);
  feed(3);
  EXPECT_EQ(count(NoticeKind::kInputRestored), 1);
  EXPECT_EQ(status().counters.stale, 1U);
}

TEST_F(Gateway, AnswersQueriesAndSendsStatusFramesOnTheirBuses) {
  start(kText + loop_text(1));
  feed(10);
  EXPECT_EQ(ask({0x3E, 0x00}), (std::vector<std::uint8_t>{0x7E, 0x00}));
  int frames = 0;
  for (const OutFrame& out : sent) {
    if (out.bus != 1) continue;
    EXPECT_EQ(out.frame.id, 0x191U);
    ++frames;
  }
  EXPECT_GE(frames, 9);
  EXPECT_LE(frames, 13) << "once a second and on change";
}

TEST_F(Gateway, SendsNothingToABusThatIsDownOrFull) {
  start(kText + loop_text(1));
  buses[1].up = false;
  buses[0].room = false;
  feed(5);
  EXPECT_TRUE(ask({0x3E, 0x00}).empty());
  EXPECT_TRUE(sent.empty());
  EXPECT_GT(next_us, now.us) << "what waits to be answered does not make it turn";
  buses[0].room = buses[1].up = true;
  step();
  EXPECT_FALSE(sent.empty());
}

TEST_F(Gateway, BusesThatComeAndGoAreTold) {
  start(kText + loop_text(1));
  step();
  EXPECT_EQ(count(NoticeKind::kBusUp), 2);
  buses[0].up = false;
  step();
  step();
  EXPECT_EQ(count(NoticeKind::kBusDown), 1);
  buses[0].up = true;
  step();
  EXPECT_EQ(count(NoticeKind::kBusUp), 3);
  const wire::CanFrame off{.id = 0x40, .error = true, .dlc = 8, .data = {}};
  step({{0, 0, off}, {0, 0, off}});
  EXPECT_EQ(count(NoticeKind::kBusOff), 1);
}

TEST_F(Gateway, DropsAreCountedForTheLoopsOfTheBus) {
  start(kText + loop_text(1));
  feed(3);
  buses[0].drops = 7;
  step();
  EXPECT_EQ(status().counters.dropped, 7U);
  EXPECT_EQ(status().input, wire::InputStatus::kUncertain);
}

TEST_F(Gateway, TheFlagGoesToItsFailSafeLevelWhileNothingIsKnown) {
  const std::string flag = "flag = { chip = \"c\", line = 1, fail_safe = true }\n";
  start(kText + loop_text(1, flag) + loop_text(2, "flag = { chip = \"c\", line = 2 }\n"));
  feed(1);
  EXPECT_TRUE(flags[0]);
  EXPECT_FALSE(flags[1]);
}

TEST_F(Gateway, RandomFramesDoNotStopIt) {
  start(kText + loop_text(1));
  std::uint64_t state = 1;
  const auto random_bits = [&state] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state >> 33);
  };
  for (int k = 0; k < 20'000; ++k) {
    std::vector<BusFrame> frames;
    for (int i = 0; i < 8; ++i) {
      // Every other frame is for us, with any shape and content.
      constexpr std::array<std::uint32_t, 4> kOurs = {0x204, 0x205, 0x7E0, 0x7DF};
      wire::CanFrame frame;
      const std::uint32_t bits = random_bits();
      frame.id = bits & 1 ? kOurs[(bits >> 1) % 4] : bits >> 21;
      frame.remote = (bits & 0x30) == 0;
      frame.error = (bits & 0x1C0) == 0;
      frame.dlc = static_cast<std::uint8_t>((bits >> 9) % 9);
      for (std::size_t n = 0; n < frame.dlc; ++n) {
        frame.data[n] = static_cast<std::uint8_t>(random_bits());
      }
      frames.push_back({bits >> 8 & 1, 0, frame});
    }
    step(frames, 5'000);
    sent.clear();
    notices.clear();
    (void)daemon->work(8);
  }
  for (int k = 0; k < 200; ++k) step();
  feed(10, 30, 70);
  EXPECT_DOUBLE_EQ(status().u_pct, 30);
  EXPECT_EQ(status().input, wire::InputStatus::kGood);
  EXPECT_EQ(ask({0x3E, 0x00}), (std::vector<std::uint8_t>{0x7E, 0x00}));
}

TEST_F(Gateway, ALoopThatGoesOnAsItDidIsJudgedOncePerWindow) {
  start(kText + loop_text(1));
  double amplitude = 20;
  int k = 0;
  const auto evaluations = [&] {
    return daemon->loop(0).monitor().report().counters.evaluations;
  };
  const auto sway = [&](int samples) {
    const std::uint32_t before = evaluations();
    for (const int end = k + samples; k < end; ++k) {
      const double u = 50 + amplitude * std::sin(0.1 * k);
      // Without any noise rounding alone would decide what such a record can show.
      const double noise = std::fmod(k * 7919.0, 101) / 50 - 1;
      const double y = 50 + amplitude * std::sin(0.1 * k - 1) + 0.5 * noise;
      step({{0, 0, percent_frame(0x204, u)}, {0, 0, percent_frame(0x205, y)}}, 100'000);
      while (daemon->work(1000)) {
      }
    }
    return evaluations() - before;
  };
  sway(6000);
  ASSERT_NE(status().window_verdict, wire::LoopVerdict::kNotEvaluated);
  EXPECT_EQ(sway(8192), 4U);
  amplitude = 30;
  EXPECT_GE(sway(1024), 1U) << "what changes is judged at once";
  sway(6000);
  const std::uint32_t before = evaluations();
  sway(600);
  EXPECT_EQ(ask({0x31, 0x01, 0xF0, 0x01, 0x01}),
            (std::vector<std::uint8_t>{0x71, 0x01, 0xF0, 0x01}));
  while (daemon->work(1000)) {
  }
  EXPECT_GE(evaluations(), before + 1) << "what is asked for is judged at once";
}

TEST_F(Gateway, AllocatesNothingAfterItsStart) {
#ifndef STICKBAND_COUNTER
  GTEST_SKIP() << "a sanitizer has an allocator of its own";
#endif
  std::string text = kText;
  for (int id = 1; id <= 31; ++id) text += loop_text(id);
  start(text);
  std::vector<BusFrame> frames(6);  // of three loops
  const auto run = [&](int from, int to) {
    for (int k = from; k < to; ++k) {
      now.us += 100'000;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto loop = static_cast<std::uint32_t>(i / 2 + 1);
        const double phase = 0.05 * k + static_cast<double>(i);
        frames[i] = {0, now.us,
                     percent_frame(0x200 + 4 * loop + i % 2, 50 + 20 * std::sin(phase))};
      }
      wire::CanFrame request{.id = 0x7E0, .dlc = 8, .data = {3, 0x22, 0xFD, 0x13}};
      if (k % 10 == 0) frames[0].frame = request;
      (void)daemon->step(now, {frames, {}, buses});
      while (daemon->work(1000)) {
      }
    }
  };
  run(0, 10);
  const std::size_t before = allocations;
  run(10, 1100);
  EXPECT_EQ(allocations, before);
  EXPECT_NE(daemon->loops()[1].window_verdict, wire::LoopVerdict::kNotEvaluated);
}

}  // namespace
}  // namespace firmware
