#include <gtest/gtest.h>

#include <memory>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"

namespace ident {
namespace {

TEST(Configurations, GrowFromSmallToLarge) {
  EXPECT_LT(kSmallWindow, kStandardWindow);
  EXPECT_LT(kStandardWindow, kLargeWindow);
}

template <class Real, std::size_t Capacity>
void answers_at_once_to_an_empty_window() {
  using Identifier = ident::Identifier<Real, Capacity>;
  static_assert(Identifier::kCapacity == Capacity);
  static_assert(Identifier::kFewestSamples < Capacity);
  const auto identifier = std::make_unique<Identifier>();
  EXPECT_TRUE(identifier->done());
  const auto& result = identifier->run({}, {}, {});
  EXPECT_EQ(result.verdict, Verdict::kUndecided);
  EXPECT_EQ(result.reason, Reason::kTooShort);
}

// Links only if each is instantiated.
TEST(Configurations, EachShipsAnIdentifier) {
  answers_at_once_to_an_empty_window<float, kSmallWindow>();
  answers_at_once_to_an_empty_window<float, kStandardWindow>();
  answers_at_once_to_an_empty_window<float, kLargeWindow>();
  answers_at_once_to_an_empty_window<double, kStandardWindow>();
  answers_at_once_to_an_empty_window<double, kLargeWindow>();
}

// Four arrays of Real and one of bytes for each sample; the searches' share does not
// grow.
TEST(Configurations, MemoryGrowsByTheArraysOfTheWindow) {
  const std::size_t more = kLargeWindow - kStandardWindow;
  const std::size_t arrays = 4;
  // The paper's search is the larger one in the standard window, so that the valve's
  // array is not seen in full.
  EXPECT_LE(sizeof(Identifier<float, kLargeWindow>) -
                sizeof(Identifier<float, kStandardWindow>),
            more * (arrays * sizeof(float) + 1));
  EXPECT_GE(sizeof(Identifier<float, kLargeWindow>) -
                sizeof(Identifier<float, kStandardWindow>),
            more * ((arrays - 1) * sizeof(float) + 1));
  EXPECT_LE(sizeof(Identifier<double, kLargeWindow>) -
                sizeof(Identifier<double, kStandardWindow>),
            more * (arrays * sizeof(double) + 1));
}

}  // namespace
}  // namespace ident
