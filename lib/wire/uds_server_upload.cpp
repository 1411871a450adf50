// Transfers from the diagnostic server: recordings and histories.
#include <algorithm>

#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"
#include "wire/history_row.hpp"
#include "wire/uds_reply.hpp"
#include "wire/uds_server.hpp"

namespace wire {

Nrc UdsServer::request_upload(Bytes request, std::int64_t now_us, UdsReply& reply) {
  constexpr std::size_t kHeader = 3;
  constexpr std::size_t kMostBytes = 4;
  constexpr std::uint8_t kTwoByteLength = 0x20;
  constexpr std::uint16_t kMostBlock = 4093;
  if (request.size() < kHeader) return Nrc::kIncorrectLength;
  const std::size_t address_bytes = request[2] & 0x0F;
  const std::size_t size_bytes = request[2] >> 4;
  const bool readable = address_bytes >= 1 && address_bytes <= kMostBytes &&
                        size_bytes >= 1 && size_bytes <= kMostBytes;
  if (!readable) return Nrc::kRequestOutOfRange;
  if (request.size() != kHeader + address_bytes + size_bytes) {
    return Nrc::kIncorrectLength;
  }
  const std::uint64_t address = get_big_endian(request.subspan(kHeader, address_bytes));
  const auto wanted = static_cast<std::uint32_t>(
      get_big_endian(request.subspan(kHeader + address_bytes, size_bytes)));
  const bool plain = request[1] == 0;  // neither compressed nor encrypted
  const bool history = address > kHistoryAddress;
  const std::uint64_t id = history ? address - kHistoryAddress : address;
  if (!plain || id == 0 || id > kMostLoops || wanted == 0 ||
      loop_of(static_cast<int>(id)) == nullptr) {
    return Nrc::kRequestOutOfRange;
  }
  if (transferring_) return Nrc::kConditionsNotCorrect;
  const int loop = static_cast<int>(id);
  const std::uint32_t available =
      history ? actions_.begin_history(loop) : actions_.begin_recording(loop);
  if (available == 0) return Nrc::kConditionsNotCorrect;
  transferring_ = true;
  uploader_ = asking_;
  transfer_us_ = now_us;
  transfer_size_ = std::min(wanted, available);
  transferred_ = block_start_ = 0;
  block_ = 0;
  crc_ = 0;
  // The reply that carries a block has at most the room that this one has.
  constexpr std::size_t kBlockHeader = 2;
  const std::size_t room =
      reply.room().size() - std::min(reply.room().size(), kBlockHeader);
  block_bytes_ = static_cast<std::uint16_t>(std::clamp<std::size_t>(
      std::min<std::size_t>(settings_.block_bytes, room), 1, kMostBlock));
  reply.number(kTwoByteLength, 1);
  reply.number(block_bytes_ + kBlockHeader, 2);
  return Nrc::kNone;
}

Nrc UdsServer::transfer_data(Bytes request, std::int64_t now_us, UdsReply& reply) {
  if (request.size() != 2) return Nrc::kIncorrectLength;
  if (!transfers(asking_)) return Nrc::kRequestSequenceError;
  transfer_us_ = now_us;
  const std::uint8_t counter = request[1];
  const bool repeat = counter == block_ && transferred_ > 0;
  const bool next = counter == static_cast<std::uint8_t>(block_ + 1);
  if (!repeat && !next) return Nrc::kWrongBlockSequence;
  if (next && transferred_ == transfer_size_) return Nrc::kRequestSequenceError;
  const std::uint32_t start = repeat ? block_start_ : transferred_;
  const std::uint32_t size =
      repeat ? transferred_ - start
             : std::min<std::uint32_t>(block_bytes_, transfer_size_ - start);
  reply.number(counter, 1);
  const std::span<std::uint8_t> data = reply.take(size);
  if (reply.overflow()) return Nrc::kResponseTooLong;
  actions_.read_recording(start, data);
  if (next) {
    crc_ = crc32(data, crc_);
    block_ = counter;
    block_start_ = start;
    transferred_ = start + size;
  }
  return Nrc::kNone;
}

Nrc UdsServer::transfer_exit(Bytes request, UdsReply& reply) {
  if (request.size() != 1) return Nrc::kIncorrectLength;
  if (!transfers(asking_)) return Nrc::kRequestSequenceError;
  reply.number(crc_, 4);
  end_transfer();
  return Nrc::kNone;
}

void UdsServer::end_transfer() {
  if (!transferring_) return;
  transferring_ = false;
  actions_.end_recording();
}

}  // namespace wire
