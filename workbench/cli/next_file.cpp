#include "workbench/cli/next_file.hpp"

#include <cstddef>
#include <filesystem>
#include <system_error>

#include "workbench/recording/letters.hpp"

namespace workbench::cli {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

}  // namespace

std::string next_file(const std::string& path) {
  std::error_code ignored;
  const bool is_file = !is_there(path) || fs::is_regular_file(path, ignored);
  if (path.empty() || !is_file)
    return is_there("m.json") ? next_file("m.json") : "m.json";
  const fs::path file(path);
  std::string stem = file.stem().string();
  std::size_t digits = 0;
  while (digits < stem.size() && is_digit(stem[stem.size() - digits - 1])) ++digits;
  int number = 2;
  if (digits == 1 && stem.size() > 1) {  // more are a year or the number of a loop
    number = stem.back() - '0' + 1;
    stem.pop_back();
  } else if (digits > 0) {
    stem += '-';
  }
  for (;; ++number) {
    const fs::path next =
        file.parent_path() / (stem + std::to_string(number) + file.extension().string());
    if (!is_there(next)) return next.string();
  }
}

}  // namespace workbench::cli
