#include <gtest/gtest.h>

#include <vector>

#include "workbench/recording/times/clock_digits.hpp"

namespace workbench {
namespace {

// Every 5 s from `first` seconds of the day on.
std::vector<double> digits(int first, int rows, double date = 0) {
  std::vector<double> out;
  for (int i = 0; i < rows; ++i) {
    const int s = (first + 5 * i) % 86400;
    out.push_back(date * 1e6 + s / 3600 * 10000 + s / 60 % 60 * 100 + s % 60);
  }
  return out;
}

TEST(ClockDigits, HoursMinutesSecondsPastMidnight) {
  const auto found = clock_digits(digits(86000, 200));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->form, "HHMMSS");
  EXPECT_EQ(found->first_s, 86000);
  EXPECT_EQ(found->t[199], 995);
}

TEST(ClockDigits, MinutesAndSeconds) {
  const auto found = clock_digits(digits(0, 600));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->form, "MMSS");
  EXPECT_EQ(found->t[599], 2995);
}

TEST(ClockDigits, WithADateInFront) {
  const auto found = clock_digits(digits(28800, 100, 260314));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->form, "yyMMddHHMMSS");
  EXPECT_EQ(found->day, 20526);
  EXPECT_EQ(found->first_s, 28800);
  EXPECT_EQ(found->t[99], 495);
}

TEST(ClockDigits, AreNotSeconds) {
  std::vector<double> seconds, hundreds;
  for (int i = 0; i < 500; ++i) {
    seconds.push_back(5 * i);
    hundreds.push_back(100 * i);
  }
  EXPECT_FALSE(clock_digits(seconds));
  EXPECT_FALSE(clock_digits(hundreds));
  EXPECT_FALSE(clock_digits({}));
}

TEST(ClockDigits, TimesOfDayBesideDates) {
  const auto clock = times_of_day({235959, 0, 1, 59, 100}, 6, true);
  ASSERT_TRUE(clock);
  EXPECT_EQ(clock->form, "HHMMSS");
  EXPECT_EQ(clock->seconds, (std::vector<double>{86399, 0, 1, 59, 60}));
  const auto fraction =
      times_of_day({0.3333333333, 0.3333912037, 0.3334490741}, 1, false);
  ASSERT_TRUE(fraction);
  EXPECT_EQ(fraction->form, "fractions of a day");
  EXPECT_EQ(fraction->seconds, (std::vector<double>{28800, 28805, 28810}));
}

TEST(ClockDigits, HoursAndMinutesOnlyWhereADayPasses) {
  const std::vector<double> numbers = {2358, 2359, 0, 1, 2};
  const auto clock = times_of_day(numbers, 4, true);
  ASSERT_TRUE(clock);
  EXPECT_EQ(clock->form, "HHMM");
  EXPECT_EQ(clock->seconds[1], 86340);
  EXPECT_FALSE(times_of_day({800, 801, 802}, 3, false));
  EXPECT_EQ(times_of_day({800, 801, 802}, 6, false)->seconds[0], 480);  // 000800
}

TEST(ClockDigits, NumbersBesideDatesThatAreNoTimes) {
  EXPECT_FALSE(times_of_day({0, 5, 3661, 3666}, 4, false));
  EXPECT_FALSE(times_of_day({5050, 6070}, 4, false));
  EXPECT_FALSE(times_of_day({0, 0.37, 0.74}, 1, false));
  EXPECT_FALSE(times_of_day({}, 0, false));
}

TEST(ClockDigits, StepsThatNoRecorderIsSetTo) {
  for (const double step : {7.0, 12.0, 37.0, 100.0, 1000.0}) {
    EXPECT_TRUE(is_unusual_step(step)) << step;
  }
  for (const double step : {0.5, 1.0, 2.0, 10.0, 60.0, 12.5, 3600.0}) {
    EXPECT_FALSE(is_unusual_step(step)) << step;
  }
}

TEST(ClockDigits, StepsInDays) {
  EXPECT_TRUE(is_step_in_days(5.78704e-05));
  EXPECT_FALSE(is_step_in_days(1e-4));
  EXPECT_FALSE(is_step_in_days(6.25e-4));
}

TEST(ClockDigits, BelowTwentyFourHundredMayBeHoursAndMinutes) {
  std::vector<double> minutes;
  for (int i = 0; i < 300; ++i) minutes.push_back((600 + i) / 60 * 100 + i % 60);
  const auto open = clock_digits(minutes);
  ASSERT_TRUE(open);
  EXPECT_TRUE(open->open);
  EXPECT_EQ(open->form, "MMSS");
  EXPECT_EQ(open->t[299], 299);
  const auto hours = clock_digits(minutes, true);
  ASSERT_TRUE(hours);
  EXPECT_FALSE(hours->open);
  EXPECT_EQ(hours->form, "HHMM");
  EXPECT_EQ(hours->t[299], 299 * 60);
  EXPECT_EQ(hours->first_s, 36000);
  EXPECT_FALSE(clock_digits(digits(0, 600))->open);
}

TEST(ClockDigits, AnUnevenCountIsOfALoopThatTakesAFewMilliseconds) {
  std::vector<double> loop = {445};
  for (int i = 0; i < 100; ++i)
    loop.push_back(loop.back() + 1 + (i % 7 == 3) + (i % 5 == 0));
  EXPECT_TRUE(is_uneven_count(loop));
  std::vector<double> seconds;
  for (int i = 0; i < 100; ++i) seconds.push_back(i < 50 ? i : i + 1);
  EXPECT_FALSE(is_uneven_count(seconds)) << "one sample is missing";
  loop.push_back(loop.back() + 60);
  EXPECT_FALSE(is_uneven_count(loop)) << "a pause";
  EXPECT_FALSE(is_uneven_count(std::vector<double>{0, 0.5, 1.5}));
  EXPECT_FALSE(is_uneven_count({}));
}

TEST(ClockDigits, AreNotEvenSteps) {
  std::vector<double> fifties;
  for (int i = 0; i < 100; ++i) fifties.push_back(50 * i);
  EXPECT_FALSE(clock_digits(fifties));
}

}  // namespace
}  // namespace workbench
