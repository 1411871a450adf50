// An input that comes and goes does not make the flag come and go.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "firmware/daemon.hpp"
#include "firmware/notice_text.hpp"
#include "firmware/sticking_plant.hpp"
#include "support/base/fixed_random.hpp"
#include "support/ident/microseconds.hpp"

namespace firmware {
namespace {

using test::kSecond;
constexpr const char* kText =
    "[bus.a]\nbackend = \"slcan\"\nport = 0\n[[loop]]\nid = 1\ntag = \"A\"\n"
    "u = { source = \"can\", frame_id = 1, start = 0, length = 16, scale = 0.01 }\n"
    "y = { source = \"can\", frame_id = 2, start = 0, length = 16, scale = 0.01 }\n";

class Outage : public testing::Test {
 protected:
  // That many seconds of a sticking loop, with or without its frames.
  void run(int seconds, bool heard = true) {
    for (int k = 0; k < seconds; ++k) {
      plant_.next();
      now_.us += kSecond;
      now_.epoch_us += kSecond;
      std::vector<BusFrame> frames;
      if (heard) {
        frames = {{0, now_.us, percent_frame(1, plant_.u)},
                  {0, now_.us, percent_frame(2, plant_.y)}};
      }
      const Outputs& out = daemon_.step(now_, {frames, {}, buses_});
      for (const Notice& notice : out.notices) {
        lines.emplace_back(text_of(notice, configuration_).view());
      }
      while (daemon_.work(1000)) {
      }
    }
  }
  [[nodiscard]] long told(const std::string& text) const {
    return std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.find(text) != std::string::npos;
    });
  }
  [[nodiscard]] const wire::LoopStatus& status() const { return daemon_.loops()[0]; }

  std::vector<std::string> lines;

 private:
  Plant plant_{true};
  FixedRandom random_;
  config::Gateway configuration_ = config::parse_gateway(kText, "g.toml");
  Daemon daemon_{configuration_, random_, "1"};
  std::vector<BusState> buses_ = {{.up = true}};
  Now now_{kSecond, 1'700'000'000 * kSecond};
};

TEST_F(Outage, TheFlagReturnsOnceTheInputHasBeenGoodForANewShareOfTheWindow) {
  run(2100);
  ASSERT_TRUE(status().flag);
  ASSERT_EQ(told("FLAG RAISED"), 1);
  for (int k = 0; k < 30; ++k) {
    run(6, false);
    run(4);
  }
  EXPECT_GT(told("input fault"), 20);
  EXPECT_EQ(told("flag lowered"), 1);
  EXPECT_EQ(told("FLAG RAISED"), 1) << "not while the input comes and goes";
  run(500);
  EXPECT_EQ(status().input, wire::InputStatus::kGood);
  run(30);
  EXPECT_TRUE(status().flag);
  EXPECT_EQ(told("FLAG RAISED"), 2);
}

TEST_F(Outage, AFlagThatRestsOnAWindowOfBeforeSaysSo) {
  run(2100);
  ASSERT_TRUE(status().flag);
  run(24 * 3600, false);
  EXPECT_FALSE(status().flag);
  run(400);
  EXPECT_FALSE(status().flag);
  run(2100);
  EXPECT_TRUE(status().flag);
  EXPECT_EQ(told("FLAG RAISED"), 2);
  EXPECT_EQ(told("FLAG RAISED as before, by a window that ended 24."), 1);
}

}  // namespace
}  // namespace firmware
