#include "wire/uds_server.hpp"

#include <algorithm>
#include <cstddef>

#include "wire/sha256.hpp"
#include "wire/uds_reply.hpp"

namespace wire {

using namespace uds;

namespace {

constexpr std::uint16_t kP2Ms = 50;
constexpr std::uint16_t kP2StarTenMs = 500;
constexpr int kParametersOffset = 5;

using Bytes = std::span<const std::uint8_t>;

bool has_sub_function(std::uint8_t service) {
  return service == kSessionControl || service == kReadDtcs ||
         service == kSecurityAccess || service == kRoutine || service == kTesterPresent;
}

std::uint8_t sub_function(Bytes request) {
  return request[1] & static_cast<std::uint8_t>(~kSuppress);
}

bool silent_when_functional(Nrc nrc) {
  return nrc == Nrc::kServiceNotSupported || nrc == Nrc::kSubFunctionNotSupported ||
         nrc == Nrc::kRequestOutOfRange || nrc == Nrc::kSubFunctionNotInSession ||
         nrc == Nrc::kServiceNotInSession;
}

}  // namespace

UdsServer::UdsServer(const UdsSettings& settings, const GatewayStatus& gateway,
                     std::span<const LoopStatus> loops, DtcStore& dtcs,
                     UdsActions& actions)
    : settings_(settings),
      gateway_(gateway),
      loops_(loops),
      dtcs_(dtcs),
      actions_(actions) {}

std::span<const std::uint8_t> UdsServer::handle(Bytes request, bool functional,
                                                std::int64_t now_us,
                                                std::span<std::uint8_t> storage,
                                                std::uint8_t tester) {
  advance(now_us);
  end_if_silent(tester, now_us);
  asking_ = tester;
  testers_[tester].active_us = now_us;
  constexpr std::size_t kRefusal = 3;
  if (request.empty() || storage.size() < kRefusal) return {};
  UdsReply reply(storage);
  Nrc nrc = dispatch(request, now_us, reply);
  if (nrc == Nrc::kNone && reply.overflow()) nrc = Nrc::kResponseTooLong;
  if (nrc == Nrc::kNone) {
    const bool suppressed = has_sub_function(request[0]) && request.size() > 1 &&
                            (request[1] & kSuppress) != 0;
    return suppressed ? Bytes{} : reply.data();
  }
  if (functional && silent_when_functional(nrc)) return {};
  const std::uint8_t service = request[0];
  storage[0] = kNegative;
  storage[1] = service;
  storage[2] = static_cast<std::uint8_t>(nrc);
  return storage.first(kRefusal);
}

void UdsServer::end_if_silent(std::uint8_t tester, std::int64_t now_us) {
  const Tester& t = testers_[tester];
  if (t.session != kDefaultSession && now_us - t.active_us >= kS3Us) {
    enter(tester, kDefaultSession);
  }
}

void UdsServer::advance(std::int64_t now_us) {
  for (std::size_t tester = 0; tester < testers_.size(); ++tester) {
    end_if_silent(static_cast<std::uint8_t>(tester), now_us);
  }
  if (transferring_ && now_us - transfer_us_ >= kTransferUs) end_transfer();
}

void UdsServer::keep_alive(std::int64_t now_us, std::uint8_t tester) {
  testers_[tester].active_us = now_us;
  if (transfers(tester)) transfer_us_ = now_us;
}

Nrc UdsServer::dispatch(Bytes request, std::int64_t now_us, UdsReply& reply) {
  reply.number(request[0] + kPositive, 1);
  switch (request[0]) {
    case kSessionControl:
      return session_control(request, reply);
    case kClearDtcs:
      return clear_dtcs(request);
    case kReadDtcs:
      return read_dtcs(request, reply);
    case kReadData:
      return read_data(request, reply);
    case kSecurityAccess:
      return settings_.has_key ? security_access(request, now_us, reply)
                               : Nrc::kServiceNotSupported;
    case kWriteData:
      return write_data(request, reply);
    case kRoutine:
      return routine(request, reply);
    case kRequestUpload:
      return request_upload(request, now_us, reply);
    case kTransferData:
      return transfer_data(request, now_us, reply);
    case kTransferExit:
      return transfer_exit(request, reply);
    case kTesterPresent:
      return tester_present(request, reply);
    default:
      return Nrc::kServiceNotSupported;
  }
}

Nrc UdsServer::session_control(Bytes request, UdsReply& reply) {
  if (request.size() < 2) return Nrc::kIncorrectLength;
  const std::uint8_t session = sub_function(request);
  if (session != kDefaultSession && session != kExtendedSession) {
    return Nrc::kSubFunctionNotSupported;
  }
  if (request.size() != 2) return Nrc::kIncorrectLength;
  enter(asking_, session);
  reply.number(session, 1);
  reply.number(kP2Ms, 2);
  reply.number(kP2StarTenMs, 2);
  return Nrc::kNone;
}

void UdsServer::enter(std::uint8_t tester, std::uint8_t session) {
  Tester& t = testers_[tester];
  t.session = session;
  t.unlocked = false;
  t.seed_given = false;
  if (uploader_ == tester) end_transfer();
  if (session == kDefaultSession && simulating_ && simulator_ == tester) {
    simulating_ = false;
    actions_.end_simulation(0);
  }
}

Nrc UdsServer::tester_present(Bytes request, UdsReply& reply) {
  if (request.size() < 2) return Nrc::kIncorrectLength;
  if (sub_function(request) != 0) return Nrc::kSubFunctionNotSupported;
  if (request.size() != 2) return Nrc::kIncorrectLength;
  reply.number(0, 1);
  return Nrc::kNone;
}

const LoopStatus* UdsServer::loop_of(int id) const {
  const auto found = std::ranges::find(loops_, id, &LoopStatus::id);
  return found == loops_.end() ? nullptr : &*found;
}

Nrc UdsServer::read_data(Bytes request, UdsReply& reply) {
  if (request.size() < 3 || request.size() % 2 == 0) return Nrc::kIncorrectLength;
  const GatewayView view{gateway_, loops_, session(asking_)};
  bool any = false;
  for (Bytes left = request.subspan(1); !left.empty(); left = left.subspan(2)) {
    const auto did = static_cast<std::uint16_t>(get_big_endian(left.first(2)));
    std::span<std::uint8_t> room = reply.room();
    room = room.subspan(std::min<std::size_t>(2, room.size()));
    const std::optional<std::size_t> size = encode_did(did, view, room);
    if (!size) continue;
    any = true;
    reply.number(did, 2);
    (void)reply.take(*size);
    if (reply.overflow()) return Nrc::kResponseTooLong;
  }
  return any ? Nrc::kNone : Nrc::kRequestOutOfRange;
}

Nrc UdsServer::may_write(Nrc in_default_session) const {
  if (session(asking_) == kDefaultSession) return in_default_session;
  return unlocked(asking_) ? Nrc::kNone : Nrc::kSecurityAccessDenied;
}

Nrc UdsServer::write_data(Bytes request, UdsReply& reply) {
  constexpr std::size_t kHeader = 3;
  if (request.size() <= kHeader) return Nrc::kIncorrectLength;
  const auto did = static_cast<std::uint16_t>(get_big_endian(request.subspan(1, 2)));
  const auto target = std::ranges::find_if(loops_, [did](const LoopStatus& loop) {
    return did == loop_did(loop.id, kParametersOffset);
  });
  const Bytes data = request.subspan(kHeader);
  const bool known = target != loops_.end();
  if (known && data.size() != kParameterBytes) return Nrc::kIncorrectLength;
  if (const Nrc nrc = may_write(Nrc::kServiceNotInSession); nrc != Nrc::kNone) return nrc;
  LoopParameters parameters;
  if (!known || !decode_parameters(data, parameters)) return Nrc::kRequestOutOfRange;
  if (!settings_.writes || !actions_.write_parameters(target->id, parameters)) {
    return Nrc::kConditionsNotCorrect;
  }
  tell(UdsAct::kWritten, target->id);
  reply.number(did, 2);
  return Nrc::kNone;
}

Nrc UdsServer::security_access(Bytes request, std::int64_t now_us, UdsReply& reply) {
  constexpr std::uint8_t kRequestSeed = 1;
  constexpr std::uint8_t kSendKey = 2;
  if (request.size() < 2) return Nrc::kIncorrectLength;
  const std::uint8_t step = sub_function(request);
  if (step != kRequestSeed && step != kSendKey) return Nrc::kSubFunctionNotSupported;
  Tester& tester = testers_[asking_];
  if (request.size() != (step == kRequestSeed ? 2 : 2 + tester.seed.size())) {
    return Nrc::kIncorrectLength;
  }
  if (tester.session == kDefaultSession) return Nrc::kServiceNotInSession;
  if (tester.locked_out && now_us < tester.locked_until_us) {
    return Nrc::kTimeDelayNotExpired;
  }
  tester.locked_out = false;
  reply.number(step, 1);
  if (step == kSendKey) return check_key(request.subspan(2), now_us);
  tester.seed_given = false;
  if (tester.unlocked) {
    reply.bytes(decltype(tester.seed){});
    return Nrc::kNone;
  }
  if (!actions_.fill_random(tester.seed)) return Nrc::kConditionsNotCorrect;
  tester.seed_given = true;
  reply.bytes(tester.seed);
  return Nrc::kNone;
}

Nrc UdsServer::check_key(Bytes key, std::int64_t now_us) {
  Tester& tester = testers_[asking_];
  if (!tester.seed_given) return Nrc::kRequestSequenceError;
  tester.seed_given = false;
  const Sha256Digest expected = hmac_sha256(settings_.key, tester.seed);
  if (equal_in_constant_time(key, Bytes(expected).first(tester.seed.size()))) {
    tester.tries = 0;
    tester.unlocked = true;
    tell(UdsAct::kUnlocked, 0);
    return Nrc::kNone;
  }
  tell(UdsAct::kRefusedKey, 0);
  if (++tester.tries < kMostTries) return Nrc::kInvalidKey;
  tester.tries = 0;
  tester.locked_out = true;
  tester.locked_until_us = now_us + kLockoutUs;
  return Nrc::kExceededAttempts;
}

bool UdsServer::simulate(int loop, LoopVerdict verdict) {
  if (!actions_.simulate(loop, verdict)) return false;
  simulating_ = true;
  simulator_ = asking_;
  return true;
}

Nrc UdsServer::routine(Bytes request, UdsReply& reply) {
  constexpr std::uint8_t kStart = 1;
  constexpr std::uint8_t kStop = 2;
  constexpr std::uint8_t kResults = 3;
  constexpr std::uint16_t kReset = 0xF000;
  constexpr std::uint16_t kEvaluate = 0xF001;
  constexpr std::uint16_t kSimulate = 0xF002;
  constexpr std::size_t kHeader = 4;
  if (request.size() < 2) return Nrc::kIncorrectLength;
  const std::uint8_t order = sub_function(request);
  if (order < kStart || order > kResults) return Nrc::kSubFunctionNotSupported;
  if (request.size() < kHeader) return Nrc::kIncorrectLength;
  const auto id = static_cast<std::uint16_t>(get_big_endian(request.subspan(2, 2)));
  if (id < kReset || id > kSimulate) return Nrc::kRequestOutOfRange;
  if ((order == kStop && id != kSimulate) || (order == kResults && id == kReset)) {
    return Nrc::kSubFunctionNotSupported;
  }

  const bool starts_simulation = id == kSimulate && order == kStart;
  const Bytes options = request.subspan(kHeader);
  const std::size_t fewest = starts_simulation ? 2 : order == kResults ? 1 : 0;
  if (options.size() < fewest || options.size() > std::max<std::size_t>(fewest, 1)) {
    return Nrc::kIncorrectLength;
  }
  const bool changes_what_is_shown = id != kEvaluate && order != kResults;
  if (changes_what_is_shown) {
    const Nrc nrc = may_write(Nrc::kSubFunctionNotInSession);
    if (nrc != Nrc::kNone) return nrc;
  }
  const int loop = options.empty() ? 0 : options[0];
  const LoopStatus* status = loop_of(loop);
  if (status == nullptr && !options.empty()) return Nrc::kRequestOutOfRange;
  if (starts_simulation && !is_verdict(options[1])) return Nrc::kRequestOutOfRange;
  if (changes_what_is_shown && !settings_.writes) return Nrc::kConditionsNotCorrect;

  bool done = true;
  if (order == kStop) {
    actions_.end_simulation(loop);
  } else if (starts_simulation) {
    done = simulate(loop, static_cast<LoopVerdict>(options[1]));
  } else if (order == kStart) {
    done = id == kReset ? actions_.reset(loop) : actions_.evaluate(loop);
  }
  if (!done) return Nrc::kConditionsNotCorrect;
  if (changes_what_is_shown) {
    tell(id == kReset ? UdsAct::kReset : UdsAct::kSimulated, loop);
  }
  reply.number(order, 1);
  reply.number(id, 2);
  if (order == kResults) {
    reply.number(static_cast<std::uint8_t>(status->verdict), 1);
    reply.number(status->simulated ? 1 : 0, 1);
  }
  return Nrc::kNone;
}

}  // namespace wire
