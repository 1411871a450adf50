#include "wire/state_image.hpp"

#include <algorithm>
#include <array>

#include "wire/byte_stream.hpp"
#include "wire/crc32.hpp"

namespace wire {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'S', 'B', 'S', 'T'};
constexpr std::uint8_t kVersion = 3;
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

struct SavedLoop {
  std::uint8_t id = 0;
  std::span<const std::uint8_t> tag;
  std::span<const std::uint8_t> configured;
  LoopParameters parameters;
  DtcStore::LoopEntries entries{};
  LoopMemory memory;
  LoopStatus status;
};

std::size_t content_bytes(std::size_t loops) {
  return kStateHeaderBytes + loops * (kStateLoopBytes + kLoopMemoryBytes);
}

bool read_entries(ByteReader& in, DtcStore::LoopEntries& entries) {
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

// Loop `k` of an image of the right length.
bool read_loop(std::span<const std::uint8_t> image, std::size_t k, SavedLoop& out) {
  ByteReader in(image.subspan(urgent_bytes(k), kStateLoopBytes));
  out.id = static_cast<std::uint8_t>(in.number(1));
  out.tag = in.bytes(kTagBytes);
  out.configured = in.bytes(kParameterBytes);
  const bool good = decode_parameters(in.bytes(kParameterBytes), out.parameters) &&
                    out.id >= 1 && out.id <= kMostLoops && read_entries(in, out.entries);
  const auto memory = image.subspan(urgent_bytes(image[5]) + k * kLoopMemoryBytes)
                          .first<kLoopMemoryBytes>();
  return good && decode_loop_memory(memory, out.memory, out.status);
}

StateError check_frame(std::span<const std::uint8_t> image) {
  if (image.size() < kStateHeaderBytes + kChecksumBytes ||
      !std::equal(kMagic.begin(), kMagic.end(), image.begin())) {
    return StateError::kForeign;
  }
  if (image[4] != kVersion) return StateError::kVersion;
  const std::size_t content = content_bytes(image[5]);
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

std::size_t urgent_bytes(std::size_t loops) {
  return kStateHeaderBytes + loops * kStateLoopBytes;
}

std::size_t write_state(std::span<const LoopStatus> loops,
                        std::span<const LoopParameters> configured,
                        std::span<const LoopMemory> memories, const DtcStore& dtcs,
                        std::span<std::uint8_t> out) {
  const std::size_t content = content_bytes(loops.size());
  if (out.size() < content + kChecksumBytes || loops.size() > kMostLoops ||
      configured.size() != loops.size() || memories.size() != loops.size()) {
    return 0;
  }
  ByteWriter writer(out);
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
  for (std::size_t k = 0; k < loops.size(); ++k) {
    std::array<std::uint8_t, kLoopMemoryBytes> memory{};
    encode_loop_memory(memories[k], loops[k], memory);
    writer.bytes(memory);
  }
  writer.number(crc32(out.first(content)), kChecksumBytes);
  return writer.size();
}

StateError read_state(std::span<const std::uint8_t> image, std::span<LoopStatus> loops,
                      std::span<LoopParameters> parameters,
                      std::span<LoopMemory> memories, DtcStore& dtcs) {
  const StateError error = check_frame(image);
  if (error != StateError::kNone) return error;
  const std::size_t saved_loops = image[5];
  SavedLoop saved;
  for (std::size_t k = 0; k < saved_loops; ++k) {
    if (!read_loop(image, k, saved)) return StateError::kContent;
  }
  for (std::size_t k = 0; k < saved_loops; ++k) {
    (void)read_loop(image, k, saved);
    for (std::size_t i = 0;
         i < loops.size() && i < parameters.size() && i < memories.size(); ++i) {
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
      if (!saved.memory.judged ||
          saved.memory.configuration != memories[i].configuration) {
        continue;
      }
      memories[i] = saved.memory;
      loops[i].window_verdict = saved.status.window_verdict;
      loops[i].suspect_effect = saved.status.suspect_effect;
      loops[i].changed_ms = saved.status.changed_ms;
      for (const KeptNumber number : kept_numbers()) {
        number(loops[i]) = number(saved.status);
      }
    }
  }
  return StateError::kNone;
}

}  // namespace wire
