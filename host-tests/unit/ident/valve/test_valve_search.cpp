#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>

#include "ident/signal/reversals.hpp"
#include "ident/valve/valve_search.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

constexpr double kPerCycle = 40;  // samples of y, as the identifier averages them

// A loop scaled and averaged as the identifier does, and what it was scaled by.
template <class Real>
struct Scaled {
  std::vector<Real> u;
  std::vector<Real> y;
  double range = 1;
  double swing = 1;   // of u, scaled
  double period = 0;  // samples of y
  int decimation = 1;
  std::size_t warm_up = 0;
};

std::vector<Reversal<double>> reversals_of(const std::vector<double>& u) {
  std::vector<unsigned char> ascending(u.size());
  std::vector<Reversal<double>> found(200);
  found.resize(mark_directions<double>(u, 0.3, ascending, found));
  return found;
}

template <class Real>
Scaled<Real> scale(const test::Window& w) {
  Scaled<Real> s;
  const auto [low, high] = std::minmax_element(w.u.begin(), w.u.end());
  s.range = *high - *low;
  std::vector<double> u;
  for (const double value : w.u) {
    u.push_back((value - *low) / s.range);
  }
  const auto found = reversals_of(u);
  const double turns = static_cast<double>(found.size() - 1);
  double swing = 0;
  for (std::size_t k = 1; k < found.size(); ++k) {
    swing += std::abs(found[k].value - found[k - 1].value);
  }
  s.swing = swing / turns;
  const double period =
      2 * static_cast<double>(found.back().index - found[0].index) / turns;
  s.decimation = std::max(static_cast<int>(period / kPerCycle), 1);
  s.period = period / s.decimation;

  std::vector<double> y;
  const std::size_t step = static_cast<std::size_t>(s.decimation);
  for (std::size_t t = 0; t + step <= w.y.size(); t += step) {
    double sum = 0;
    for (std::size_t k = 0; k < step; ++k) {
      s.u.push_back(static_cast<Real>(u[t + k]));
      sum += w.y[t + k];
    }
    y.push_back(sum / s.decimation);
  }
  const double n = static_cast<double>(y.size());
  const double mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double square = 0;
  for (const double value : y) {
    square += (value - mean) * (value - mean) / n;
  }
  for (const double value : y) {
    s.y.push_back(static_cast<Real>((value - mean) / std::sqrt(square)));
  }
  // One cycle on, u is nearly where it began.
  double nearest = 1e9;
  for (std::size_t k = static_cast<std::size_t>(0.85 * period);
       static_cast<double>(k) < 1.15 * period; ++k) {
    const double off = std::abs(u[k] - u[0]) + std::abs(u[k + 10] - u[10]);
    if (off < nearest) {
      nearest = off;
      s.warm_up = k;
    }
  }
  return s;
}

template <class Real>
class Search {
 public:
  explicit Search(const Scaled<Real>& s, int budget = 1 << 20)
      : positions_(s.y.size()), scratch_(s.y.size()) {
    SearchWindow<Real> window;
    window.u = s.u;
    window.y = s.y;
    window.decimation = s.decimation;
    window.period = static_cast<Real>(s.period);
    window.swing = static_cast<Real>(s.swing);
    window.warm_up = s.warm_up;
    window.drift = false;
    search_.start(window, positions_, scratch_, *stems_);
    while (!search_.step(budget)) {
      ++slices;
    }
  }
  [[nodiscard]] const ValveModel<Real>& best(ValveForm form) const {
    return search_.best(form);
  }
  int slices = 0;

 private:
  std::vector<Real> positions_;
  std::vector<Real> scratch_;
  std::unique_ptr<typename ValveSearch<Real>::Stems> stems_ =
      std::make_unique<typename ValveSearch<Real>::Stems>();
  ValveSearch<Real> search_;
};

constexpr ValveForm kForms[] = {ValveForm::kLinear,    ValveForm::kBacklash,
                                ValveForm::kAscending, ValveForm::kDescending,
                                ValveForm::kSymmetric, ValveForm::kMixed};

