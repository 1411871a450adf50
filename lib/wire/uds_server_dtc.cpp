// Services 14 and 19.
#include "wire/uds_reply.hpp"
#include "wire/uds_server.hpp"

namespace wire {
namespace {

constexpr std::uint8_t kCountByMask = 0x01;
constexpr std::uint8_t kListByMask = 0x02;
constexpr std::uint8_t kSnapshot = 0x04;
constexpr std::uint8_t kExtendedData = 0x06;
constexpr std::uint8_t kSupported = 0x0A;
constexpr std::uint8_t kFormatIso14229 = 0x01;
constexpr std::uint32_t kAllGroups = 0xFFFFFF;
constexpr std::uint8_t kTheRecord = 0x01;
constexpr std::uint8_t kAllRecords = 0xFF;

std::uint32_t dtc_at(std::span<const std::uint8_t> request, std::size_t at) {
  return static_cast<std::uint32_t>(get_big_endian(request.subspan(at, 3)));
}

}  // namespace

Nrc UdsServer::clear_dtcs(Bytes request) {
  constexpr std::size_t kLength = 4;
  if (request.size() != kLength) return Nrc::kIncorrectLength;
  if (const Nrc nrc = may_write(Nrc::kServiceNotInSession); nrc != Nrc::kNone) return nrc;
  const std::uint32_t group = dtc_at(request, 1);
  const bool all = group == kAllGroups;
  if (!all && dtcs_.find(group) == nullptr) return Nrc::kRequestOutOfRange;
  if (!settings_.writes) return Nrc::kConditionsNotCorrect;
  if (all) {
    dtcs_.clear_all();
  } else {
    (void)dtcs_.clear(group);
  }
  tell(UdsAct::kCleared, all ? 0 : static_cast<int>(group >> 8 & 0xFF));
  return Nrc::kNone;
}

Nrc UdsServer::read_dtcs(Bytes request, UdsReply& reply) {
  if (request.size() < 2) return Nrc::kIncorrectLength;
  const std::uint8_t report = request[1] & 0x7F;
  reply.number(report, 1);
  if (report == kSnapshot || report == kExtendedData) {
    return read_dtc_record(request, reply);
  }
  const bool counts = report == kCountByMask;
  const bool all = report == kSupported;
  if (!counts && !all && report != kListByMask) return Nrc::kSubFunctionNotSupported;
  if (request.size() != (all ? 2U : 3U)) return Nrc::kIncorrectLength;

  reply.number(kDtcStatusMask, 1);
  std::uint16_t count = 0;
  for (std::size_t i = 0; i < dtcs_.size(); ++i) {
    const DtcStore::Dtc dtc = dtcs_.at(i);
    if (!all && (dtc.entry->status & request[2] & kDtcStatusMask) == 0) continue;
    ++count;
    if (counts) continue;
    reply.number(dtc.number, 3);
    reply.number(dtc.entry->status, 1);
  }
  if (counts) {
    reply.number(kFormatIso14229, 1);
    reply.number(count, 2);
  }
  return Nrc::kNone;
}

Nrc UdsServer::read_dtc_record(Bytes request, UdsReply& reply) {
  constexpr std::size_t kLength = 6;
  if (request.size() != kLength) return Nrc::kIncorrectLength;
  const std::uint32_t number = dtc_at(request, 2);
  const std::uint8_t record = request[5];
  const DtcStore::Entry* entry = dtcs_.find(number);
  if (entry == nullptr || (record != kTheRecord && record != kAllRecords)) {
    return Nrc::kRequestOutOfRange;
  }
  reply.number(number, 3);
  reply.number(entry->status, 1);
  if ((request[1] & 0x7F) == kExtendedData) {
    reply.number(kTheRecord, 1);
    reply.number(entry->occurrences, 2);
    return Nrc::kNone;
  }
  if (!entry->has_snapshot) return Nrc::kNone;
  const int loop = static_cast<int>(number >> 8 & 0xFF);
  const Bytes snapshot(entry->snapshot);
  reply.number(kTheRecord, 1);
  reply.number(2, 1);  // objects that follow
  reply.number(loop_did(loop, 0), 2);
  reply.bytes(snapshot.first(kStateBytes));
  reply.number(loop_did(loop, 3), 2);
  reply.bytes(snapshot.subspan(kStateBytes));
  return Nrc::kNone;
}

}  // namespace wire
