// The unit tests of the instrumented copy. MUTANT: the number of the mutant that is on;
// REACHED: a file that gets a line a test, its name, source, milliseconds and the points
// that ran in it, tab-separated; the first line is what ran before all tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "mutant.hpp"

namespace {

[[gnu::constructor(101)]] void choose() {
  if (const char* const number = std::getenv("MUTANT")) {
    mutant::active = std::atoi(number);
  }
}

class Reach final : public testing::EmptyTestEventListener {
 public:
  explicit Reach(const char* file) : out_(file) {}

 private:
  void OnTestProgramStart(const testing::UnitTest&) override { write("", "", 0); }
  void OnTestEnd(const testing::TestInfo& test) override {
    const std::string name = std::string(test.test_suite_name()) + "." + test.name();
    write(name, test.file(), test.result()->elapsed_time());
  }
  void write(const std::string& name, const std::string& file, long ms) {
    out_ << name << '\t' << file << '\t' << ms << '\t';
    for (int point = 0; point < mutant::kMost; ++point) {
      if (mutant::reached[point]) out_ << point << ' ';
    }
    out_ << '\n';
    std::fill(std::begin(mutant::reached), std::end(mutant::reached), 0);
  }

  std::ofstream out_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (const char* const file = std::getenv("REACHED")) {
    testing::UnitTest::GetInstance()->listeners().Append(new Reach(file));
  }
  return RUN_ALL_TESTS();
}
