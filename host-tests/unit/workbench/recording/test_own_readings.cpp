#include <gtest/gtest.h>

#include <cmath>

#include "workbench/recording/own_readings.hpp"

namespace workbench {
namespace {

class OwnReadings : public testing::Test {
 protected:
  OwnReadings() {
    double sum = 0;
    for (int k = 0; k < 300; ++k) {
      const double t = 0.1 * k;
      recording.t.push_back(t);
      recording.u.push_back(std::sin(t) + 0.1 * std::sin(37 * t * t));
      recording.y.push_back(std::cos(0.7 * t) + 0.1 * std::sin(17 * t * t));
      recording.sp.push_back(k < 150 ? 0 : 1);
      const double error = recording.sp.back() - recording.y.back();
      const double before = k > 0 ? recording.sp[k - 1] - recording.y[k - 1] : error;
      sum += 0.2 * error;
      add("ratio", 1.3 * recording.u.back() + 4);
      add("P", 1.5 * error);
      add("I", sum);
      add("D", 3 * (error - before));
      add("feed", std::cos(0.7 * t + 0.3));
      add("rest", 7);
    }
  }
  void add(const std::string& name, double value) {
    for (Load& load : recording.loads) {
      if (load.name == name) return load.values.push_back(value);
    }
    recording.loads.push_back({name, "", {value}});
  }
  std::vector<std::string> left() const {
    std::vector<std::string> out;
    for (const Load& load : recording.loads) out.push_back(load.name);
    return out;
  }

  Recording recording;
};

TEST_F(OwnReadings, AreNoLoads) {
  leave_out_own_readings(recording);
  EXPECT_EQ(left(), (std::vector<std::string>{"feed", "rest"}));
  ASSERT_EQ(recording.resampling.notes.size(), 4U);
  EXPECT_NE(recording.resampling.notes[1].find("column P is made of"), std::string::npos);
}

TEST_F(OwnReadings, StayWhereTheyAreNeeded) {
  const std::vector<std::string> needed = {"P"};
  EXPECT_EQ(take_out_own_readings(recording, needed),
            (std::vector<std::string>{"ratio", "I", "D"}));
}

TEST_F(OwnReadings, NeedNoSetpoint) {
  recording.sp.clear();
  EXPECT_EQ(take_out_own_readings(recording), (std::vector<std::string>{"ratio"}));
}

}  // namespace
}  // namespace workbench
