#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <random>

#include "ident/signal/reversals.hpp"
#include "ident/valve/valve_search.hpp"
#include "support/ident/all_at_once.hpp"
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
  explicit Search(const Scaled<Real>& s, int budget = 1 << 20,
                  const EarlierValve* earlier = nullptr, bool doubted = false,
                  bool elsewhere = false)
      : positions_(s.y.size()), scratch_(s.y.size()) {
    SearchWindow<Real> window;
    window.u = s.u;
    window.y = s.y;
    window.decimation = s.decimation;
    window.period = static_cast<Real>(s.period);
    window.swing = static_cast<Real>(s.swing);
    window.warm_up = s.warm_up;
    window.drift = false;
    search_.start(window, positions_, scratch_, *stems_, earlier,
                  static_cast<Real>(s.range), doubted, elsewhere ? &elsewhere_ : nullptr);
    while (!search_.step(budget)) {
      ++slices;
    }
  }
  [[nodiscard]] const ValveModel<Real>& best(ValveForm form) const {
    return search_.best(form);
  }
  // The best of all forms.
  [[nodiscard]] const ValveModel<Real>& found() const {
    const ValveModel<Real>* found = &best(ValveForm::kLinear);
    for (int form = 1; form < kValveForms; ++form) {
      const ValveModel<Real>& other = best(static_cast<ValveForm>(form));
      found = other.known && other.fit.error < found->fit.error ? &other : found;
    }
    return *found;
  }
  [[nodiscard]] bool searched() const { return search_.searched(); }
  // The error of a model on the whole window, its process solved.
  [[nodiscard]] ValveModel<Real> solved(const ValveModel<Real>& model) {
    search_.pass().use(positions_.size());
    search_.pass().fit(model, true);
    test::finish(search_.pass());
    return search_.pass().model();
  }
  int slices = 0;

 private:
  std::vector<Real> positions_;
  std::vector<Real> scratch_;
  std::unique_ptr<typename ValveSearch<Real>::Stems> stems_ =
      std::make_unique<typename ValveSearch<Real>::Stems>();
  typename ValveSearch<Real>::Elsewhere elsewhere_;
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
    test::finish(search.pass());
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

// Where the first cycles lead beside the valve, later ones lead to it.
TEST(ValveSearch, LooksAtLaterCyclesWhereSomethingIsLeft) {
  if (!kStemSearch) GTEST_SKIP() << "only where stems are searched";
  for (const int seed : {4, 6}) {
    test::Random random(seed);
    const Scaled<double> s = scale<double>(
        test::simulate_loop(sticking(0, 4, 2, SlipMotion::kResticks), 2000, random));
    const auto band = [&](bool elsewhere) {
      const Search<double> search(s, 1 << 20, nullptr, false, elsewhere);
      return search.found().friction.stick_ascending() * s.range;
    };
    EXPECT_GT(std::abs(band(false) - 4), 0.2) << seed;
    EXPECT_NEAR(band(true), 4, 0.02) << seed;
  }
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

// A wave of slowly changing height through a valve and one lag, in few cycles, so that a
// whole search takes little time.
test::Window driven(const ValveFriction<double>& friction, std::size_t samples,
                    double noise, std::uint64_t seed) {
  test::Random random(seed);
  test::Window w;
  StickSlipValve<double> valve(friction, 50);
  double state = 50;
  for (std::size_t t = 0; t < samples; ++t) {
    const double time = static_cast<double>(t);
    const double height = 4.5 + 0.4 * std::sin(time / 77);
    w.u.push_back(50 + height * std::sin(time * 0.157) + 0.02 * test::normal(random));
    w.y.push_back(1.7 * state + noise * test::normal(random));
    state += (valve.step(w.u.back()) - state) / 12;
  }
  return w;
}

ValveFriction<double> valve_of(SlipMotion motion) {
  return {1.2, 3, 2, motion};
}

// The larger relative error of both stick bands of the best valve.
double band_error(const Search<double>& search, const Scaled<double>& s) {
  const ValveFriction<double>& found = search.found().friction;
  const ValveFriction<double> truth = valve_of(SlipMotion::kStops);
  return std::max(
      std::abs(found.stick_ascending() * s.range / truth.stick_ascending() - 1),
      std::abs(found.stick_descending() * s.range / truth.stick_descending() - 1));
}

// On five cycles without a load a valve that stops is always found.
TEST(ValveSearch, FindsAValveThatStopsInFewCycles) {
  constexpr std::size_t kSamples = 200;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Scaled<double> s =
        scale<double>(driven(valve_of(SlipMotion::kStops), kSamples, 0.02, seed));
    const Search<double> search(s);
    EXPECT_LT(band_error(search, s), 0.07) << seed;
    EXPECT_EQ(search.found().friction.motion, SlipMotion::kStops) << seed;
    EXPECT_LT(search.found().fit.error, 1e-4 * kSamples) << seed;
    // No form that it contains is better by more than a step of the polish.
    EXPECT_LT(search.best(ValveForm::kMixed).fit.error,
              1.1 * search.best(ValveForm::kSymmetric).fit.error)
        << seed;
  }
}

