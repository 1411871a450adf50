// A UDS response under construction: appends, and remembers what did not fit.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/big_endian.hpp"

namespace wire {

class UdsReply {
 public:
  explicit UdsReply(std::span<std::uint8_t> storage) : storage_(storage) {}

  /// Big-endian, `bytes` 1 … 8.
  void number(std::uint64_t value, std::size_t bytes) {
    if (const auto room = take(bytes); !room.empty()) put_big_endian(value, room);
  }
  void bytes(std::span<const std::uint8_t> data) {
    const auto room = take(data.size());
    if (!room.empty()) std::copy(data.begin(), data.end(), room.begin());
  }
  /// The next `bytes` bytes for the caller to fill; empty when they do not fit.
  [[nodiscard]] std::span<std::uint8_t> take(std::size_t bytes) {
    if (overflow_ || bytes > storage_.size() - size_) {
      overflow_ = true;
      return {};
    }
    size_ += bytes;
    return storage_.subspan(size_ - bytes, bytes);
  }
  /// What is left of the storage.
  [[nodiscard]] std::span<std::uint8_t> room() const { return storage_.subspan(size_); }

  [[nodiscard]] bool overflow() const { return overflow_; }
  [[nodiscard]] std::span<const std::uint8_t> data() const {
    return storage_.first(size_);
  }

 private:
  std::span<std::uint8_t> storage_;
  std::size_t size_ = 0;
  bool overflow_ = false;
};

}  // namespace wire
