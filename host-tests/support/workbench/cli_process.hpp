// Runs the program under test as a user does: arguments in, exit code and texts out.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/base/temporary_folder.hpp"

namespace workbench {

struct Outcome {
  int code = -1;  ///< exit code; -1 if it did not exit by itself
  std::string out;
  std::string err;
};

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A folder of its own for each test, removed at the end.
class CliTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return folder_.file(name);
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  /// stdout goes to `out_path` instead, if given.
  [[nodiscard]] Outcome run(std::vector<std::string> arguments,
                            const std::string& out_path = "") const {
    const std::string out = out_path.empty() ? path("stdout") : out_path;
    const std::string err = path("stderr");
    arguments.insert(arguments.begin(), STICKBAND_BIN);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      dup2(out_file, STDOUT_FILENO);
      dup2(err_file, STDERR_FILENO);
      execv(argv[0], argv.data());
      _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (out_path.empty()) outcome.out = content_of(out);
    outcome.err = content_of(err);
    return outcome;
  }
  /// The recording of a scenario as CSV; returns its path.
  [[nodiscard]] std::string simulated(const std::string& scenario,
                                      const std::string& seed) const {
    const std::string csv = path(scenario + seed + ".csv");
    const Outcome made = run({"simulate", scenario, "--seed", seed, "-o", csv});
    EXPECT_EQ(made.code, 0) << made.err;
    return csv;
  }

 private:
  TemporaryFolder folder_;
};

/// The one JSON object that is all of `text`.
inline nlohmann::json only_json(const std::string& text) {
  EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  EXPECT_TRUE(json.is_object()) << text;
  return json;
}

}  // namespace workbench
