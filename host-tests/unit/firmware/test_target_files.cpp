#include <gtest/gtest.h>

#include <fstream>

#include "firmware/target_files.hpp"
#include "support/base/temporary_folder.hpp"

namespace firmware {
namespace {

TargetFaults faults_of(const std::string& textfile, const std::string& state) {
  config::Gateway gateway;
  gateway.file = "g.toml";
  gateway.metrics = config::Metrics{textfile, 15, {3, "metrics"}};
  gateway.state = config::State{state, 10, {7, "state"}};
  return check_targets(gateway);
}

TEST(TargetFiles, NamesWhatStandsInTheWay) {
  const TemporaryFolder own;
  std::ofstream(own.file("file")) << "x";
  const TargetFaults none = faults_of(own.file("a.prom"), own.file("file"));
  EXPECT_EQ(none.wrong + none.missing, "");
  const TargetFaults folder = faults_of(own.path(), own.file("state"));
  EXPECT_NE(folder.wrong.find("g.toml:3: metrics.path: expected a file"),
            std::string::npos)
      << folder.wrong;
  const TargetFaults missing =
      faults_of(own.path() + "/none/a.prom", own.path() + "/none/state");
  EXPECT_EQ(missing.wrong, "");
  EXPECT_NE(missing.missing.find("g.toml:3: metrics.path: expected a folder"),
            std::string::npos)
      << missing.missing;
  EXPECT_NE(missing.missing.find("\ng.toml:7: state.path"), std::string::npos);
  EXPECT_NE(faults_of(own.file("a.prom"), own.file("file") + "/state").wrong +
                faults_of(own.file("a.prom"), own.file("file") + "/state").missing,
            "");
}

}  // namespace
}  // namespace firmware
