#include "firmware/replace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "hal/descriptor.hpp"

namespace firmware {
namespace {

// Until the disk has the new name, too: without it a power cut may bring the old file
// back. Some file systems cannot.
void wait_for_folder(const char* path) {
  std::array<char, 4096> folder;
  const char* const slash = std::strrchr(path, '/');
  const int length = slash == nullptr ? 1 : std::max(static_cast<int>(slash - path), 1);
  std::snprintf(folder.data(), folder.size(), "%.*s", length,
                slash == nullptr ? "." : path);
  const hal::Descriptor opened(open(folder.data(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.valid()) (void)fsync(opened.get());
}

}  // namespace

bool replace_file(const char* path, std::string_view text, Readers readers,
                  bool durable) {
  std::array<char, 4096> beside;
  const int length = std::snprintf(beside.data(), beside.size(), "%s.new", path);
  if (length < 0 || static_cast<std::size_t>(length) >= beside.size()) {
    errno = ENAMETOOLONG;
    return false;
  }
  if (unlink(beside.data()) < 0 && errno != ENOENT) return false;
  hal::Descriptor file(
      open(beside.data(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!file.valid()) return false;
  bool good = readers == Readers::kOwner || fchmod(file.get(), 0644) == 0;
  while (good && !text.empty()) {
    const ssize_t written = write(file.get(), text.data(), text.size());
    good = written > 0 || (written < 0 && errno == EINTR);
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  good = good && (!durable || fsync(file.get()) == 0);
  file.reset();
  if (good && std::rename(beside.data(), path) == 0) {
    if (durable) wait_for_folder(path);
    return true;
  }
  const int error = errno;
  unlink(beside.data());
  errno = error;
  return false;
}

}  // namespace firmware
