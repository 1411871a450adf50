#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/can/candump_log.hpp"

namespace workbench {
namespace {

std::string said_of(const std::string& dbc, const std::vector<Column>& missing) {
  TemporaryFolder folder;
  const std::string path = folder.file("p.dbc");
  std::ofstream(path) << dbc << std::flush;
  std::string said = missing_dbc_signals(path, missing);
  return said.replace(said.find(path), path.size(), "p.dbc");
}

TEST(DbcSignals, AreListedWithThoseThatAreMeant) {
  const std::string text =
      "BO_ 1 LoopOP: 2 X\n SG_ OP : 0|8@1+ (1,0) [0|0] \"\" X\n"
      "BO_ 2 LoopPV: 2 X\n SG_ PV : 0|8@1+ (1,0) [0|0] \"\" X\n";
  EXPECT_EQ(said_of(text, {Column::u, Column::y}),
            "--dbc needs --u MESSAGE.SIGNAL and --y MESSAGE.SIGNAL: p.dbc has the "
            "signals 'LoopOP.OP' 'LoopPV.PV'; add --u LoopOP.OP --y LoopPV.PV");
  EXPECT_EQ(said_of(text, {Column::y}),
            "--dbc needs --y MESSAGE.SIGNAL: p.dbc has the signals 'LoopOP.OP' "
            "'LoopPV.PV'; add --y LoopPV.PV");
}

TEST(DbcSignals, WhoseNamesSayNothingAreOnlyListed) {
  EXPECT_EQ(said_of("BO_ 1 M: 2 X\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" X\n", {Column::u}),
            "--dbc needs --u MESSAGE.SIGNAL: p.dbc has the signals 'M.A'");
  EXPECT_EQ(said_of("BO_ 1 M: 2 X\n", {Column::u}),
            "--dbc needs --u MESSAGE.SIGNAL: p.dbc has no signals");
  EXPECT_EQ(missing_dbc_signals("/no/such.dbc", {Column::u}),
            "--dbc needs --u MESSAGE.SIGNAL");
}

}  // namespace
}  // namespace workbench
