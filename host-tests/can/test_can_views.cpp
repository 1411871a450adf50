#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "can_views.hpp"
#include "support/gateway/sample_status.hpp"
#include "wire/dbc.hpp"
#include "wire/diagnostics.hpp"

namespace {

struct Reader {
  Reader() : dbc(*messages, *signals) {}
  double value(const std::string& name, const wire::CanFrame& frame) {
    wire::FrameSignal signal;
    EXPECT_TRUE(dbc.find(name, signal).ok()) << name;
    double physical = -1;
    EXPECT_EQ(wire::extract(signal, frame, physical), wire::SignalError::kNone) << name;
    return physical;
  }
  std::unique_ptr<std::array<wire::DbcMessage, 100>> messages =
      std::make_unique<std::array<wire::DbcMessage, 100>>();
  std::unique_ptr<std::array<wire::DbcSignal, 500>> signals =
      std::make_unique<std::array<wire::DbcSignal, 500>>();
  wire::Dbc dbc;
};

TEST(CanViews, OwnReaderUnderstandsTheDbc) {
  const std::string text = can_views::dbc();
  Reader reader;
  ASSERT_TRUE(reader.dbc.parse(text).ok());
  EXPECT_EQ(reader.dbc.messages().size(), 93U);
  const wire::CanFrame frame = wire::broadcast_frame(support::sticking_loop());
  EXPECT_EQ(reader.value("StickbandLoop1.verdict", frame), 4);
  EXPECT_EQ(reader.value("StickbandLoop1.ne107", frame), 4);
  EXPECT_EQ(reader.value("StickbandLoop1.confidence_pct", frame), 97.5);
  EXPECT_EQ(reader.value("StickbandLoop1.input_status", frame), 0);
  EXPECT_NEAR(reader.value("StickbandLoop1.stick_band_ascending_pct", frame), 5.01, 1e-9);
  EXPECT_NEAR(reader.value("StickbandLoop1.stick_band_descending_pct", frame), 4.98,
              1e-9);
  const wire::CanFrame band = wire::detail_frame(2, support::sticking_loop());
  EXPECT_NEAR(reader.value("StickbandLoop1Band.stick_band_ascending_low_pct", band), 4.8,
              1e-9);
  EXPECT_NEAR(reader.value("StickbandLoop1Band.stick_band_descending_high_pct", band),
              5.15, 1e-9);
  const wire::CanFrame trend = wire::detail_frame(3, support::sticking_loop());
  EXPECT_EQ(reader.value("StickbandLoop1Trend.age_s", trend), 12);
  EXPECT_NEAR(reader.value("StickbandLoop1Trend.trend_pct_per_day", trend), -0.031, 1e-9);
  const wire::CanFrame last = wire::broadcast_frame(support::new_loop());
  EXPECT_EQ(reader.value("StickbandLoop31.verdict", last), 0);
}

TEST(CanViews, PageKeepsWhatIsNotGenerated) {
  std::string page = "# Title\n";
  for (const char* name : {"gateway", "loop", "codes", "broadcast", "dtcs"}) {
    page += std::string("<!-- ") + name + " -->\nold\n<!-- /" + name + " -->\nkept\n";
  }
  const std::string made = can_views::page(page);
  EXPECT_EQ(made.find("old"), std::string::npos);
  EXPECT_EQ(made.rfind("# Title\n", 0), 0U);
  EXPECT_NE(made.find("| +5 parameters (read, write) | `band_min_pct` | u16 | 0.01 % |"),
            std::string::npos);
  EXPECT_EQ(can_views::page(made), made);
  EXPECT_THROW((void)can_views::page("# Title\n"), std::runtime_error);
}

}  // namespace
