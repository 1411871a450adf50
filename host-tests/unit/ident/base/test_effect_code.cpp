// The one table of effects, held against what the workbench registers.
#include <gtest/gtest.h>

#include <set>

#include "ident/base/effect_code.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/effects/effect.hpp"

namespace ident {
namespace {

TEST(EffectCode, IsTheOrderOfTheWorkbenchCatalogue) {
  const auto& effects = workbench::standard_catalogue().effects();
  ASSERT_EQ(effects.size(), static_cast<std::size_t>(kEffectCodes - 1));
  for (std::size_t k = 0; k < effects.size(); ++k) {
    EXPECT_EQ(effects[k]->code(), kEffectNames[k + 1]);
  }
}

TEST(EffectCode, NamesAreUniqueAndNoneHasNone) {
  EXPECT_TRUE(name(EffectCode::kNone).empty());
  EXPECT_EQ(name(EffectCode::kValveStiction), "valve.stiction");
  EXPECT_EQ(name(EffectCode::kSensorQuantisation), "sensor.quantisation");
  EXPECT_EQ(std::set<std::string_view>(kEffectNames.begin(), kEffectNames.end()).size(),
            kEffectNames.size());
}

}  // namespace
}  // namespace ident
