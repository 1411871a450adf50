// The bytes of the loops' windows of samples, which go on after a restart.
//
// Header, big-endian: "SBWI", version u8 = 1, loops u8, offset i64: µs since the epoch
// less the clock of the samples, as it was when this was written. For each loop its mark:
// tag (32 bytes, zero-padded), CRC-32 of the configuration u32, end of the newest window
// that was judged i64 ms since the epoch (0: none), samples that the evidence does not
// know yet u32; then the window as it is uploaded (recording_image.hpp). At the end the
// CRC-32 of all before it. No heap, clock or exceptions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/crc32.hpp"
#include "wire/diagnostics.hpp"
#include "wire/recording_image.hpp"
#include "wire/state_image.hpp"

namespace wire {

/// Whose window it is, and what has been made of it.
struct WindowMark {
  FixedText<kTagBytes> tag;
  std::uint32_t configuration = 0;  ///< CRC-32 of span, sampling and signals
  std::int64_t judged_ms = 0;       ///< newest sample of the newest window, 0: none
  std::uint32_t unjudged = 0;       ///< samples, the newest ones
};

inline constexpr std::size_t kWindowsHeaderBytes = 4 + 1 + 1 + 8;
inline constexpr std::size_t kWindowMarkBytes = kTagBytes + 4 + 8 + 4;

/// Bytes of an image of so many loops with so many samples each.
[[nodiscard]] constexpr std::size_t windows_bytes(std::size_t loops,
                                                  std::uint32_t samples) {
  return kWindowsHeaderBytes + loops * (kWindowMarkBytes + recording_bytes(samples)) +
         kChecksumBytes;
}

void encode_windows_header(std::size_t loops, std::int64_t offset_us,
                           std::span<std::uint8_t, kWindowsHeaderBytes> out);
void encode_window_mark(const WindowMark& mark,
                        std::span<std::uint8_t, kWindowMarkBytes> out);

/// Checks an image, and goes through its windows: check → next … until it is false.
class WindowReader {
 public:
  /// `image` outlives this object.
  explicit WindowReader(std::span<const std::uint8_t> image) : image_(image) {}

  /// All of it; the other calls require kNone.
  [[nodiscard]] StateError check();
  [[nodiscard]] std::int64_t offset_us() const { return offset_us_; }
  [[nodiscard]] bool next();
  /// Of the window that next() came to.
  [[nodiscard]] const WindowMark& mark() const { return mark_; }
  [[nodiscard]] const RecordingHeader& header() const { return header_; }
  [[nodiscard]] RecordingSample sample(std::size_t index) const;

 private:
  /// The window at `at_`; false: none can be there.
  [[nodiscard]] bool take_window();

  std::span<const std::uint8_t> image_;
  std::int64_t offset_us_ = 0;
  std::size_t left_ = 0;  // windows not yet gone through
  std::size_t at_ = 0;    // the next of them
  WindowMark mark_;
  RecordingHeader header_;
  std::span<const std::uint8_t> samples_;
};

}  // namespace wire
