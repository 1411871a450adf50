// Big-endian numbers one after the other, into and out of a buffer that is large enough:
// who calls has counted the bytes. Constant time a number; no heap.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/big_endian.hpp"

namespace wire {

class ByteWriter {
 public:
  explicit ByteWriter(std::span<std::uint8_t> out) : out_(out) {}

  /// The low `bytes` (1 … 8) of `value`; of a negative one in two's complement.
  void number(std::uint64_t value, std::size_t bytes) {
    put_big_endian(value, out_.subspan(at_, bytes));
    at_ += bytes;
  }
  /// IEEE 754 single precision; every NaN is the same.
  void single(double value) {
    constexpr std::uint32_t kNaN = 0x7FC00000;
    number(std::isnan(value) ? kNaN
                             : std::bit_cast<std::uint32_t>(static_cast<float>(value)),
           4);
  }
  void bytes(std::span<const std::uint8_t> data) {
    std::copy(data.begin(), data.end(), out_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ += data.size();
  }
  [[nodiscard]] std::size_t size() const { return at_; }

 private:
  std::span<std::uint8_t> out_;
  std::size_t at_ = 0;
};

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> data) : data_(data) {}

  [[nodiscard]] std::uint64_t number(std::size_t count) {
    return get_big_endian(bytes(count));
  }
  [[nodiscard]] float single() {
    return std::bit_cast<float>(static_cast<std::uint32_t>(number(4)));
  }
  [[nodiscard]] std::span<const std::uint8_t> bytes(std::size_t count) {
    at_ += count;
    return data_.subspan(at_ - count, count);
  }

 private:
  std::span<const std::uint8_t> data_;
  std::size_t at_ = 0;
};

}  // namespace wire
