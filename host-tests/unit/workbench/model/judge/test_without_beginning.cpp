#include <gtest/gtest.h>

#include <cmath>

#include "workbench/model/judge/without_beginning.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

constexpr std::size_t kSamples = 200;

Blocks all_fitted() {
  const std::vector<Piece> pieces = {{0, kSamples, "a", 0, false},
                                     {kSamples, kSamples + 60, "b", 0, true}};
  return Blocks(pieces, 1);
}

TEST(WithoutBeginning, BeginsWithATwentiethOfEachPieceThatIsFitted) {
  const Blocks blocks = all_fitted();
  const std::vector<Piece> pieces = {{0, 40, "a", 0, false},
                                     {40, kSamples, "a", 0, false}};
  const std::vector<SampleRange> begun = beginnings(pieces, blocks);
  ASSERT_EQ(begun.size(), 2U);
  EXPECT_EQ(begun[0].last, 5U);
  EXPECT_EQ(begun[1].first, 40U);
  EXPECT_EQ(begun[1].last, 48U);
}

// One column and what it does not explain.
struct Line {
  Values column = Values(kSamples + 60);
  Values y = Values(kSamples + 60);
  [[nodiscard]] double coefficient(std::size_t from) const {
    double top = 0;
    double bottom = 0;
    for (std::size_t k = from; k < kSamples; ++k) {
      top += column[k] * y[k];
      bottom += column[k] * column[k];
    }
    return top / bottom;
  }
  [[nodiscard]] Values residual() const {
    Values out(y.size());
    for (std::size_t k = 0; k < kSamples; ++k) out[k] = y[k] - coefficient(0) * column[k];
    return out;
  }
};

TEST(WithoutBeginning, KnowsWhatALinearFitWouldBe) {
  Line line;
  for (std::size_t k = 0; k < kSamples; ++k) {
    line.column[k] = k < 10 ? 10 : std::sin(0.3 * static_cast<double>(k));
    line.y[k] = (k < 10 ? -0.5 : 2) * line.column[k];
  }
  Values falls = line.column;  // of the residual
  for (double& value : falls) value = -value;
  const WithoutBeginning rest({falls}, line.residual(), all_fitted(),
                              std::vector<SampleRange>{{0, 10}});
  EXPECT_NEAR(line.coefficient(0) + rest.moved[0], 2, 1e-9);
  EXPECT_GT(rest.variance[0], 5);
  EXPECT_NEAR(rest.noise, 0, 1e-9);
  EXPECT_GT(rest.minding(0.1, 0), 1.5) << "it hangs on its beginning";
}

TEST(WithoutBeginning, ChanceWidensNothing) {
  Line line;
  for (std::size_t k = 0; k < kSamples; ++k) {
    line.column[k] = k < 10 ? 3 : std::sin(0.3 * static_cast<double>(k));
    line.y[k] = 2 * line.column[k] + std::sin(37.0 * static_cast<double>(k * k));
  }
  Values falls = line.column;
  for (double& value : falls) value = -value;
  const WithoutBeginning rest({falls}, line.residual(), all_fitted(),
                              std::vector<SampleRange>{{0, 10}});
  EXPECT_NEAR(rest.noise, 1, 0.2);
  EXPECT_EQ(rest.minding(0.1, 0), 0.1);
}

}  // namespace
}  // namespace workbench
