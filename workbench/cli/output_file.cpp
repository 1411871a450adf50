#include "workbench/cli/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "workbench/cli/exit_code.hpp"

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

void write_file(const std::string& path, std::string_view text) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (const int error = write_all(path, "wb", text)) fail(path, std::strerror(error));
    return;
  }
  // A link keeps pointing where it points: what it points to is replaced.
  fs::path target = fs::weakly_canonical(path, ignored);
  if (target.empty()) target = path;
  const std::string temporary =
      target.string() + ".part" + std::to_string(static_cast<long>(getpid()));
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
