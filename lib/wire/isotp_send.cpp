// Messages that the link sends, in frames.
#include <algorithm>

#include "wire/isotp.hpp"
#include "wire/isotp_frame.hpp"

namespace wire {

using namespace isotp;

bool IsoTpLink::send(std::span<const std::uint8_t> message) {
  if (message.empty() || message.size() > transmit_.size() ||
      sending_ != Sending::kIdle) {
    return false;
  }
  send_id_ = single_length_ > 0                   ? single_peer_id_
             : receiving_ == Receiving::kComplete ? peer_id_
                                                  : settings_.response_id;
  release();
  std::copy(message.begin(), message.end(), transmit_.begin());
  message_ = message.size();
  sent_ = 0;
  sn_ = 1;
  waits_ = 0;
  sending_ = Sending::kFirst;
  return true;
}

CanFrame IsoTpLink::next_data_frame(std::int64_t now_us) {
  CanFrame frame = frame_to(send_id_);
  const bool first = sending_ == Sending::kFirst;
  const bool single = first && message_ <= kInSingle;
  std::size_t header = 1;
  if (single) {
    frame.data[0] = static_cast<std::uint8_t>(message_);
  } else if (first) {
    frame.data[0] = static_cast<std::uint8_t>(kFirst << 4 | message_ >> 8);
    frame.data[1] = static_cast<std::uint8_t>(message_);
    header = 2;
  } else {
    frame.data[0] = static_cast<std::uint8_t>(kConsecutive << 4 | sn_);
    sn_ = (sn_ + 1) & 0x0F;
  }
  const std::size_t length = std::min(kMaxClassicLength - header, message_ - sent_);
  std::copy_n(transmit_.begin() + sent_, length, frame.data.begin() + header);
  sent_ += length;

  if (sent_ == message_) {
    sending_ = Sending::kIdle;
    ++counters_.responses;
  } else if (first || (tester_block_ != 0 && --tester_left_ == 0)) {
    sending_ = Sending::kFlowControl;
    send_at_us_ = now_us + kTimeoutUs;
  } else {
    send_at_us_ = now_us + separation_us_;
  }
  return frame;
}

}  // namespace wire
