// The ladder on single cases of the benchmark.
#include <gtest/gtest.h>

#include <algorithm>

#include "hidden/engine.hpp"
#include "support/hidden/case.hpp"

namespace hidden {
namespace {

// A drift of the gain beside the limit would explain as much, but has to leave y alone at
// a u that is far away.
TEST(HiddenEngine, LooksPastAPairThatCannotBe) {
  const CaseKey key{
      {Effect::kSaturation, Effect::kRamp}, Excitation::kSetpointSteps, 40, 16};
  const Named named = name_effects(make_case(key).recording);
  for (const char* effect : {"valve.saturation", "disturbance.ramp"}) {
    EXPECT_TRUE(std::any_of(named.added.begin(), named.added.end(),
                            [&](const AddedEffect& a) { return a.names(effect); }))
        << effect;
  }
}

}  // namespace
}  // namespace hidden
