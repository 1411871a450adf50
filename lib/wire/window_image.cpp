#include "wire/window_image.hpp"

#include <algorithm>
#include <array>

#include "wire/byte_stream.hpp"
#include "wire/crc32.hpp"

namespace wire {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'S', 'B', 'W', 'I'};
constexpr std::uint8_t kVersion = 1;
constexpr std::size_t kLoopsAt = 5;

}  // namespace

void encode_windows_header(std::size_t loops, std::int64_t offset_us,
                           std::span<std::uint8_t, kWindowsHeaderBytes> out) {
  ByteWriter writer(out);
  writer.bytes(kMagic);
  writer.number(kVersion, 1);
  writer.number(loops, 1);
  writer.number(static_cast<std::uint64_t>(offset_us), 8);
}

void encode_window_mark(const WindowMark& mark,
                        std::span<std::uint8_t, kWindowMarkBytes> out) {
  std::array<std::uint8_t, kTagBytes> tag{};
  std::copy(mark.tag.view().begin(), mark.tag.view().end(), tag.begin());
  ByteWriter writer(out);
  writer.bytes(tag);
  writer.number(mark.configuration, 4);
  writer.number(static_cast<std::uint64_t>(mark.judged_ms), 8);
  writer.number(mark.unjudged, 4);
}

StateError WindowReader::check() {
  if (image_.size() < kWindowsHeaderBytes + kChecksumBytes ||
      !std::equal(kMagic.begin(), kMagic.end(), image_.begin())) {
    return StateError::kForeign;
  }
  if (image_[kMagic.size()] != kVersion) return StateError::kVersion;
  const std::size_t content = image_.size() - kChecksumBytes;
  if (get_big_endian(image_.subspan(content)) != crc32(image_.first(content))) {
    return StateError::kChecksum;
  }
  ByteReader in(image_.subspan(kLoopsAt + 1));
  offset_us_ = static_cast<std::int64_t>(in.number(8));
  image_ = image_.first(content);
  at_ = kWindowsHeaderBytes;
  left_ = image_[kLoopsAt];
  const std::size_t windows = left_;
  while (left_ > 0) {
    if (!take_window()) return StateError::kContent;
  }
  if (at_ != image_.size()) return StateError::kLength;
  at_ = kWindowsHeaderBytes;
  left_ = windows;
  return StateError::kNone;
}

bool WindowReader::next() {
  return left_ > 0 && take_window();
}

bool WindowReader::take_window() {
  if (image_.size() - at_ < kWindowMarkBytes + kRecordingHeaderBytes) return false;
  ByteReader in(image_.subspan(at_));
  const auto tag = in.bytes(kTagBytes);
  std::array<char, kTagBytes> text{};
  std::copy(tag.begin(), tag.end(), text.begin());
  const auto end = std::find(text.begin(), text.end(), '\0');
  mark_.tag.assign({text.data(), static_cast<std::size_t>(end - text.begin())});
  mark_.configuration = static_cast<std::uint32_t>(in.number(4));
  mark_.judged_ms = static_cast<std::int64_t>(in.number(8));
  mark_.unjudged = static_cast<std::uint32_t>(in.number(4));
  const auto recording = image_.subspan(at_ + kWindowMarkBytes);
  if (!decode_recording_header(recording, header_)) return false;
  const std::size_t bytes = recording_bytes(header_.samples);
  constexpr std::uint64_t kMost_ms = std::uint64_t{1} << 53;
  if (bytes > recording.size() || header_.first_ms > kMost_ms ||
      mark_.unjudged > header_.samples) {
    return false;
  }
  samples_ = recording.first(bytes).subspan(kRecordingHeaderBytes);
  at_ += kWindowMarkBytes + bytes;
  --left_;
  return true;
}

RecordingSample WindowReader::sample(std::size_t index) const {
  return decode_recording_sample(
      samples_.subspan(index * kRecordingSampleBytes).first<kRecordingSampleBytes>());
}

}  // namespace wire
