#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ident/process/start_column.hpp"

namespace ident {
namespace {

constexpr int kColumnSamples = 200;

template <class Column>
void shifts_to_where_it_is_later(Column column, double tolerance) {
  std::vector<double> values;
  const Column at_start = column;
  for (int t = 0; t < kColumnSamples; ++t) {
    values.push_back(column.next());
  }
  PolePower<double> power(at_start.pole());
  for (int delay = 0; delay < 16; ++delay, power.next()) {
    const ColumnShift<double> shift = at_start.shift(delay, power);
    for (int t = 0; t + delay < kColumnSamples; ++t) {
      ASSERT_NEAR(shift.share * values[t] + shift.constant +
                      shift.slope * (2.0 * t / kColumnSamples),
                  values[t + delay], tolerance)
          << at_start.pole() << ' ' << delay << ' ' << t;
    }
  }
}

TEST(StartColumn, ShiftsToWhereItIsLater) {
  for (const double pole : {0.0, 0.3, 0.9, 0.99, 0.996, 0.9995, 0.99999}) {
    for (const bool drift : {false, true}) {
      // The scale of an almost integrating pole multiplies the rounding as well.
      shifts_to_where_it_is_later(StartColumn<double>(pole, kColumnSamples, drift),
                                  pole < 0.9999 ? 1e-9 : 1e-6);
    }
  }
}

TEST(StartColumn, OfAFastPoleIsItsPowersUntilNothingIsLeft) {
  StartColumn<double> column(0.5, kColumnSamples, true);
  EXPECT_EQ(column.next(), 1.0);
  EXPECT_EQ(column.next(), 0.5);
  EXPECT_EQ(column.next(), 0.25);
  for (int t = 3; t < kColumnSamples; ++t) {
    (void)column.next();
  }
  EXPECT_FALSE(column.present());
}

// The least sizes have one code for all columns.
TEST(StartColumn, StandsForAPlainOneAndForNone) {
  for (const double pole : {0.0, 0.3, 0.99, 1.0}) {
    auto column = StartColumn<double>::plain(pole, kColumnSamples);
    shifts_to_where_it_is_later(column, 1e-12);
    PlainStart<double> plain(pole, kColumnSamples);
    EXPECT_EQ(column.pole(), plain.pole());
    for (int run = 0; run < 2; ++run) {
      column.restart();
      plain.restart();
      for (int t = 0; t < kColumnSamples; ++t) {
        ASSERT_EQ(column.present(), plain.present()) << pole << ' ' << t;
        ASSERT_NEAR(column.next(), plain.next(), 1e-13) << pole << ' ' << t;
      }
    }
  }
  EXPECT_FALSE(StartColumn<double>::none().present());
  PolePower<double> power(StartColumn<double>::none().pole());
  EXPECT_EQ(StartColumn<double>::none().shift(3, power).constant, 0.0);
}

TEST(StartColumn, OfAnIntegratorIsNone) {
  EXPECT_FALSE(StartColumn<double>(1.0, kColumnSamples, false).present());
}

// What it is apart from the offset: −1 … 1 about the middle of a slow decay.
TEST(StartColumn, OfASlowPoleIsOfOrderOne) {
  StartColumn<double> column(0.9995, kColumnSamples, false);
  double least = 0;
  double most = 0;
  for (int t = 0; t < kColumnSamples; ++t) {
    const double value = column.next();
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_NEAR(least, -1, 0.01);
  EXPECT_NEAR(most, 1, 0.01);
}

TEST(PlainStart, ShiftsToWhereItIsLater) {
  for (const double pole : {0.0, 0.3, 0.9, 0.996, 1.0}) {
    shifts_to_where_it_is_later(PlainStart<double>(pole, kColumnSamples), 1e-9);
  }
}

}  // namespace
}  // namespace ident
