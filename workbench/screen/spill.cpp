#include "workbench/screen/spill.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace workbench {
namespace {

constexpr std::size_t kLeastBuffer = 4096;
constexpr std::size_t kMostBuffer = std::size_t{1} << 20;

[[noreturn]] void fail(const std::string& folder, const char* what) {
  throw std::runtime_error("temporary file in " + folder + ": " + what +
                           "; --scratch FOLDER names another folder");
}

}  // namespace

Spill::Spill(const std::string& folder, std::size_t memory)
    : memory_(memory),
      folder_(folder.empty() ? std::filesystem::temp_directory_path().string() : folder) {
  std::string name = folder_ + "/stickband-screen-XXXXXX";
  file_ = mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) fail(folder_, std::strerror(errno));
  unlink(name.c_str());
}

Spill::~Spill() {
  close(file_);
}

std::size_t Spill::add_stream() {
  streams_.emplace_back();
  return streams_.size() - 1;
}

void Spill::flush(Stream& stream) {
  if (stream.buffer.empty()) return;
  const Extent extent{end_, stream.buffer.size()};
  std::size_t done = 0;
  while (done < stream.buffer.size()) {
    const ssize_t written =
        pwrite(file_, stream.buffer.data() + done, stream.buffer.size() - done,
               static_cast<off_t>(end_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(folder_, std::strerror(errno));
    done += static_cast<std::size_t>(written);
  }
  end_ += extent.bytes;
  stream.extents.push_back(extent);
  stream.buffer.clear();
}

void Spill::flush_full() {
  const std::size_t share = memory_ / std::max<std::size_t>(streams_.size(), 1);
  const std::size_t limit = std::clamp(share, kLeastBuffer, kMostBuffer);
  for (Stream& stream : streams_) {
    if (stream.buffer.size() >= limit) flush(stream);
  }
}

void Spill::finish() {
  for (Stream& stream : streams_) {
    flush(stream);
    std::string().swap(stream.buffer);
  }
}

std::uint64_t Spill::size(std::size_t stream) const {
  std::uint64_t bytes = streams_[stream].buffer.size();
  for (const Extent& extent : streams_[stream].extents) bytes += extent.bytes;
  return bytes;
}

std::string Spill::text(std::size_t stream) const {
  std::string out;
  out.resize(size(stream));
  std::size_t filled = 0;
  for (const Extent& extent : streams_[stream].extents) {
    std::size_t done = 0;
    while (done < extent.bytes) {
      const ssize_t got = pread(file_, out.data() + filled + done, extent.bytes - done,
                                static_cast<off_t>(extent.at + done));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) fail(folder_, got < 0 ? std::strerror(errno) : "cut off");
      done += static_cast<std::size_t>(got);
    }
    filled += extent.bytes;
  }
  return out;
}

}  // namespace workbench
