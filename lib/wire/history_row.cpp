#include "wire/history_row.hpp"

#include <algorithm>
#include <array>

#include "wire/big_endian.hpp"
#include "wire/byte_stream.hpp"
#include "wire/crc32.hpp"

namespace wire {
namespace {

constexpr double kBandScale = 0.01;
constexpr double kNatScale = 0.1;
constexpr double kPeriodScale = 0.1;
constexpr double kConfidenceScale = 0.5;
constexpr std::array<std::uint8_t, 4> kMagic = {'S', 'B', 'H', 'I'};
constexpr std::uint8_t kVersion = 1;

void put(ByteWriter& out, FieldType type, double scale, double value) {
  out.number(to_raw(type, scale, value), size_of(type));
}

double get(ByteReader& in, FieldType type, double scale) {
  return from_raw(type, scale, in.number(size_of(type))).value_or(kNotAvailable);
}

}  // namespace

HistoryRow history_row(const LoopStatus& status) {
  HistoryRow row;
  row.verdict = status.window_verdict;
  row.flag = status.flag;
  row.period_s = status.period_s;
  row.confidence_pct = status.confidence_pct;
  row.stick_band_pct = status.stick_band_pct;
  row.stick_band_low_pct = status.stick_band_low_pct;
  row.stick_band_high_pct = status.stick_band_high_pct;
  row.detectable_band_pct = status.detectable_band_pct;
  row.evidence_nats = status.evidence_nats;
  return row;
}

void encode_history_row(const HistoryRow& row,
                        std::span<std::uint8_t, kHistoryRowBytes> out) {
  ByteWriter writer(out);
  writer.number(row.sequence, 2);
  writer.number(static_cast<std::uint64_t>(row.verdict), 1);
  writer.number(row.flag ? 1 : 0, 1);
  writer.number(row.time_s, 4);
  put(writer, FieldType::kU16, kPeriodScale, row.period_s);
  put(writer, FieldType::kU8, kConfidenceScale, row.confidence_pct);
  writer.number(0, 1);
  for (const double* value : bands_of(row)) {
    put(writer, FieldType::kU16, kBandScale, *value);
  }
  put(writer, FieldType::kI16, kNatScale, row.evidence_nats);
  // Its complement, so that a row of zeros is none.
  writer.number(~crc32(std::span(out).first(writer.size())), 4);
}

bool decode_history_head(std::span<const std::uint8_t, kHistoryRowBytes> data,
                         HistoryRow& row) {
  constexpr std::size_t kContent = kHistoryRowBytes - 4;
  const auto sum = static_cast<std::uint32_t>(~get_big_endian(data.last<4>()));
  if (sum != crc32(data.first<kContent>())) return false;
  ByteReader in(data);
  row.sequence = static_cast<std::uint16_t>(in.number(2));
  const auto verdict = static_cast<std::uint8_t>(in.number(1));
  row.verdict = static_cast<LoopVerdict>(verdict);
  row.flag = (in.number(1) & 1) != 0;
  row.time_s = static_cast<std::uint32_t>(in.number(4));
  return is_verdict(verdict);
}

bool decode_history_row(std::span<const std::uint8_t, kHistoryRowBytes> data,
                        HistoryRow& row) {
  constexpr std::size_t kHead = 8;
  if (!decode_history_head(data, row)) return false;
  ByteReader in(data.subspan<kHead>());
  row.period_s = get(in, FieldType::kU16, kPeriodScale);
  row.confidence_pct = get(in, FieldType::kU8, kConfidenceScale);
  (void)in.number(1);
  for (double* value : bands_of(row)) *value = get(in, FieldType::kU16, kBandScale);
  row.evidence_nats = get(in, FieldType::kI16, kNatScale);
  return true;
}

std::size_t read_history(std::span<const std::uint8_t> rings, std::span<HistoryRow> out) {
  std::size_t count = 0;
  for (auto left = rings; left.size() >= kHistoryRowBytes && count < out.size();
       left = left.subspan(kHistoryRowBytes)) {
    count += decode_history_row(left.first<kHistoryRowBytes>(), out[count]) ? 1 : 0;
  }
  // A mark follows the window that was the newest when it was made.
  const auto mark = [](const HistoryRow& row) {
    return row.verdict == LoopVerdict::kNotEvaluated;
  };
  const auto rows = out.first(count);
  std::sort(rows.begin(), rows.end(), [&](const HistoryRow& a, const HistoryRow& b) {
    return a.time_s != b.time_s ? a.time_s < b.time_s : mark(a) < mark(b);
  });
  const auto end = std::unique(rows.begin(), rows.end(),
                               [&](const HistoryRow& a, const HistoryRow& b) {
                                 return a.time_s == b.time_s && mark(a) == mark(b);
                               });
  return static_cast<std::size_t>(end - rows.begin());
}

void encode_history_header(std::uint8_t loop, std::uint16_t rows,
                           std::span<std::uint8_t, kHistoryHeaderBytes> out) {
  ByteWriter writer(out);
  writer.bytes(kMagic);
  writer.number(kVersion, 1);
  writer.number(loop, 1);
  writer.number(rows, 2);
}

std::uint16_t decode_history_header(
    std::span<const std::uint8_t, kHistoryHeaderBytes> data) {
  ByteReader in(data);
  const bool good =
      std::ranges::equal(in.bytes(kMagic.size()), kMagic) && in.number(1) == kVersion;
  (void)in.number(1);
  const auto rows = static_cast<std::uint16_t>(in.number(2));
  return good ? rows : std::uint16_t{0};
}

}  // namespace wire
