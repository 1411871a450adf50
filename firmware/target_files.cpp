#include "firmware/target_files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace firmware {
namespace {

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

void check(const config::Gateway& gateway, const config::Place& place,
           const std::string& path, TargetFaults& faults) {
  const auto complain = [&](std::string& lines, const std::string& message) {
    lines += (lines.empty() ? "" : "\n") +
             config::at_place(gateway, {place.line, place.key + ".path"}, message);
  };
  struct stat about {};
  if (path.ends_with('/') ||
      (stat(path.c_str(), &about) == 0 && !S_ISREG(about.st_mode))) {
    complain(faults.wrong, "expected a file, found that " + path +
                               " is a folder or a device; name a file");
    return;
  }
  const std::string folder = folder_of(path);
  if (stat(folder.c_str(), &about) != 0) {
    complain(faults.missing, "expected a folder, found that " + folder +
                                 " cannot be reached (" + std::strerror(errno) +
                                 "); create it, or name another");
  } else if (!S_ISDIR(about.st_mode)) {
    complain(faults.wrong,
             "expected a folder, found that " + folder + " is none; name another");
  } else if (access(folder.c_str(), W_OK | X_OK) != 0) {
    complain(faults.missing, "expected a folder to write into, found that " + folder +
                                 " is not (" + std::strerror(errno) +
                                 "); give the rights, or name another");
  }
}

}  // namespace

TargetFaults check_targets(const config::Gateway& gateway) {
  TargetFaults faults;
  const auto check_one = [&](const auto& target) {
    if (target) check(gateway, target->place, target->path, faults);
  };
  check_one(gateway.metrics);
  check_one(gateway.state);
  check_one(gateway.history);
  return faults;
}

}  // namespace firmware
