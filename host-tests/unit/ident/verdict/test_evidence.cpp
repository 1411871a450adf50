// What a search found, weighed with more and more independent samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "ident/verdict/evidence.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using EvidenceSearch = ValveSearch<double>;

constexpr std::size_t kEvidenceSamples = 700;
constexpr ValveForm kEvidenceForms[] = {ValveForm::kLinear,    ValveForm::kBacklash,
                                        ValveForm::kAscending, ValveForm::kDescending,
                                        ValveForm::kSymmetric, ValveForm::kMixed};

// A sticking loop of some 100 samples' period, scaled as the identifier does.
class Evidences : public testing::Test {
 protected:
  static void SetUpTestSuite() { found_ = std::make_unique<Found>(); }
  static void TearDownTestSuite() { found_.reset(); }
  static const EvidenceSearch& search() { return found_->search; }

  static Evidence<double> weighed(double observations) {
    Evidence<double> evidence;
    evidence.observations = observations;
    weigh_forms(search(), evidence);
    return evidence;
  }
  // (E2), up to what all forms have in common.
  static double cost(ValveForm form, double observations) {
    return 0.5 * observations * std::log(search().best(form).fit.error) +
           (0.5 * std::log(observations) + 2) * free_parameters(form);
  }

 private:
  struct Found {
    Found() : positions(kEvidenceSamples), scratch(kEvidenceSamples) {
      test::Random random(11);
      test::LoopSettings loop;
      loop.friction = {1, 4, 4, SlipMotion::kStops};
      loop.noise = 0.1;
      const test::Window w = test::simulate_loop(loop, kEvidenceSamples, random);
      const auto [low, high] = std::minmax_element(w.u.begin(), w.u.end());
      for (const double value : w.u) u.push_back((value - *low) / (*high - *low));
      double mean = 0;
      double square = 0;
      for (const double value : w.y) mean += value / kEvidenceSamples;
      for (const double value : w.y)
        square += (value - mean) * (value - mean) / kEvidenceSamples;
      for (const double value : w.y) y.push_back((value - mean) / std::sqrt(square));
      SearchWindow<double> window;
      window.u = u;
      window.y = y;
      window.period = 110;
      window.swing = 0.9;
      search.start(window, positions, scratch, *stems);
      while (!search.step(1 << 20)) {
      }
    }
    std::vector<double> u, y, positions, scratch;
    std::unique_ptr<EvidenceSearch::Stems> stems =
        std::make_unique<EvidenceSearch::Stems>();
    EvidenceSearch search;
  };
  static inline std::unique_ptr<Found> found_;
};

TEST_F(Evidences, TheFormIsTheOneWithTheLowestCost) {
  for (double observations = 3; observations < 4000; observations *= 1.15) {
    const Evidence<double> evidence = weighed(observations);
    for (const ValveForm form : kEvidenceForms) {
      if (!search().best(form).known) continue;
      EXPECT_LE(cost(evidence.form, observations), cost(form, observations) + 1e-9)
          << observations;
    }
  }
}

TEST_F(Evidences, FewSamplesPayForNoParameterAndManyForMore) {
  EXPECT_EQ(weighed(3).form, ValveForm::kLinear);
  EXPECT_EQ(weighed(0).form, ValveForm::kLinear);
  int parameters = 0;
  for (double observations = 3; observations < 4000; observations *= 2) {
    const int now = free_parameters(weighed(observations).form);
    EXPECT_GE(now, parameters);
    parameters = now;
  }
  EXPECT_GE(parameters, 2);
}

// (E3).
TEST_F(Evidences, TheScoreIsTheGainLessTheCost) {
  for (const double observations : {3.0, 50.0, 400.0}) {
    const Evidence<double> e = weighed(observations);
    const double linear = search().best(ValveForm::kLinear).fit.error;
    const double own = search().best(e.form).fit.error;
    EXPECT_NEAR(e.error_ratio, linear / own, 1e-9);
    EXPECT_NEAR(e.score,
                0.5 * observations * std::log(linear / own) -
                    0.5 * std::log(observations) * free_parameters(e.form),
                1e-6);
    const double jumpless =
        std::min(linear, search().best(ValveForm::kBacklash).fit.error);
    EXPECT_NEAR(e.jump_ratio, jumpless / own, 1e-9);
  }
  EXPECT_EQ(weighed(3).error_ratio, 1);
  EXPECT_EQ(weighed(3).slip_over_band, 0) << "a linear valve has no band";
}

TEST_F(Evidences, BandsFitsAndTimesAreThoseOfTheForm) {
  const Evidence<double> e = weighed(400);
  const ValveModel<double>& model = search().best(e.form);
  const ValveFriction<double>& f = model.friction;
  const double band = std::max(f.stick_ascending(), f.stick_descending());
  ASSERT_GT(band, 0);
  EXPECT_NEAR(e.band_over_swing, band / 0.9, 1e-12);
  EXPECT_NEAR(e.slip_over_band, std::max(f.slip_ascending, f.slip_descending) / band,
              1e-12);
  const auto fit = [](const ValveModel<double>& of) {
    return 100 * (1 - std::sqrt(of.fit.error / kEvidenceSamples));
  };
  EXPECT_NEAR(e.fit_percent, fit(model), 1e-9);
  EXPECT_NEAR(e.fit_linear_percent, fit(search().best(ValveForm::kLinear)), 1e-9);
  EXPECT_GT(e.fit_percent, e.fit_linear_percent);
  // Pole exp(−1/T), T over the period.
  EXPECT_NEAR(std::exp(-1 / (e.time_constant * 110)), model.poles.slow, 1e-4);
}

TEST_F(Evidences, TheSmallerOfTwoBandsIsToldOfWhichEitherMayBeUnknown) {
  Evidence<double> e;
  EXPECT_EQ(shown_or_excluded(e, true), 0);
  e.ladder.detectable_band = 0.3;
  e.ladder.hoped_band = 0.1;
  EXPECT_EQ(shown_or_excluded(e, false), 0.3);
  e.excluded_above = 0.2;
  EXPECT_EQ(shown_or_excluded(e, false), 0.2);
  EXPECT_EQ(shown_or_excluded(e, true), 0.1);
  e.ladder.hoped_band = 0;
  EXPECT_EQ(shown_or_excluded(e, true), 0.2);
}

}  // namespace
}  // namespace ident
