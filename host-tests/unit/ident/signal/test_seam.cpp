// Joined records made by hand, and what must not be taken for one.
#include <gtest/gtest.h>

#include <vector>

#include "ident/signal/seam.hpp"
#include "support/ident/pi_loop.hpp"

namespace ident {
namespace {

using test::LoopRecord;
using Signal = std::vector<double>;

LoopRecord calm(std::uint64_t seed) {
  test::PiLoop loop;
  loop.noise = 0.01;
  loop.load = 0.01;
  return test::run(loop, 400, seed);
}

// The records one behind the other, each `apart` above the one before in u and y.
LoopRecord join(const std::vector<LoopRecord>& parts, double apart) {
  LoopRecord out;
  double above = 0;
  for (const LoopRecord& part : parts) {
    for (const double v : part.u) out.u.push_back(v + above);
    for (const double v : part.y) out.y.push_back(v + above);
    above += apart;
  }
  return out;
}

Seams seams_of(const LoopRecord& record) {
  return find_seams(record.u, record.y, {});
}

TEST(Seam, IsFoundWhereTwoRecordsWereJoined) {
  const auto seams = seams_of(join({calm(1), calm(2)}, 5));
  ASSERT_EQ(seams.count, 1u);
  EXPECT_EQ(seams.at[0], 400u);
  EXPECT_EQ(seams.length, 400u);
}

TEST(Seam, UpToThreeAreFoundAndTheLongestPartIsNamed) {
  LoopRecord longer = calm(3);
  const LoopRecord more = calm(4);
  longer = join({longer, more}, 0);
  const auto seams = seams_of(join({calm(1), calm(2), longer, calm(5)}, 5));
  ASSERT_EQ(seams.count, 3u);
  EXPECT_EQ(seams.at[0], 400u);
  EXPECT_EQ(seams.at[1], 800u);
  EXPECT_EQ(seams.at[2], 1600u);
  EXPECT_EQ(seams.first, 800u);
  EXPECT_EQ(seams.length, 800u);
}

TEST(Seam, AWholeRecordHasNone) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const LoopRecord record = calm(seed);
    const auto seams = seams_of(record);
    EXPECT_EQ(seams.count, 0u);
    EXPECT_EQ(seams.length, record.u.size());
  }
}

TEST(Seam, ASpikeAndAStepOfOneSignalAreNone) {
  LoopRecord spike = calm(1);
  spike.u[200] += 5;
  spike.y[200] += 5;
  EXPECT_EQ(seams_of(spike).count, 0u);
  LoopRecord step = calm(1);
  for (std::size_t t = 200; t < step.u.size(); ++t) step.u[t] += 5;
  EXPECT_EQ(seams_of(step).count, 0u);
}

// The sensor was moved: y jumps, and the controller answers in the same sample.
TEST(Seam, AJumpThatTheControllerAnswersByItsLawIsNone) {
  test::PiLoop loop;
  loop.noise = 0.01;
  loop.load = 0.01;
  std::size_t t = 0;
  loop.sensor = [&t](double y) { return ++t > 200 ? y + 5 : y; };
  EXPECT_EQ(seams_of(test::run(loop, 400, 1)).count, 0u);
}

// y jumps and u does not move: no controller would have done that.
TEST(Seam, IsFoundWhereOnlyTheControllersLawBreaks) {
  LoopRecord record = join({calm(1), calm(2)}, 0);
  for (std::size_t t = 400; t < record.y.size(); ++t) record.y[t] += 5;
  const auto seams = seams_of(record);
  ASSERT_EQ(seams.count, 1u);
  EXPECT_EQ(seams.at[0], 400u);
}

TEST(Seam, OffsetScaleAndPrecisionDoNotMatter) {
  LoopRecord record = join({calm(1), calm(2)}, 5);
  for (double& v : record.u) v = 1e-3 * v + 7;
  for (double& v : record.y) v = -40 * v;
  EXPECT_EQ(seams_of(record).at[0], 400u);
  const Signal u = test::as<double>(test::as<float>(record.u));
  const Signal y = test::as<double>(test::as<float>(record.y));
  const auto seams = find_seams(u, y, {});
  ASSERT_EQ(seams.count, 1u);
  EXPECT_EQ(seams.at[0], 400u);
}

TEST(Seam, TooShortOrConstantRecordsHaveNone) {
  const Signal few(10, 1.0);
  const Signal many(100, 1.0);
  EXPECT_EQ(find_seams(few, few, {}).count, 0u);
  EXPECT_EQ(find_seams(many, many, {}).count, 0u);
  EXPECT_EQ(find_seams({}, {}, {}).count, 0u);
}

}  // namespace
}  // namespace ident
