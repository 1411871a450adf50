#include "workbench/cli/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "workbench/cli/exit_code.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const char* why) {
  throw OutputError("cannot write " + path + ": " + why);
}

// Returns 0 or the error number.
int write_all(const std::string& path, const char* mode, std::string_view text) {
  std::FILE* file = std::fopen(path.c_str(), mode);
  if (file == nullptr) return errno;
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int error = written ? 0 : errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  return error == 0 && !written ? EIO : error;
}

}  // namespace

void expect_writable(const std::string& path) {
  if (path.empty()) return;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) return;
  const fs::path folder = fs::absolute(link_target(path), ignored).parent_path();
  if (!fs::exists(folder, ignored)) {
    fail(path, "its folder is not there; make it first");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) fail(path, std::strerror(errno));
}

void write_file(const std::string& path, std::string_view text) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (const int error = write_all(path, "wb", text)) fail(path, std::strerror(error));
    return;
  }
  const std::string target = link_target(path);
  const std::string temporary =
      target + ".part" + std::to_string(static_cast<long>(getpid()));
  if (const int error = write_all(temporary, "wbx", text)) {
    if (error != EEXIST) std::remove(temporary.c_str());
    fail(path, std::strerror(error));
  }
  if (fs::exists(status)) fs::permissions(temporary, status.permissions(), ignored);
  if (std::rename(temporary.c_str(), target.c_str()) != 0) {
    const int error = errno;
    std::remove(temporary.c_str());
    fail(path, std::strerror(error));
  }
}

}  // namespace workbench::cli