test::LoopSettings sticking(double deadband, double slip_ascending,
                            double slip_descending, SlipMotion motion) {
  test::LoopSettings settings;
  settings.friction = {deadband, slip_ascending, slip_descending, motion};
  return settings;
}

TEST(ValveForms, CountTheirParameters) {
  const int expected[] = {0, 1, 1, 1, 2, 3};
  for (int k = 0; k < kValveForms; ++k) {
    EXPECT_EQ(free_parameters(kForms[k]), expected[k]);
  }
}

// The larger relative error of both stick bands, the median of five loops.
double median_band_error(test::LoopSettings settings, ValveForm form) {
  std::vector<double> errors;
  for (int seed = 0; seed < 5; ++seed) {
    test::Random random(100 + seed);
    const Scaled<double> s = scale<double>(test::simulate_loop(settings, 1600, random));
    const Search<double> search(s);
    const ValveFriction<double>& found = search.best(form).friction;
    const ValveFriction<double>& truth = settings.friction;
    errors.push_back(std::max(
        std::abs(found.stick_ascending() * s.range / truth.stick_ascending() - 1),
        std::abs(found.stick_descending() * s.range / truth.stick_descending() - 1)));
    // It beats the simpler forms by far.
    const auto error = [&](ValveForm of) { return search.best(of).fit.error; };
    EXPECT_LT(3 * error(form), error(ValveForm::kLinear)) << seed;
    EXPECT_LT(1.5 * error(form), error(ValveForm::kBacklash)) << seed;
  }
  std::sort(errors.begin(), errors.end());
  return errors[2];
}

class ValveSearchOn : public testing::TestWithParam<SlipMotion> {};

TEST_P(ValveSearchOn, ASymmetricValveFindsItsStickBand) {
  EXPECT_LT(median_band_error(sticking(1, 4, 4, GetParam()), ValveForm::kSymmetric),
            0.05);
}