// That valve as an earlier window left it.
EarlierValve earlier_of(SlipMotion motion, float unexplained, std::uint8_t trusted) {
  return {{1.2F, 3, 2, motion}, 12, 0, unexplained, trusted};
}

class ValveSearchFrom : public testing::TestWithParam<SlipMotion> {
 protected:
  Scaled<double> s = scale<double>(driven(valve_of(GetParam()), 320, 0.1, 2));
};

// A trusted valve that does as before is the answer, and no other is looked for.
TEST_P(ValveSearchFrom, ATrustedValveLooksForNoOther) {
  const EarlierValve earlier = earlier_of(GetParam(), 0.004F, 3);
  const Search<double> search(s, 1 << 20, &earlier);
  EXPECT_FALSE(search.searched());
  EXPECT_LT(band_error(search, s), 0.05);
  EXPECT_LT(search.found().fit.error, 0.004 * 320);
  EXPECT_EQ(search.found().friction.motion, GetParam());
}

// One that leaves much more than it did is not.
TEST_P(ValveSearchFrom, AValveThatDoesLessLooksForOthers) {
  const EarlierValve better_once = earlier_of(GetParam(), 0.0008F, 3);
  EXPECT_TRUE(Search<double>(s, 1 << 20, &better_once).searched());
}

// One that is not trusted is tried at last: it leads no search, and none ends at a worse
// valve.
TEST_P(ValveSearchFrom, AValveThatIsNotTrustedIsTriedAtLast) {
  const EarlierValve earlier = earlier_of(GetParam(), 0.004F, 0);
  const Search<double> with(s, 1 << 20, &earlier);
  const Search<double> without(s);
  EXPECT_TRUE(with.searched());
  EXPECT_LT(band_error(with, s), 0.05);
  EXPECT_LE(with.found().fit.error, without.found().fit.error);
  const EarlierValve none;
  EXPECT_EQ(Search<double>(s, 1 << 20, &none).found().fit.error,
            without.found().fit.error);
}

// What doubts do where a valve that slides is far better than a linear one: nothing.
TEST_P(ValveSearchFrom, DoubtsLookForAValveThatPays) {
  const Search<double> with(s, 1 << 20, nullptr, true);
  EXPECT_EQ(with.found().fit.error, Search<double>(s).found().fit.error);
  EXPECT_EQ(with.found().friction.motion, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Remembering, ValveSearchFrom,
                         testing::Values(SlipMotion::kStops, SlipMotion::kResticks));

// A linear valve under a load: what is left is not white, but no valve takes a tenth of
// it.
TEST(ValveSearch, EndsWhereStickingIsDoubtedAndDoesNotPay) {
  test::Window w = driven({}, 400, 0.1, 3);
  for (std::size_t t = 0; t < w.y.size(); ++t) {
    w.y[t] += 2 * std::sin(0.041 * static_cast<double>(t));
  }
  const Scaled<double> s = scale<double>(w);
  const Search<double> doubted(s, 1, nullptr, true);
  const Search<double> asked(s, 1);
  EXPECT_GT(doubted.slices, 100);
  EXPECT_LT(3 * doubted.slices, asked.slices);
  EXPECT_EQ(doubted.best(ValveForm::kLinear).fit.error,
            asked.best(ValveForm::kLinear).fit.error);
}

}  // namespace
}  // namespace ident
