#include "workbench/recording/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "workbench/recording/input_error.hpp"

namespace workbench {

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  const auto fail = [&path](const std::string& found) -> InputError {
    return {path, 0, 0, "a readable file", found, "check the path and its permissions"};
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw fail("a folder");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw fail(std::string("'") + std::strerror(errno) + "'");

  std::string text;
  if (const auto size = std::filesystem::file_size(path, ignored);
      !ignored && size <= max_bytes) {
    text.reserve(static_cast<std::size_t>(size) + 1);
  }
  constexpr std::size_t kChunk = std::size_t{1} << 18;
  while (true) {
    const std::size_t before = text.size();
    text.resize(before + kChunk);
    const std::size_t got = std::fread(text.data() + before, 1, kChunk, file.get());
    text.resize(before + got);
    if (text.size() > max_bytes) {
      throw InputError(path, 0, 0, "at most " + std::to_string(max_bytes >> 20) + " MiB",
                       "a longer file", "split the recording");
    }
    if (got < kChunk) break;
  }
  if (std::ferror(file.get()) != 0) throw fail("a read error");
  return text;
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string link_target(const std::string& path) {
  std::error_code ignored;
  std::filesystem::path target = std::filesystem::weakly_canonical(path, ignored);
  // Of a link to what is not there yet that is the link.
  constexpr int kMostLinks = 40;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(target, ignored); ++i) {
    target = target.parent_path() / std::filesystem::read_symlink(target, ignored);
  }
  return target.empty() ? path : target.string();
}

}  // namespace workbench
