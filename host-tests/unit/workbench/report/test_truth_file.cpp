#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/report/truth_file.hpp"

namespace workbench {
namespace {

class TruthFile : public ::testing::Test {
 protected:
  std::string write(const std::string& text) {
    std::ofstream(folder_.file("truth.json")) << text;
    return folder_.file("truth.json");
  }
  std::string error_of(const std::string& text) {
    try {
      static_cast<void>(read_truth(write(text)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;
};

TEST_F(TruthFile, SaysWhereItIsWrong) {
  EXPECT_NE(error_of("{\n  \"kind\": oops}").find("truth.json:2:11: "), std::string::npos)
      << error_of("{\n  \"kind\": oops}");
  EXPECT_NE(error_of("").find("truth.json:1:1: "), std::string::npos);
  EXPECT_NE(error_of("[1]").find("simulate --truth"), std::string::npos);
  EXPECT_NE(error_of("{\"kind\":1}").find("simulate --truth"), std::string::npos);
  const KnownTruth truth = read_truth(
      write(R"({"kind":"stiction","stick_band":{"ascending":5,"descending":4},)"
            R"("slip_jump":{"ascending":3,"descending":2}})"));
  EXPECT_EQ(truth.stick_band_descending, 4);
  EXPECT_FALSE(truth.process.has_value());
}

}  // namespace
}  // namespace workbench
