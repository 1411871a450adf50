#include "wire/state_image.hpp"

#include <algorithm>
#include <array>

#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"

namespace wire {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'S', 'B', 'S', 'T'};
constexpr std::uint8_t kVersion = 1;
constexpr std::size_t kTagBytes = 32;
constexpr std::size_t kChecksumBytes = 4;
constexpr int kParameterObject = 5;
constexpr std::uint8_t kKept =
    kDtcStatusMask & ~(kDtcFailsNow | kDtcNotCompletedThisCycle);

using ParameterImage = std::array<std::uint8_t, kParameterBytes>;

ParameterImage image_of(const LoopParameters& parameters) {
  LoopStatus status;
  status.parameters = parameters;
  ParameterImage out{};
  (void)encode_loop_object(kParameterObject, status, out);
  return out;
}

std::array<std::uint8_t, kTagBytes> image_of(const FixedText<kTagBytes>& tag) {
  std::array<std::uint8_t, kTagBytes> out{};
  std::copy(tag.view().begin(), tag.view().end(), out.begin());
  return out;
}

class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> out) : out_(out) {}
  void number(std::uint64_t value, std::size_t bytes) {
    put_big_endian(value, out_.subspan(at_, bytes));
    at_ += bytes;
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

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> data) : data_(data) {}
  std::uint64_t number(std::size_t count) { return get_big_endian(bytes(count)); }
  std::span<const std::uint8_t> bytes(std::size_t count) {
    at_ += count;
    return data_.subspan(at_ - count, count);
  }

 private:
  std::span<const std::uint8_t> data_;
  std::size_t at_ = 0;
};

struct SavedLoop {
  std::uint8_t id = 0;
  std::span<const std::uint8_t> tag;
  std::span<const std::uint8_t> configured;
  LoopParameters parameters;
  DtcStore::LoopEntries entries{};
};

bool read_entries(Reader& in, DtcStore::LoopEntries& entries) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    DtcStore::Entry& entry = entries[i];
    if (in.number(1) != static_cast<std::uint64_t>(failure_kinds()[i].type)) return false;
    entry.status = static_cast<std::uint8_t>(in.number(1));
    entry.occurrences = static_cast<std::uint16_t>(in.number(2));
    const std::uint64_t has_snapshot = in.number(1);
    entry.has_snapshot = has_snapshot == 1;
    const auto snapshot = in.bytes(DtcStore::kSnapshotBytes);
    std::copy(snapshot.begin(), snapshot.end(), entry.snapshot.begin());
    if ((entry.status & ~kKept) != 0 || has_snapshot > 1) return false;
  }
  return true;
}

bool read_loop(Reader& in, SavedLoop& out) {
  out.id = static_cast<std::uint8_t>(in.number(1));
  out.tag = in.bytes(kTagBytes);
  out.configured = in.bytes(kParameterBytes);
  return decode_parameters(in.bytes(kParameterBytes), out.parameters) && out.id >= 1 &&
         out.id <= kMostLoops && read_entries(in, out.entries);
}

StateError check_frame(std::span<const std::uint8_t> image) {
  if (image.size() < kStateHeaderBytes + kChecksumBytes ||
      !std::equal(kMagic.begin(), kMagic.end(), image.begin())) {
    return StateError::kForeign;
  }
  if (image[4] != kVersion) return StateError::kVersion;
  const std::size_t content = kStateHeaderBytes + image[5] * kStateLoopBytes;
  if (image.size() != content + kChecksumBytes) return StateError::kLength;
  return get_big_endian(image.subspan(content)) == crc32(image.first(content))
             ? StateError::kNone
             : StateError::kChecksum;
}

}  // namespace

const char* describe(StateError error) {
  switch (error) {
    case StateError::kNone:
      return "nothing wrong";
    case StateError::kForeign:
      return "a file of another kind";
    case StateError::kVersion:
      return "the state of another version";
    case StateError::kLength:
      return "a file of the wrong length";
    case StateError::kChecksum:
      return "damaged content: the CRC-32 is another";
    case StateError::kContent:
      return "a value out of range";
  }
  return "";
}

std::size_t write_state(std::span<const LoopStatus> loops,
                        std::span<const LoopParameters> configured, const DtcStore& dtcs,
                        std::span<std::uint8_t> out) {
  const std::size_t content = kStateHeaderBytes + loops.size() * kStateLoopBytes;
  if (out.size() < content + kChecksumBytes || loops.size() > kMostLoops ||
      configured.size() != loops.size()) {
    return 0;
  }
  Writer writer(out);
  writer.bytes(kMagic);
  writer.number(kVersion, 1);
  writer.number(loops.size(), 1);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    writer.number(loops[k].id, 1);
    writer.bytes(image_of(loops[k].tag));
    writer.bytes(image_of(configured[k]));
    writer.bytes(image_of(loops[k].parameters));
    const DtcStore::LoopEntries* known = dtcs.entries(loops[k].id);
    const DtcStore::LoopEntries none{};
    const DtcStore::LoopEntries& entries = known != nullptr ? *known : none;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      writer.number(static_cast<std::uint64_t>(failure_kinds()[i].type), 1);
      writer.number(entries[i].status & kKept, 1);
      writer.number(entries[i].occurrences, 2);
      writer.number(entries[i].has_snapshot ? 1 : 0, 1);
      writer.bytes(entries[i].snapshot);
    }
  }
  writer.number(crc32(out.first(content)), kChecksumBytes);
  return writer.size();
}

StateError read_state(std::span<const std::uint8_t> image,
                      std::span<const LoopStatus> loops,
                      std::span<LoopParameters> parameters, DtcStore& dtcs) {
  const StateError error = check_frame(image);
  if (error != StateError::kNone) return error;
  SavedLoop saved;
  Reader check(image.subspan(kStateHeaderBytes));
  for (std::size_t k = 0; k < image[5]; ++k) {
    if (!read_loop(check, saved)) return StateError::kContent;
  }
  Reader reader(image.subspan(kStateHeaderBytes));
  for (std::size_t k = 0; k < image[5]; ++k) {
    (void)read_loop(reader, saved);
    for (std::size_t i = 0; i < loops.size() && i < parameters.size(); ++i) {
      const auto tag = image_of(loops[i].tag);
      if (loops[i].id != saved.id ||
          !std::equal(tag.begin(), tag.end(), saved.tag.begin())) {
        continue;
      }
      dtcs.restore(saved.id, saved.entries);
      const ParameterImage configured = image_of(parameters[i]);
      const bool same =
          std::equal(configured.begin(), configured.end(), saved.configured.begin());
      if (same && image_of(saved.parameters) != configured) {
        parameters[i] = saved.parameters;
      }
    }
  }
  return StateError::kNone;
}

}  // namespace wire
