// What is said about columns that nobody asked for.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/workbench/cli_process.hpp"
#include "support/workbench/setpoint_loop.hpp"
#include "workbench/cli/unused_columns.hpp"

namespace workbench::cli {
namespace {

TEST(UnusedColumns, AreNamedWithTheOptionThatTriesThem) {
  EXPECT_EQ(note_on_unused({}), "");
  EXPECT_EQ(
      note_on_unused({{"feed"}, {}}),
      "column not used: feed; --load feed tries it as a load that moves the output, if "
      "it is a cause and no other reading of the output");
  const std::string many = note_on_unused({{"a", "b", "c", "d"}, {}});
  EXPECT_NE(many.find("a, b, c and 1 more; --load COLUMN "), std::string::npos) << many;
  EXPECT_NE(many.find("--load all"), std::string::npos);
  const std::string helped = note_on_unused({{"a", "b"}, HelpfulLoad{"b", 0.34}});
  EXPECT_NE(helped.find("as a load b would take away 34 % of"), std::string::npos);
  EXPECT_NE(helped.find("--load b,"), std::string::npos);
  const std::string all = note_on_unused({{"b"}, HelpfulLoad{"b", 0.9996}});
  EXPECT_NE(all.find("would take away 100 % of"), std::string::npos) << all;
}

TEST(UnusedColumns, AreThoseThatMayBeALoad) {
  ReadRecordings read;
  read.unused = {{"spare", "", {4, 4, 4}}, {"T1 Setpoint (°C)", "", {1, 2, 3}}};
  EXPECT_TRUE(complain_about_unused(read, Model()).names.empty());
}

class UnusedColumnsCli : public CliTest {};

// What nobody asked for changes nothing: rows without it stay.
TEST_F(UnusedColumnsCli, AreReadBesideTheLoop) {
  RecordingSource source;
  for (const char* first : {"7", ""}) {
    std::string text = "t,u,y,feed\n0,50,60," + std::string(first) + '\n';
    for (int k = 1; k < 30; ++k) {
      text += std::to_string(k) + ',' + std::to_string(50 + k % 7) + ',' +
              std::to_string(60 + k % 5) + ',' + std::to_string(k % 3) + '\n';
    }
    source.path = write("few.csv", text);
    const Recording plain = read_recording(source);
    const Recording beside = read_with_unused(source);
    EXPECT_EQ(beside.t, plain.t);
    EXPECT_EQ(beside.u, plain.u);
    EXPECT_EQ(beside.resampling.notes, plain.resampling.notes);
    ASSERT_EQ(beside.loads.size(), 1U);
    EXPECT_EQ(beside.loads[0].values.size(), plain.size());
    std::vector<Recording> fitted = {beside};
    std::vector<Load> unused;
    EXPECT_TRUE(joined_beside(fitted, {}, unused).loads.empty());
    EXPECT_TRUE(fitted[0].loads.empty());
    ASSERT_EQ(unused.size(), 1U);
    EXPECT_EQ(unused[0].name, "feed");
  }
}

TEST_F(UnusedColumnsCli, IsSaidOnceAndOnlyWhereNoneWasAskedFor) {
  const Recording r = test::simulated({});
  std::string text = "t,u,y,feed\n";
  for (std::size_t k = 0; k < r.size(); ++k) {
    text += std::to_string(r.t[k]) + ',' + std::to_string(r.u[k]) + ',' +
            std::to_string(r.y[k]) + ',' + std::to_string(k / 100 % 2) + '\n';
  }
  const std::string csv = write("feed.csv", text);
  const std::string note = "--load feed";
  EXPECT_NE(run({"model", csv}).err.find(note), std::string::npos);
  EXPECT_EQ(run({"model", csv, "--load", "feed"}).err.find(note), std::string::npos);
}

// A load that stays below what a second lag leaves.
TEST_F(UnusedColumnsCli, MayHelpOnlyBehindAnotherEffect) {
  std::string text = "t,u,y,amb\n";
  double first = 0;
  double second = 0;
  for (int k = 0; k < 600; ++k) {
    const double u = k / 75 % 2;
    const double amb = (k * 37 % 101 + k * 53 % 89) / 190.0;
    first += (u - first) / 20;
    second += (first - second) / 12;
    text += std::to_string(k) + ',' + std::to_string(u) + ',' +
            std::to_string(second + 0.1 * amb) + ',' + std::to_string(amb) + '\n';
  }
  const Outcome said = run({"explain", write("amb.csv", text), "--json"});
  EXPECT_NE(said.err.find("as a load amb would take away"), std::string::npos)
      << said.err;
}

}  // namespace
}  // namespace workbench::cli
