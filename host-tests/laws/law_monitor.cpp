// Laws of a monitor over its whole life: many identifications.
#include <gtest/gtest.h>

#include "support/ident/monitored_plant.hpp"

namespace {

using ident::EventKind;
using Plant = test::MonitoredPlant;

TEST(MonitorLaw, RaisesOnceAndClearsOnceAfterTheValveIsHealed) {
  ident::MonitorSettings<float> settings;
  settings.evaluate_every_pct = 50;
  settings.alarm.off_delay_windows = 4;
  Plant plant(settings);
  plant.run(1500);
  ASSERT_EQ(plant.of(EventKind::kStictionRaised).size(), 1U);
  EXPECT_TRUE(plant.report().stiction_raised);
  EXPECT_TRUE(plant.report().oscillating);
  const ident::Event<float> raised = plant.of(EventKind::kStictionRaised)[0];
  EXPECT_EQ(raised.verdict, ident::Verdict::kStiction);
  ASSERT_TRUE(raised.stick_band.ascending.known);
  EXPECT_NEAR(raised.stick_band.ascending.value, 8.0f, 1.0f);
  EXPECT_LT(raised.t_s(), 1100);

  plant.loop.heal();
  plant.run(2500);
  EXPECT_EQ(plant.of(EventKind::kStictionRaised).size(), 1U);
  ASSERT_EQ(plant.of(EventKind::kStictionCleared).size(), 1U);
  EXPECT_GT(plant.of(EventKind::kStictionCleared)[0].t_s(), 2000);
  EXPECT_FALSE(plant.report().stiction_raised);
  EXPECT_LE(plant.of(EventKind::kOscillationStarted).size(), 2U);
  EXPECT_LE(plant.events.size(), 12U);
  EXPECT_EQ(plant.report().counters.events_lost, 0U);
  EXPECT_EQ(plant.report().counters.skipped_windows, 0U);
}

// When the alarm is raised, s, if somebody asks every `pace` samples; 0: nobody does.
double raised_after(int pace) {
  Plant plant;
  for (int k = 1; k <= 1500 && !plant.report().stiction_raised; ++k) {
    plant.run(1);
    if (pace > 0 && k % pace == 0) plant.monitor->request_evaluation();
  }
  const test::Events raised = plant.of(EventKind::kStictionRaised);
  return raised.size() == 1 ? raised[0].t_s() : -1;
}

TEST(MonitorLaw, RequestsNeitherHurryNorDelayTheAlarm) {
  const double without = raised_after(0);
  ASSERT_GT(without, 0);
  for (const int pace : {10, 75, 100, 120, 400}) {
    EXPECT_EQ(raised_after(pace), without) << "asked every " << pace << " s";
  }
}

}  // namespace
