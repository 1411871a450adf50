#include "firmware/state_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "firmware/replace_file.hpp"
#include "hal/descriptor.hpp"

namespace firmware {

StateFile::StateFile(std::string path)
    : path_(std::move(path)), thread_([this] { work(); }) {}

StateFile::~StateFile() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool StateFile::lock() {
  const std::string beside = path_ + ".lock";
  lock_ = hal::Descriptor(open(
      beside.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600));
  // Where there can be no lock there can be no state either, which is told when it fails.
  if (!lock_.valid()) return true;
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) == 0) return true;
  lock_.reset();
  return errno != EWOULDBLOCK;
}

bool StateFile::read(std::vector<std::uint8_t>& out, bool& exists) const {
  out.clear();
  const hal::Descriptor file(open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  exists = file.valid() || errno != ENOENT;
  if (!file.valid()) return !exists;
  out.resize(wire::kMostStateBytes + 1);
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

void StateFile::set_aside() const {
  (void)std::rename(path_.c_str(), (path_ + ".bad").c_str());
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

void StateFile::finish(std::span<const std::uint8_t> image) {
  const auto idle = [this] {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return size_ == 0; });
  };
  idle();
  if (save(image)) idle();
}

std::uint32_t StateFile::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_;
}

int StateFile::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

void StateFile::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return size_ > 0 || ended_; });
    if (size_ == 0) return;
    // Nobody touches the image while size_ says that it is being written.
    lock.unlock();
    const bool good =
        replace_file(path_.c_str(), {image_.data(), size_}, Readers::kOwner, true);
    const int error = good ? 0 : errno;
    lock.lock();
    size_ = 0;
    error_ = error;
    failures_ += good ? 0 : 1;
    changed_.notify_all();
  }
}

}  // namespace firmware
