// SHA-256 (FIPS 180-4) and HMAC-SHA-256 (RFC 2104) for the diagnostic key, and a
// comparison whose time does not tell where two strings differ.
//
// No heap, clock or exceptions. Cost: linear in the message; stack about 400 bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wire {

using Sha256Digest = std::array<std::uint8_t, 32>;

class Sha256 {
 public:
  /// The digest of everything passed to add() is that of one message.
  void add(std::span<const std::uint8_t> data);
  /// Ends the message; the object is not used again.
  [[nodiscard]] Sha256Digest digest();

 private:
  static constexpr std::size_t kBlock = 64;
  void compress();

  std::array<std::uint32_t, 8> state_ = {0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A,
                                         0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19};
  std::array<std::uint8_t, kBlock> block_{};
  std::size_t filled_ = 0;
  std::uint64_t bytes_ = 0;
};

[[nodiscard]] Sha256Digest hmac_sha256(std::span<const std::uint8_t> key,
                                       std::span<const std::uint8_t> message);

/// Lengths may be compared in the open, contents are not.
[[nodiscard]] bool equal_in_constant_time(std::span<const std::uint8_t> a,
                                          std::span<const std::uint8_t> b);

}  // namespace wire
