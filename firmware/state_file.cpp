#include "firmware/state_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <utility>

#include "firmware/replace_file.hpp"
#include "hal/descriptor.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"

namespace firmware {

namespace {

bool read_file(const std::string& path, std::size_t most, std::vector<std::uint8_t>& out,
               bool& exists) {
  out.clear();
  const hal::Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  exists = file.valid() || errno != ENOENT;
  if (!file.valid()) return !exists;
  out.resize(most + 1);
  std::size_t size = 0;
  while (size < out.size()) {
    const ssize_t count = ::read(file.get(), out.data() + size, out.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  out.resize(size);
  return true;
}

void set_file_aside(const std::string& path) {
  (void)std::rename(path.c_str(), (path + ".bad").c_str());
}

}  // namespace

StateFile::StateFile(std::string path, std::size_t windows)
    : path_(std::move(path)),
      windows_path_(path_ + ".windows"),
      windows_(windows),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

bool StateFile::lock() {
  const std::string beside = path_ + ".lock";
  lock_ = hal::Descriptor(open(
      beside.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600));
  // Where there can be no lock there can be no state either, which is told when it fails.
  if (!lock_.valid()) return true;
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) == 0) {
    for (const std::string& path : {path_, windows_path_}) {
      (void)unlink((path + ".new").c_str());
    }
    return true;
  }
  lock_.reset();
  return errno != EWOULDBLOCK;
}

bool StateFile::read(std::vector<std::uint8_t>& out, bool& exists) const {
  return read_file(path_, wire::kMostStateBytes, out, exists);
}

bool StateFile::read_windows(std::vector<std::uint8_t>& out, bool& exists) const {
  return read_file(windows_path_, windows_.size(), out, exists);
}

void StateFile::set_aside() const {
  set_file_aside(path_);
}

void StateFile::set_windows_aside() const {
  set_file_aside(windows_path_);
}

bool StateFile::save(std::span<const std::uint8_t> image) {
  {
    const std::lock_guard lock(mutex_);
    if (size_ > 0 || image.empty() || image.size() > image_.size()) return false;
    std::copy(image.begin(), image.end(), image_.begin());
    size_ = image.size();
  }
  changed_.notify_all();
  return true;
}

std::span<std::uint8_t> StateFile::room_for_windows() {
  const std::lock_guard lock(mutex_);
  return windows_size_ == 0 ? std::span(windows_) : std::span<std::uint8_t>();
}

void StateFile::save_windows(std::size_t size) {
  {
    const std::lock_guard lock(mutex_);
    windows_size_ = size;
  }
  changed_.notify_all();
}

bool StateFile::saving() const {
  const std::lock_guard lock(mutex_);
  return size_ > 0;
}

void StateFile::settle() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return size_ == 0 && windows_size_ == 0; });
}

std::uint32_t StateFile::writes() const {
  const std::lock_guard lock(mutex_);
  return writes_;
}

std::uint32_t StateFile::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_;
}

int StateFile::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

std::size_t StateFile::add_checksum(std::size_t size) {
  const auto content = std::span(windows_).first(size);
  wire::put_big_endian(wire::crc32(content),
                       std::span(windows_).subspan(size, wire::kChecksumBytes));
  return size + wire::kChecksumBytes;
}

void StateFile::work(const std::stop_token& stop) {
  const auto write = [](const std::string& path, const void* data, std::size_t size) {
    const std::string_view bytes(static_cast<const char*>(data), size);
    return replace_file(path.c_str(), bytes, Readers::kOwner, true) ? 0 : errno;
  };
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, stop, [this] { return size_ > 0 || windows_size_ > 0; });
    if (size_ == 0 && windows_size_ == 0) return;
    // Nobody touches an image while its size says that it is being written.
    const bool state = size_ > 0;
    const std::size_t size = state ? size_ : windows_size_;
    lock.unlock();
    const int error = state ? write(path_, image_.data(), size)
                            : write(windows_path_, windows_.data(), add_checksum(size));
    lock.lock();
    (state ? size_ : windows_size_) = 0;
    ++writes_;
    if (error != 0) {
      error_ = error;
      ++failures_;
    }
    changed_.notify_all();
  }
}

}  // namespace firmware