// u swings by 5.6, the stick bands are 5: the valve moves on every stroke, wherever the
// window begins and although its start is not known.
TEST_P(ValveSearchOn, AnUnknownStartLeavesAMovingValveMoving) {
  test::Random random(34);
  const auto settings = sticking(1, 4, 4, GetParam());
  test::Window w = test::simulate_loop(settings, 1600, random);
  for (int shift = 0; shift < 4; ++shift) {
    const Scaled<double> s = scale<double>(w);
    std::vector<double> x(s.y.size());
    SearchWindow<double> window;
    window.u = s.u;
    window.y = s.y;
    window.decimation = s.decimation;
    window.period = s.period;
    window.swing = s.swing;
    window.warm_up = s.warm_up;
    std::vector<double> scratch(window.y.size());
    const auto stems = std::make_unique<ValveSearch<double>::Stems>();
    ValveSearch<double> search;
    search.start(window, x, scratch, *stems);
    ValveModel<double> model;
    model.friction = {1 / s.range, 4 / s.range, 4 / s.range, GetParam()};
    search.pass().place(model);
    search.pass().finish();
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    EXPECT_GT((*high - *low) * s.range, 3) << shift;
    w.u.erase(w.u.begin(), w.u.begin() + 41);
    w.y.erase(w.y.begin(), w.y.begin() + 41);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, ValveSearchOn,
                         testing::Values(SlipMotion::kSlides, SlipMotion::kStops,
                                         SlipMotion::kResticks));

TEST(ValveSearch, FindsBothBandsOfAnUnevenValve) {
  EXPECT_LT(
      median_band_error(sticking(1.5, 4, 2, SlipMotion::kSlides), ValveForm::kMixed),
      0.05);
}

TEST(ValveSearch, FindsOneSidedStiction) {
  test::Random random(36);
  const test::Window w =
      test::simulate_loop(sticking(0, 4, 0, SlipMotion::kSlides), 1600, random);
  const Scaled<double> s = scale<double>(w);
  const Search<double> search(s);
  const auto& best = search.best(ValveForm::kAscending);
  EXPECT_NEAR(best.friction.stick_ascending() * s.range, 4, 0.2);
  EXPECT_EQ(best.friction.stick_descending(), 0);
  EXPECT_LT(2 * best.fit.error, search.best(ValveForm::kDescending).fit.error);
  EXPECT_LT(1.5 * best.fit.error, search.best(ValveForm::kBacklash).fit.error);
}

TEST(ValveSearch, NestedFormsAreNotWorseThanTheSimplerOnes) {
  test::Random random(37);
  const test::Window w =
      test::simulate_loop(sticking(2, 2, 2, SlipMotion::kSlides), 800, random);
  const Search<double> search(scale<double>(w));
  const auto error = [&](ValveForm form) { return search.best(form).fit.error; };
  for (const ValveForm form : kForms) {
    EXPECT_TRUE(search.best(form).known);
    EXPECT_GE(error(form), 0);
    // Pattern search ends within its step, not at the minimum: 2 %.
    EXPECT_LE(error(ValveForm::kMixed), 1.02 * error(form));
  }
  EXPECT_EQ(search.best(ValveForm::kLinear).friction.stick_ascending(), 0);
  EXPECT_EQ(search.best(ValveForm::kBacklash).friction.slip_ascending, 0);
  EXPECT_EQ(search.best(ValveForm::kAscending).friction.stick_descending(), 0);
  EXPECT_EQ(search.best(ValveForm::kDescending).friction.stick_ascending(), 0);
}

// Slices change nothing: bit for bit the same.
TEST(ValveSearch, GivesTheSameInSlices) {
  test::Random random(38);
  const test::Window w =
      test::simulate_loop(sticking(1, 4, 4, SlipMotion::kSlides), 500, random);
  const Scaled<double> s = scale<double>(w);
  const Search<double> whole(s);
  const Search<double> sliced(s, 1);
  EXPECT_GT(sliced.slices, 1000);
  for (const ValveForm form : kForms) {
    EXPECT_EQ(whole.best(form).fit.error, sliced.best(form).fit.error);
    EXPECT_EQ(whole.best(form).friction.deadband, sliced.best(form).friction.deadband);
    EXPECT_EQ(whole.best(form).poles.slow, sliced.best(form).poles.slow);
  }
}

// A first-order process behind a linear valve, moved by a load that u makes up for.
test::Window linear_loop(test::Random& random) {
  std::normal_distribution<double> normal;
  test::Window w;
  double state = 0;
  for (int t = 0; t < 800; ++t) {
    const double u = 5 * std::sin(t * 0.08) + 2 * std::sin(t * 0.05);
    state += (u - state) / 20;
    w.u.push_back(u);
    w.y.push_back(state + 0.5 * normal(random));
  }
  return w;
}

TEST(ValveSearch, EndsEarlyWhereALinearValveLeavesWhiteNoise) {
  test::Random random(40);
  const int few = Search<double>(scale<double>(linear_loop(random)), 1).slices;
  const int many =
      Search<double>(scale<double>(test::simulate_loop(
                         sticking(1, 4, 4, SlipMotion::kResticks), 800, random)),
                     1)
          .slices;
  EXPECT_GT(few, 100);
  EXPECT_GT(many, 2 * few);
}

// The search compares errors; in float they are good to 10⁻⁴ of the energy, so it may end
// at another step, but not at another valve.
TEST(ValveSearch, InFloatFindsTheSameBand) {
  test::Random random(39);
  test::LoopSettings settings = sticking(1, 4, 4, SlipMotion::kSlides);
  settings.noise = 0.1;
  const test::Window w = test::simulate_loop(settings, 1200, random);
  const Search<double> in_double(scale<double>(w));
  const Search<float> in_float(scale<float>(w));
  const auto band = [](const auto& search) {
    return static_cast<double>(
        search.best(ValveForm::kSymmetric).friction.stick_ascending());
  };
  EXPECT_NEAR(band(in_float), band(in_double), 0.05 * band(in_double));
}

}  // namespace
}  // namespace ident
