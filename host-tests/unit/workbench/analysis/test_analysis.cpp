// Long recordings: bounded work, and the answer of their parts.
#include <gtest/gtest.h>

#include <algorithm>

#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

// `copies` recordings of a scenario, one after the other.
Recording joined_copies(std::string_view scenario, int copies, int first_seed = 1) {
  Recording out;
  for (int seed = first_seed; seed < first_seed + copies; ++seed) {
    const SimulatedLoop loop = *simulate(scenario, static_cast<std::uint64_t>(seed));
    out.period_s = loop.period_s;
    out.u.insert(out.u.end(), loop.u.begin(), loop.u.end());
    out.y.insert(out.y.end(), loop.y.begin(), loop.y.end());
    out.sp.insert(out.sp.end(), loop.sp.begin(), loop.sp.end());
  }
  for (std::size_t i = 0; i < out.u.size(); ++i) {
    out.t.push_back(static_cast<double>(i) * out.period_s);
  }
  return out;
}

Recording held(const Recording& recording, std::size_t times) {
  Recording out;
  out.period_s = recording.period_s;
  for (const Column column : {Column::u, Column::y, Column::sp}) {
    for (const double value : recording.values(column)) {
      out.values(column).insert(out.values(column).end(), times, value);
    }
  }
  for (std::size_t i = 0; i < out.u.size(); ++i) {
    out.t.push_back(static_cast<double>(i) * out.period_s);
  }
  return out;
}

TEST(Analysis, ShortRecordingsAreOneWindowAtTheirOwnRate) {
  Analysis analysis(joined_copies("paper-example-1", 1));
  EXPECT_EQ(analysis.windows(), 1);
  EXPECT_EQ(analysis.decimation(), 1);
  EXPECT_TRUE(analysis.notes().empty());
  const Simulation s = analysis.simulate();
  EXPECT_EQ(s.u.size(), 2800U);
  EXPECT_EQ(s.y_two_path.size(), 2800U);
  EXPECT_TRUE(s.x.empty());
}

TEST(Analysis, PercentagesReferToTheRangeOfUUnlessASpanIsTold) {
  const Recording recording = joined_copies("paper-example-1", 1);
  Analysis analysis(recording);
  const auto [low, high] = std::minmax_element(recording.u.begin(), recording.u.end());
  EXPECT_DOUBLE_EQ(analysis.span(), *high - *low);
  EXPECT_FALSE(analysis.span_is_told());
  analysis.refer_to(100);
  EXPECT_EQ(analysis.span(), 100);
  EXPECT_TRUE(analysis.span_is_told());
}

TEST(Analysis, SlowOscillationsAreThinnedOut) {
  // 1088 samples a cycle and 11200 samples: three become one.
  Analysis analysis(held(joined_copies("paper-example-1", 1), 4));
  EXPECT_EQ(analysis.decimation(), 3);
  EXPECT_EQ(analysis.windows(), 1);
  EXPECT_EQ(analysis.period_s(), 1.5);
  EXPECT_EQ(analysis.notes().size(), 1U);
  EXPECT_NEAR(analysis.result().oscillation.period_samples * analysis.period_s(), 544,
              28);
}

TEST(Analysis, VerySlowOscillationsAreSeenToo) {
  // 6500 samples a cycle: far beyond what the detector watches at this rate.
  Analysis analysis(held(joined_copies("paper-example-1", 1), 24));
  EXPECT_EQ(analysis.windows(), 1);
  EXPECT_EQ(analysis.decimation(), 17);
}

// As of a controller after a setpoint step: over within a mean of three samples.
TEST(Analysis, WhereTheControllerKicksNothingIsThinnedOut) {
  Recording recording = held(joined_copies("paper-example-1", 1), 4);
  const auto [low, high] = std::minmax_element(recording.u.begin(), recording.u.end());
  recording.u[5000] += (*high - *low) / 2;
  const Analysis analysis(recording);
  EXPECT_EQ(analysis.decimation(), 1);
  EXPECT_EQ(analysis.windows(), 3);
}

TEST(Analysis, WindowsInWhichNothingMovesHaveNoSay) {
  Recording recording =
      held(joined_copies("paper-example-1", 1), 2);  // more than one window
  const std::size_t moving = recording.size();
  for (std::size_t i = 0; i < 6 * Identifier::kCapacity; ++i) {
    recording.t.push_back(recording.t.back() + recording.period_s);
    for (const Column column : {Column::u, Column::y, Column::sp}) {
      recording.values(column).push_back(recording.values(column)[moving - 1]);
    }
  }
  const Analysis analysis(recording);
  EXPECT_GT(analysis.windows(), 4);
  EXPECT_EQ(analysis.result().verdict, ident::Verdict::kStiction);
}

// A tenth of the recording more than one window holds is no second opinion.
TEST(Analysis, WindowsThatOverlapCountWhatIsNew) {
  Recording recording = held(joined_copies("stiction", 1, 2), 2);
  const std::size_t size = Identifier::kCapacity + Identifier::kCapacity / 10;
  for (std::vector<double>* column :
       {&recording.t, &recording.u, &recording.y, &recording.sp}) {
    column->resize(size);
  }
  const Analysis analysis(recording);
  ASSERT_EQ(analysis.windows(), 2);
  const auto& windows = analysis.findings();
  EXPECT_GT(analysis.pooled().predicted, 0U);
  EXPECT_LT(analysis.pooled().nats, 1.3 * std::max(windows[0].nats, windows[1].nats));
}

