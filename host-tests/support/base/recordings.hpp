// The external recordings: whether one can be tested on.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace test {

/// Empty if the file is there and its first line is one of a table; else why a test that
/// needs it is skipped. It looks at the text alone, without the reader that is tested.
inline std::string why_unusable(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) {
    return "the recording is absent: " + file.filename().string();
  }
  std::string header;
  std::getline(in, header);
  if (header.find_first_of(",;\t") == std::string::npos) {
    return "the recording is not a table any more: " + file.filename().string();
  }
  return {};
}

}  // namespace test
