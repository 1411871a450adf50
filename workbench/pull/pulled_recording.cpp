#include "workbench/pull/pulled_recording.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"
#include "wire/diagnostics.hpp"
#include "wire/history_csv.hpp"
#include "wire/uds_codes.hpp"

namespace workbench {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kTagOffset = 1;
constexpr int kTries = 3;  // of what may be asked twice

std::string tag_of(UdsClient& client, int loop) {
  const std::uint16_t did = wire::loop_did(loop, kTagOffset);
  const Bytes request = {wire::uds::kReadData, static_cast<std::uint8_t>(did >> 8),
                         static_cast<std::uint8_t>(did)};
  const Bytes response = client.ask(request, kTries);
  std::string tag(response.begin() + std::min<std::ptrdiff_t>(3, std::ssize(response)),
                  response.end());
  tag.resize(std::min(tag.find('\0'), tag.size()));
  return tag;
}

// What is uploaded from an address: a header of `header_bytes` from which `size_of` tells
// how long all of it is, 0 if it is no such header.
Bytes image_of(UdsClient& client, std::uint32_t address, std::size_t header_bytes,
               const std::function<std::size_t(const Bytes&)>& size_of,
               const std::function<void(std::size_t, std::size_t)>& progress) {
  Bytes start = {
      wire::uds::kRequestUpload, 0x00, 0x44, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF};
  wire::put_big_endian(address, std::span(start).subspan(3, 4));
  (void)client.ask(start);
  Bytes image;
  std::size_t expected = header_bytes;
  for (std::uint8_t counter = 1; image.size() < expected; ++counter) {
    const Bytes block = client.ask(Bytes{wire::uds::kTransferData, counter}, kTries);
    if (block.size() < 3 || block[1] != counter) {
      throw DeviceError("expected block " + std::to_string(counter) +
                        " of the recording, found another; try again");
    }
    image.insert(image.end(), block.begin() + 2, block.end());
    if (image.size() < header_bytes) continue;
    expected = size_of(image);
    if (expected == 0) {
      throw DeviceError(
          "expected a recording of version 1, found something else; "
          "update the gateway or this program");
    }
    progress(image.size(), expected);
  }
  const Bytes end = client.ask(Bytes{wire::uds::kTransferExit});
  const bool has_crc = end.size() == 5;
  if (image.size() != expected || (has_crc && wire::get_big_endian(std::span(end).subspan(
                                                  1)) != wire::crc32(image))) {
    throw DeviceError("expected an undamaged recording, found another CRC; try again");
  }
  return image;
}

void append(std::string& text, auto value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

}  // namespace

PulledRecording pull_recording(
    UdsClient& client, int loop,
    const std::function<void(std::size_t, std::size_t)>& progress) {
  PulledRecording out;
  out.tag = tag_of(client, loop);
  const auto size_of = [&out](const Bytes& start) -> std::size_t {
    if (!wire::decode_recording_header(start, out.header)) return 0;
    return wire::recording_bytes(out.header.samples);
  };
  const Bytes image = image_of(client, static_cast<std::uint32_t>(loop),
                               wire::kRecordingHeaderBytes, size_of, progress);
  out.samples.reserve(out.header.samples);
  for (std::uint32_t k = 0; k < out.header.samples; ++k) {
    const auto data = std::span(image).subspan(wire::recording_bytes(k));
    out.samples.push_back(
        wire::decode_recording_sample(data.first<wire::kRecordingSampleBytes>()));
  }
  return out;
}

PulledHistory pull_history(
    UdsClient& client, int loop,
    const std::function<void(std::size_t, std::size_t)>& progress) {
  PulledHistory out;
  out.tag = tag_of(client, loop);
  const auto size_of = [](const Bytes& start) -> std::size_t {
    const std::size_t rows =
        wire::decode_history_header(std::span(start).first<wire::kHistoryHeaderBytes>());
    return rows == 0 ? 0 : wire::kHistoryHeaderBytes + rows * wire::kHistoryRowBytes;
  };
  const Bytes image =
      image_of(client, wire::kHistoryAddress + static_cast<std::uint32_t>(loop),
               wire::kHistoryHeaderBytes, size_of, progress);
  const auto rings = std::span(image).subspan(wire::kHistoryHeaderBytes);
  out.rows.resize(rings.size() / wire::kHistoryRowBytes);
  out.rows.resize(wire::read_history(rings, out.rows));
  return out;
}

std::string csv_of(const PulledHistory& history) {
  std::string text(wire::history_csv_header());
  std::array<char, wire::kMostHistoryLine> line;
  for (const wire::HistoryRow& row : history.rows) {
    text.append(line.data(), wire::write_history_line(row, line));
  }
  return text;
}

std::string csv_of(const PulledRecording& recording) {
  std::string text = recording.header.has_setpoint ? "t,u,y,sp\n" : "t,u,y\n";
  for (std::size_t k = 0; k < recording.samples.size(); ++k) {
    const wire::RecordingSample& sample = recording.samples[k];
    if (!std::isfinite(sample.u) || !std::isfinite(sample.y)) continue;
    append(text, static_cast<double>(k) * recording.header.period_us / 1e6);
    text += ',';
    append(text, sample.u);
    text += ',';
    append(text, sample.y);
    if (recording.header.has_setpoint) {
      text += ',';
      if (std::isfinite(sample.sp)) append(text, sample.sp);
    }
    text += '\n';
  }
  return text;
}

}  // namespace workbench