// It is one valve: a band that one recording refutes is not in the others.
TEST(Analysis, TheNarrowestBandThatAnyRecordingRefutesIsTold) {
  std::vector<Recording> recordings;
  double narrowest = 0;
  double widest = 0;
  for (int seed = 1; seed < 80 && !(narrowest < 0.8 * widest); ++seed) {
    const Recording one = joined_copies("tight-tuning", 1, seed);
    const auto alone = Analysis(one).result();
    const double band = alone.detectable_band;
    if (alone.verdict != ident::Verdict::kNoStiction || !(band > 0)) continue;
    narrowest = recordings.empty() ? band : std::min(narrowest, band);
    widest = std::max(widest, band);
    recordings.insert(recordings.begin(), one);
  }
  ASSERT_LT(narrowest, 0.8 * widest);
  const Analysis together(recordings);
  ASSERT_EQ(together.result().verdict, ident::Verdict::kNoStiction);
  // In steps of what all of u moves by.
  EXPECT_LT(together.result().detectable_band, 1.25 * narrowest);
}

// Of the same valve in other units of u the stick band is three times as wide.
TEST(Analysis, NoCommonBandOfRecordingsThatExcludeEachOther) {
  const Recording one = joined_copies("paper-example-1", 1);
  Recording other = one;
  for (double& u : other.u) u *= 3;
  const Analysis analysis(std::vector<Recording>{one, other});
  EXPECT_EQ(analysis.result().verdict, ident::Verdict::kStiction);
  EXPECT_FALSE(analysis.result().stick_band.ascending.known);
  EXPECT_FALSE(analysis.notes().empty());
}

TEST(Analysis, ARecordingGivenTwiceCountsOnce) {
  const Recording one = joined_copies("paper-example-1", 1);
  const Recording other = joined_copies("paper-example-1", 2);
  const Analysis once(std::vector<Recording>{one, other});
  const Analysis twice(std::vector<Recording>{one, one, other});
  EXPECT_EQ(twice.pooled().nats, once.pooled().nats);
  EXPECT_EQ(twice.findings().back().recording, 2U);
  EXPECT_EQ(twice.samples(), one.size() + other.size());
  ASSERT_FALSE(twice.notes().empty());
  EXPECT_EQ(twice.notes().front(),
            "recording 2 holds the samples of recording 1 once more: it is left out");
}

TEST(Analysis, RecordingsOfTwoLoopsAreNotOneValve) {
  const Recording one = joined_copies("paper-example-1", 1);
  Recording turned = one;
  for (double& y : turned.y) y = -y;
  const Analysis analysis(std::vector<Recording>{one, turned});
  EXPECT_EQ(analysis.result().verdict, ident::Verdict::kUndecided);
  EXPECT_EQ(analysis.result().reason, ident::Reason::kWindowsDisagree);
}

TEST(Analysis, FastOscillationsAreJudgedByWindows) {
  const Recording recording = joined_copies("stiction", 60);
  ASSERT_GT(recording.size(), 8 * Identifier::kCapacity);
  int calls = 0;
  Analysis analysis(recording, [&calls](int window, int windows) {
    ++calls;
    EXPECT_GE(window, 1);
    EXPECT_LE(window, windows);
    EXPECT_LE(windows, Analysis::kMostWindows);
  });
  EXPECT_GT(calls, 0);
  EXPECT_EQ(analysis.windows(), Analysis::kMostWindows);
  EXPECT_FALSE(analysis.notes().empty());
  const Simulation s = analysis.simulate();
  EXPECT_EQ(s.u.size(), Identifier::kCapacity);
  const auto& band = analysis.result().stick_band.ascending;
  if (band.known) {
    EXPECT_LE(band.low, band.value);
    EXPECT_LE(band.value, band.high);
  }
}

TEST(Analysis, APeriodIsToldInTheTimeOfItsRecording) {
  const Recording whole = joined_copies("paper-example-1", 1);
  Recording first = whole;
  Recording slow;
  slow.name = "slow.csv";
  slow.period_s = 2 * whole.period_s;
  for (const Column column : {Column::t, Column::u, Column::y}) {
    first.values(column).resize(1200);
    for (std::size_t k = 0; k < whole.size(); k += 2) {
      slow.values(column).push_back(whole.values(column)[k]);
    }
  }
  const auto period_of = [](const Analysis& analysis) {
    return analysis.result().oscillation.period_samples * analysis.period_s();
  };
  const double alone = period_of(Analysis(slow));
  EXPECT_NEAR(period_of(Analysis(std::vector<Recording>{first, slow})), alone,
              0.1 * alone);
}

TEST(Analysis, NotesSayOfWhichPieceOfARecordingTheyAre) {
  Recording recording = joined_copies("paper-example-1", 1);
  // The second piece: y is u.
  constexpr std::size_t kFrom = 2000;
  recording.resampling.gaps = {{1900, kFrom}};
  std::copy(recording.u.begin() + kFrom, recording.u.end(), recording.y.begin() + kFrom);
  const std::vector<RecordingView> views{recording};
  const Analysis analysis(views, {}, Depth::kVerdict);
  const std::string piece = "from " + number(recording.t[kFrom]) + " to " +
                            number(recording.t.back()) + " s: y is u";
  EXPECT_EQ(std::ranges::count_if(
                analysis.notes(),
                [](const std::string& note) { return note.starts_with("from "); }),
            1);
  EXPECT_TRUE(std::ranges::any_of(analysis.notes(), [&piece](const std::string& note) {
    return note.starts_with(piece);
  }));
}

}  // namespace
}  // namespace workbench
