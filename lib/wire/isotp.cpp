#include "wire/isotp.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "wire/isotp_frame.hpp"
#include "wire/uds_codes.hpp"

namespace wire {

using namespace isotp;

namespace {

constexpr std::uint8_t kPadding = 0xCC;

// Bits of a normal-fixed identifier: 18DA target source, 18DB target source.
constexpr std::uint32_t kKind = 0x00FF0000;
constexpr std::uint32_t kPhysicalKind = 0x00DA0000;
constexpr std::uint32_t kSource = 0x000000FF;
constexpr std::uint32_t kTarget = 0x0000FF00;

std::int64_t separation_us(std::uint8_t st_min) {
  constexpr std::int64_t kLongest = 127'000;  // also what reserved values mean
  if (st_min <= 0x7F) return 1000 * static_cast<std::int64_t>(st_min);
  if (st_min >= 0xF1 && st_min <= 0xF9) return 100 * (st_min - 0xF0);
  return kLongest;
}

bool is_silent_tester_present(const CanFrame& frame) {
  return low_nibble(frame) == 2 && frame.data[1] == uds::kTesterPresent &&
         frame.data[2] == uds::kSuppress;
}

}  // namespace

IsoTpLink::IsoTpLink(const IsoTpSettings& settings, std::span<std::uint8_t> receive,
                     std::span<std::uint8_t> transmit)
    : settings_(settings),
      receive_(receive),
      transmit_(transmit.first(std::min(transmit.size(), kLongestIsoTpResponse))),
      peer_id_(settings.response_id) {}

bool IsoTpLink::many_testers() const {
  return settings_.answer_busy && settings_.extended_ids &&
         (settings_.request_id & kKind) == kPhysicalKind &&
         (settings_.response_id & kKind) == kPhysicalKind;
}

bool IsoTpLink::is_ours(const CanFrame& frame, std::uint32_t id) const {
  const std::uint32_t mask = many_testers() ? ~kSource : ~0U;
  return !frame.error && frame.extended == settings_.extended_ids &&
         (frame.id & mask) == (id & mask);
}

bool IsoTpLink::accepts(const CanFrame& frame) const {
  return is_ours(frame, settings_.request_id) || is_ours(frame, settings_.functional_id);
}

std::array<IsoTpFilter, 2> IsoTpLink::filters() const {
  const std::uint32_t all = settings_.extended_ids ? kMaxExtendedId : kMaxStandardId;
  const std::uint32_t mask = many_testers() ? all & ~kSource : all;
  return {{{settings_.request_id, mask, settings_.extended_ids},
           {settings_.functional_id, mask, settings_.extended_ids}}};
}

std::uint32_t IsoTpLink::reply_id(const CanFrame& frame) const {
  if (!many_testers()) return settings_.response_id;
  return (settings_.response_id & ~kTarget) | (frame.id & kSource) << 8;
}

std::uint8_t IsoTpLink::tester_of(std::uint32_t reply_id) const {
  return many_testers() ? static_cast<std::uint8_t>(reply_id >> 8) : std::uint8_t{0};
}

CanFrame IsoTpLink::frame_to(std::uint32_t id) const {
  CanFrame frame;
  frame.id = id;
  frame.extended = settings_.extended_ids;
  frame.dlc = kMaxClassicLength;
  std::fill_n(frame.data.begin(), frame.dlc, kPadding);
  return frame;
}

bool IsoTpLink::busy() const {
  return receiving_ != Receiving::kIdle || sending_ != Sending::kIdle ||
         single_length_ > 0;
}

void IsoTpLink::on_frame(const CanFrame& frame, std::int64_t now_us) {
  if (!accepts(frame)) return;
  if (frame.remote || frame.fd || frame.dlc == 0) {
    ++counters_.rejected_frames;
    return;
  }
  expire(now_us);
  if (!is_ours(frame, settings_.request_id)) {
    take_functional(frame);
    return;
  }
  switch (kind_of(frame)) {
    case kSingle:
      take_single(frame);
      break;
    case kFirst:
      take_first(frame, now_us);
      break;
    case kConsecutive:
      take_consecutive(frame, now_us);
      break;
    case kFlowControl:
      take_flow_control(frame, now_us);
      break;
    default:
      ++counters_.rejected_frames;
  }
}

void IsoTpLink::take_functional(const CanFrame& frame) {
  if (!is_single(frame)) {
    ++counters_.rejected_frames;
  } else if (busy() && !(is_silent_tester_present(frame) && single_length_ == 0)) {
    refuse_busy(frame, frame.data[1]);
  } else {
    keep_single(frame, true);
  }
}

void IsoTpLink::keep_single(const CanFrame& frame, bool functional) {
  single_length_ = low_nibble(frame);
  single_is_functional_ = functional;
  std::copy_n(frame.data.begin() + 1, single_length_, single_.begin());
  single_peer_id_ = reply_id(frame);
  ++counters_.requests;
}

void IsoTpLink::take_single(const CanFrame& frame) {
  const std::size_t length = low_nibble(frame);
  if (!is_single(frame) || length > receive_.size()) {
    ++counters_.rejected_frames;
    return;
  }
  if (!settings_.answer_busy) {
    if (receiving_ == Receiving::kComplete) {
      ++counters_.busy;
      return;
    }
  } else if (busy()) {
    const bool beside = receiving_ == Receiving::kFrames && sending_ == Sending::kIdle;
    if (single_length_ == 0 && (beside || is_silent_tester_present(frame))) {
      keep_single(frame, !beside);
    } else {
      refuse_busy(frame, frame.data[1]);
    }
    return;
  }
  std::copy_n(frame.data.begin() + 1, length, receive_.begin());
  expected_ = received_ = length;
  peer_id_ = reply_id(frame);
  receiving_ = Receiving::kComplete;
  ++counters_.requests;
}

void IsoTpLink::take_first(const CanFrame& frame, std::int64_t now_us) {
  const std::size_t length =
      static_cast<std::size_t>(low_nibble(frame)) << 8 | frame.data[1];
  if (frame.dlc != kMaxClassicLength || length <= kInSingle) {
    ++counters_.rejected_frames;
    return;
  }
  const bool stalled = receiving_ == Receiving::kFrames && sending_ == Sending::kIdle &&
                       single_length_ == 0 && reply_id(frame) != peer_id_ &&
                       now_us >= receive_deadline_us_ - kTimeoutUs + kStalledUs;
  if (settings_.answer_busy ? busy() && !stalled : receiving_ == Receiving::kComplete) {
    refuse_busy(frame, frame.data[2]);
    return;
  }
  if (length > receive_.size()) {
    ++counters_.overflows;
    queue_flow_control(reply_id(frame), kOverflow);
    return;
  }
  std::copy_n(frame.data.begin() + 2, kInFirst, receive_.begin());
  expected_ = length;
  received_ = kInFirst;
  expected_sn_ = 1;
  left_in_block_ = settings_.block_size;
  peer_id_ = reply_id(frame);
  receiving_ = Receiving::kFrames;
  receive_deadline_us_ = now_us + kTimeoutUs;
  queue_flow_control(peer_id_, kContinue);
}

void IsoTpLink::take_consecutive(const CanFrame& frame, std::int64_t now_us) {
  const std::size_t length = std::min(kInConsecutive, expected_ - received_);
  if (receiving_ != Receiving::kFrames || reply_id(frame) != peer_id_ ||
      frame.dlc <= length) {
    ++counters_.rejected_frames;
    return;
  }
  if (low_nibble(frame) != expected_sn_) {
    ++counters_.sequence_errors;
    receiving_ = Receiving::kIdle;
    return;
  }
  std::copy_n(frame.data.begin() + 1, length, receive_.begin() + received_);
  received_ += length;
  expected_sn_ = (expected_sn_ + 1) & 0x0F;
  receive_deadline_us_ = now_us + kTimeoutUs;
  if (received_ == expected_) {
    receiving_ = Receiving::kComplete;
    ++counters_.requests;
  } else if (settings_.block_size != 0 && --left_in_block_ == 0) {
    left_in_block_ = settings_.block_size;
    queue_flow_control(peer_id_, kContinue);
  }
}

void IsoTpLink::take_flow_control(const CanFrame& frame, std::int64_t now_us) {
  constexpr std::uint8_t kShortest = 3;
  if (sending_ != Sending::kFlowControl || reply_id(frame) != send_id_ ||
      frame.dlc < kShortest) {
    ++counters_.rejected_frames;
    return;
  }
  switch (low_nibble(frame)) {
    case kContinue:
      tester_block_ = tester_left_ = frame.data[1];
      separation_us_ = separation_us(frame.data[2]);
      waits_ = 0;
      send_at_us_ = now_us;
      sending_ = Sending::kConsecutive;
      break;
    case kWait:
      if (++waits_ <= kMostWaits) {
        send_at_us_ = now_us + kTimeoutUs;
        break;
      }
      [[fallthrough]];
    default:
      ++counters_.aborted_responses;
      sending_ = Sending::kIdle;
  }
}

void IsoTpLink::refuse_busy(const CanFrame& frame, std::uint8_t service) {
  ++counters_.busy;
  if (!settings_.answer_busy) return;
  CanFrame refusal = frame_to(reply_id(frame));
  refusal.data[0] = 3;
  refusal.data[1] = uds::kNegative;
  refusal.data[2] = service;
  refusal.data[3] = static_cast<std::uint8_t>(Nrc::kBusyRepeatRequest);
  const bool would_disturb = sending_ != Sending::kIdle && refusal.id == send_id_;
  (would_disturb ? later_ : refusal_) = refusal;
}

void IsoTpLink::queue_flow_control(std::uint32_t id, std::uint8_t state) {
  CanFrame frame = frame_to(id);
  frame.data[0] = static_cast<std::uint8_t>(kFlowControl << 4 | state);
  frame.data[1] = state == kContinue ? settings_.block_size : std::uint8_t{0};
  frame.data[2] = state == kContinue ? settings_.st_min : std::uint8_t{0};
  control_ = frame;
}

std::optional<IsoTpRequest> IsoTpLink::request() const {
  if (single_length_ > 0) {
    return IsoTpRequest{{single_.data(), single_length_},
                        single_is_functional_,
                        tester_of(single_peer_id_)};
  }
  // A client may get a message while its own is on the way; a server answers first.
  const bool answering = settings_.answer_busy && sending_ != Sending::kIdle;
  if (receiving_ != Receiving::kComplete || answering) return std::nullopt;
  return IsoTpRequest{receive_.first(received_), false, tester_of(peer_id_)};
}

void IsoTpLink::release() {
  if (single_length_ > 0) {
    single_length_ = 0;
  } else if (receiving_ == Receiving::kComplete) {
    receiving_ = Receiving::kIdle;
  }
}

void IsoTpLink::expire(std::int64_t now_us) {
  if (receiving_ == Receiving::kFrames && now_us >= receive_deadline_us_) {
    ++counters_.timeouts;
    receiving_ = Receiving::kIdle;
  }
  const std::int64_t patience_us = sending_ == Sending::kConsecutive ? kTimeoutUs : 0;
  if ((sending_ == Sending::kFlowControl || sending_ == Sending::kConsecutive) &&
      now_us >= send_at_us_ + patience_us) {
    ++counters_.timeouts;
    sending_ = Sending::kIdle;
  }
}

std::optional<CanFrame> IsoTpLink::poll(std::int64_t now_us) {
  expire(now_us);
  for (std::optional<CanFrame>* waiting : {&control_, &refusal_}) {
    if (*waiting) return std::exchange(*waiting, std::nullopt);
  }
  if (sending_ == Sending::kFirst ||
      (sending_ == Sending::kConsecutive && now_us >= send_at_us_)) {
    return next_data_frame(now_us);
  }
  return sending_ == Sending::kIdle ? std::exchange(later_, std::nullopt) : std::nullopt;
}

std::optional<std::int64_t> IsoTpLink::next_us() const {
  constexpr std::int64_t kNow = std::numeric_limits<std::int64_t>::min();
  if (control_ || refusal_ || sending_ == Sending::kFirst ||
      (later_ && sending_ == Sending::kIdle)) {
    return kNow;
  }
  std::optional<std::int64_t> next;
  if (sending_ != Sending::kIdle) next = send_at_us_;
  if (receiving_ == Receiving::kFrames) {
    next = next ? std::min(*next, receive_deadline_us_) : receive_deadline_us_;
  }
  return next;
}

void IsoTpLink::reset() {
  if (sending_ != Sending::kIdle) ++counters_.aborted_responses;
  receiving_ = Receiving::kIdle;
  sending_ = Sending::kIdle;
  single_length_ = 0;
  control_.reset();
  refusal_.reset();
  later_.reset();
}

}  // namespace wire
