// The identifier on the external recordings and on a fixed list of simulated ones: what
// was reached stays reached.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "ident/identifier.hpp"
#include "support/base/recordings.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using ident::Verdict;

class Recordings : public testing::Test {
 protected:
  // The labels of a folder of recordings; skips the test where it is absent.
  void open(const char* name) {
    folder_ = std::filesystem::path(STICKBAND_RECORDINGS) / name;
    if (!std::filesystem::exists(folder_ / "labels.json")) {
      GTEST_SKIP() << "the recordings are absent: " << name;
    }
    std::ifstream file(folder_ / "labels.json");
    labels = nlohmann::json::parse(file);
    ASSERT_FALSE(labels.empty());
  }

  [[nodiscard]] std::string why_unusable(const std::string& name) const {
    return test::why_unusable(folder_ / (name + ".csv"));
  }
  [[nodiscard]] Verdict verdict(const std::string& name) const {
    const auto recording = workbench::read_csv((folder_ / (name + ".csv")).string());
    return workbench::Analysis(recording).result().verdict;
  }

  nlohmann::json labels;

 private:
  std::filesystem::path folder_;
};

TEST_F(Recordings, OfTheStictionDataBaseAreRightIn11Of12) {
  open("isdb");
  if (IsSkipped()) {
    return;
  }
  int count = 0;
  int mistakes = 0;
  std::string wrong;
  std::string missing;
  for (const auto& [name, label] : labels.items()) {
    if (!label["stiction"].is_boolean()) {
      continue;
    }
    ++count;
    if (const std::string why = why_unusable(name); !why.empty()) {
      missing += why + ' ';
      continue;
    }
    const Verdict found = verdict(name);
    if ((found == Verdict::kStiction) != label["stiction"].get<bool>()) {
      ++mistakes;
      wrong += ' ' + name + " is " + std::string(ident::name(found));
    }
  }
  EXPECT_EQ(count, 12);
  EXPECT_LE(mistakes, 1) << "wrong:" << wrong;
  if (!missing.empty()) {
    GTEST_SKIP() << missing;
  }
}

TEST_F(Recordings, OfPlantLoopsWithoutStictionAreNotCalledStickingByAMajority) {
  open("plant");
  if (IsSkipped()) {
    return;
  }
  struct Loop {
    int windows = 0;
    int sticking = 0;
  };
  std::map<std::string, Loop> loops;
  for (const auto& [name, label] : labels.items()) {
    if (!label["stiction"].get<bool>()) {
      Loop& loop = loops[label["loop"].get<std::string>()];
      ++loop.windows;
      loop.sticking += verdict(name) == Verdict::kStiction ? 1 : 0;
    }
  }
  EXPECT_GE(loops.size(), 10u);
  for (const auto& [name, loop] : loops) {
    EXPECT_LE(2 * loop.sticking, loop.windows) << name;
  }
}

TEST_F(Recordings, OfSacacWithAnotherCauseAreNotCalledSticking) {
  open("sacac");
  if (IsSkipped()) {
    return;
  }
  int others = 0;
  for (const auto& [name, label] : labels.items()) {
    if (label["cause"].get<std::string>() != "stiction") {
      ++others;
      EXPECT_NE(ident::name(verdict(name)), ident::name(Verdict::kStiction)) << name;
    }
  }
  EXPECT_EQ(others, 4);
}

// A fault, sticking or play, is a false alarm alike.
TEST(SimulatedRecordings, Of40HealthyLoopsRaiseAtMostOneFalseAlarm) {
  const char* const scenarios[] = {"external-sinusoid",  "tight-tuning",  "random-load",
                                   "setpoint",           "healthy",       "quantised",
                                   "healthy-positioner", "load-and-noise"};
  constexpr std::uint64_t kSeeds = 5;
  const auto identifier = std::make_unique<workbench::Identifier>();
  int loops = 0;
  int alarms = 0;
  std::string which;
  for (const char* scenario : scenarios) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const auto loop = *workbench::simulate(scenario, seed);
      const Verdict found = identifier->run(loop.u, loop.y, loop.sp).verdict;
      ++loops;
      if (found == Verdict::kStiction || found == Verdict::kBacklash) {
        ++alarms;
        which += std::string(" ") + scenario + ' ' + std::to_string(seed) + " is " +
                 std::string(ident::name(found));
      }
    }
  }
  EXPECT_EQ(loops, 40);
  EXPECT_LE(alarms, 1) << "false alarms:" << which;
}

}  // namespace
