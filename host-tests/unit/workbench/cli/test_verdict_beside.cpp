// The verdict on the valve beside a model, as a user sees it.
#include <gtest/gtest.h>

#include <limits>

#include "support/workbench/cli_process.hpp"
#include "workbench/cli/verdict_beside.hpp"

namespace workbench {
namespace {

using nlohmann::json;

TEST(VerdictBeside, LeavesOpenWhatHasNoStemThatIdentifyFinds) {
  const auto said = [](const std::optional<cli::ValveVerdict>& verdict) {
    return cli::noise_is_left("Explained", verdict);
  };
  EXPECT_EQ(said(std::nullopt), "Explained: what is left looks like noise.");
  ident::Identification<double> found;
  found.verdict = ident::Verdict::kStiction;
  found.stick_band.ascending.value = 3.25;
  found.stick_band.descending.value = std::numeric_limits<double>::quiet_NaN();
  Model model;
  const std::string open = said(cli::beside_model(found, model, nullptr));
  EXPECT_TRUE(open.starts_with("Open: ")) << open;
  EXPECT_NE(open.find("of 3.25 in u, and the model has none"), std::string::npos) << open;
  EXPECT_EQ(cli::verdict_json(cli::beside_model(found, model, nullptr))["lacks_stem"],
            true);
  model.effects.push_back({"valve.stiction", {}});
  EXPECT_EQ(said(cli::beside_model(found, model, nullptr)), said(std::nullopt));
}

class VerdictBesideCli : public CliTest {};

TEST_F(VerdictBesideCli, IsThatOfIdentifyForAnyNumberOfThreads) {
  const std::string csv = path("loop.csv");
  const std::string m = path("m.json");
  EXPECT_EQ(run({"simulate", "stiction", "--seed", "3", "-o", csv}).code, 0);
  EXPECT_EQ(run({"model", csv, "-o", m}).code, 0);
  const json alone = only_json(run({"identify", csv, "--json"}).out);
  const Outcome one = run({"explain", csv, "--model", m, "--json", "--threads", "1"});
  const Outcome two = run({"explain", csv, "--model", m, "--json", "--threads", "2"});
  EXPECT_EQ(one.out, two.out);
  EXPECT_EQ(only_json(one.out)["identify"]["verdict"], alone["verdict"]);
}

TEST_F(VerdictBesideCli, SaysThatColumnsAreExchanged) {
  const std::string csv = path("loop.csv");
  EXPECT_EQ(run({"simulate", "stiction", "--seed", "3", "-o", csv}).code, 0);
  const Outcome said = run({"explain", csv, "--u", "y", "--y", "u"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_NE(said.out.find("exchange the columns"), std::string::npos) << said.out;
}

TEST_F(VerdictBesideCli, IsNotAskedOfAStem) {
  const std::string csv = path("loop.csv");
  const std::string m = path("m.json");
  EXPECT_EQ(run({"simulate", "stiction", "--seed", "3", "-o", csv}).code, 0);
  EXPECT_EQ(run({"model", csv, "--output", "x", "-o", m}).code, 0);
  const Outcome said = run({"explain", csv, "--model", m, "--json"});
  EXPECT_EQ(said.code, 0);
  EXPECT_TRUE(only_json(said.out)["identify"].is_null());
}

}  // namespace
}  // namespace workbench
