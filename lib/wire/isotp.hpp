// ISO-TP (ISO 15765-2) on classic CAN: messages of many frames, one connection.
//
// Life: storage of the caller → IsoTpLink → on_frame() with every frame off the bus →
// request(), if there is one: work on it, then send() the response or release() → poll()
// until it has nothing more to send; again whenever a frame came or next_us() has passed.
// A request stays where it is, untouched, until send() or release().
//
// Addressing: 11 bits, or 29 bits "normal fixed" (18DA target source). With the latter
// every source address is a tester of its own, answered under its own identifier.
// Functional requests are single frames.
//
// One response at a time, and one request of many frames. Single frames are served while
// such a request is being received, from whomever it comes. A request that comes while
// another is worked on or answered, or a second one of many frames, gets "busy, repeat
// request" (7F sid 21) and touches no buffer: at once to a tester with an identifier of
// its own; after the response that is going on to one that shares the identifiers, since
// a frame in between would end it at the receiver. Functional 3E 80 (tester present, no
// response) is let through at any time. A reception that has stood still for kStalledUs
// gives way to that of another tester.
//
// Sent frames have DLC 8, padded with 0xCC; shorter ones are accepted. N_As = N_Bs = N_Cr
// = 1 s. Rejected and counted: remote and error frames, frames too short for what they
// announce, the escape to 32-bit lengths, lengths beyond the storage (overflow flow
// control). A wrong sequence number ends the reception.
//
// One thread; no heap, clock or exceptions; time is the caller's, µs, never backwards.
// Cost of each call: constant (at most 8 bytes copied; send(): the response).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "wire/can_frame.hpp"

namespace wire {

inline constexpr std::size_t kLongestIsoTpRequest = 512;    ///< bytes, to the server
inline constexpr std::size_t kLongestIsoTpResponse = 4095;  ///< bytes, FF_DL of 12 bits

struct IsoTpSettings {
  std::uint32_t request_id = 0x7E0;     ///< of frames to us; extended: 0x18DA10F1
  std::uint32_t response_id = 0x7E8;    ///< of frames from us; extended: 0x18DAF110
  std::uint32_t functional_id = 0x7DF;  ///< of frames to all; extended: 0x18DB33F1
  bool extended_ids = false;            ///< 29 bits
  std::uint8_t block_size = 0;  ///< frames between our flow controls, 0: all at once
  std::uint8_t st_min = 0;      ///< what we ask for, as coded in ISO 15765-2
  bool answer_busy = true;      ///< false: a client, which does not answer requests
};

/// The normal-fixed identifiers of gateway.md.
[[nodiscard]] constexpr IsoTpSettings normal_fixed_settings() {
  IsoTpSettings settings;
  settings.request_id = 0x18DA10F1;
  settings.response_id = 0x18DAF110;
  settings.functional_id = 0x18DB33F1;
  settings.extended_ids = true;
  return settings;
}

/// A receive filter of raw CAN: frames with (id & mask) == (filter id & mask).
struct IsoTpFilter {
  std::uint32_t id = 0;
  std::uint32_t mask = 0;
  bool extended = false;
};

struct IsoTpCounters {
  std::uint32_t requests = 0;           ///< complete, handed out
  std::uint32_t responses = 0;          ///< sent to the end
  std::uint32_t rejected_frames = 0;    ///< RTR, short, escape, bad length, unexpected
  std::uint32_t overflows = 0;          ///< FF_DL beyond the storage
  std::uint32_t sequence_errors = 0;    ///< wrong SN
  std::uint32_t timeouts = 0;           ///< N_As, N_Bs or N_Cr ran out
  std::uint32_t aborted_responses = 0;  ///< by the tester's flow control, or reset()
  std::uint32_t busy = 0;               ///< requests answered or dropped as busy
};

struct IsoTpRequest {
  std::span<const std::uint8_t> data;  ///< 1 … storage size
  bool functional = false;
  std::uint8_t tester = 0;  ///< its source address; 0 where all share one identifier
};

class IsoTpLink {
 public:
  static constexpr std::int64_t kTimeoutUs = 1'000'000;  ///< N_As, N_Bs, N_Cr
  static constexpr std::int64_t kStalledUs = 250'000;    ///< > the longest STmin
  static constexpr int kMostWaits = 10;                  ///< flow controls WAIT in a row

  /// `receive` bounds the messages that are accepted, `transmit` (≤ 4095) those sent.
  IsoTpLink(const IsoTpSettings& settings, std::span<std::uint8_t> receive,
            std::span<std::uint8_t> transmit);
  IsoTpLink(const IsoTpLink&) = delete;
  IsoTpLink& operator=(const IsoTpLink&) = delete;

  /// True for identifiers of this connection; on_frame() ignores all others.
  [[nodiscard]] bool accepts(const CanFrame& frame) const;
  /// Physical and functional filter for the socket.
  [[nodiscard]] std::array<IsoTpFilter, 2> filters() const;

  void on_frame(const CanFrame& frame, std::int64_t now_us);

  /// The message that waits for send() or release(). A functional one comes first, and
  /// one beside a reception.
  [[nodiscard]] std::optional<IsoTpRequest> request() const;
  /// Answers the waiting message and releases it; without one, starts a message of our
  /// own (a client). False, and nothing sent, when it is empty, longer than the storage,
  /// or another one is being sent.
  [[nodiscard]] bool send(std::span<const std::uint8_t> message);
  /// Lets go of the waiting message without a response.
  void release();

  /// The next frame to send now, if any; also notices timeouts. A frame that was handed
  /// out counts as sent: where the bus cannot take it, do not poll.
  [[nodiscard]] std::optional<CanFrame> poll(std::int64_t now_us);
  /// Ends what has waited for too long, as poll() does, where the bus takes no frame.
  void expire(std::int64_t now_us);
  /// When poll() has something to do although no frame came; nullopt: never.
  [[nodiscard]] std::optional<std::int64_t> next_us() const;

  /// True from the first frame of a request to the last of its response.
  [[nodiscard]] bool busy() const;
  /// True while a response is being sent.
  [[nodiscard]] bool sending() const { return sending_ != Sending::kIdle; }
  /// Drops everything: the bus was gone.
  void reset();

  [[nodiscard]] const IsoTpCounters& counters() const { return counters_; }

 private:
  enum class Receiving : std::uint8_t { kIdle, kFrames, kComplete };
  enum class Sending : std::uint8_t { kIdle, kFirst, kFlowControl, kConsecutive };

  [[nodiscard]] bool many_testers() const;
  [[nodiscard]] bool is_ours(const CanFrame& frame, std::uint32_t id) const;
  [[nodiscard]] std::uint32_t reply_id(const CanFrame& frame) const;
  [[nodiscard]] std::uint8_t tester_of(std::uint32_t reply_id) const;
  [[nodiscard]] CanFrame frame_to(std::uint32_t id) const;
  void take_functional(const CanFrame& frame);
  void keep_single(const CanFrame& frame, bool functional);
  void take_single(const CanFrame& frame);
  void take_first(const CanFrame& frame, std::int64_t now_us);
  void take_consecutive(const CanFrame& frame, std::int64_t now_us);
  void take_flow_control(const CanFrame& frame, std::int64_t now_us);
  void refuse_busy(const CanFrame& frame, std::uint8_t service);
  void queue_flow_control(std::uint32_t id, std::uint8_t state);
  [[nodiscard]] CanFrame next_data_frame(std::int64_t now_us);

  IsoTpSettings settings_;
  IsoTpCounters counters_;
  std::span<std::uint8_t> receive_;
  std::span<std::uint8_t> transmit_;

  Receiving receiving_ = Receiving::kIdle;
  std::uint8_t expected_sn_ = 0;
  std::uint8_t left_in_block_ = 0;  // until our next flow control; 0: none
  std::size_t expected_ = 0;        // bytes of the message
  std::size_t received_ = 0;
  std::int64_t receive_deadline_us_ = 0;
  std::uint32_t peer_id_;  // identifier that answers the tester of this conversation

  // A single frame: functional, or beside a reception.
  std::array<std::uint8_t, 7> single_{};
  std::uint8_t single_length_ = 0;  // 0: none waits
  bool single_is_functional_ = false;
  std::uint32_t single_peer_id_ = 0;

  Sending sending_ = Sending::kIdle;
  std::uint8_t sn_ = 0;
  std::uint8_t tester_block_ = 0;  // BS of the tester, 0: no more flow controls
  std::uint8_t tester_left_ = 0;
  int waits_ = 0;
  std::uint32_t send_id_ = 0;
  std::size_t message_ = 0;  // bytes
  std::size_t sent_ = 0;
  std::int64_t separation_us_ = 0;
  std::int64_t send_at_us_ = 0;  // next frame, or N_Bs while waiting for flow control

  std::optional<CanFrame> control_;  // flow control that waits to be sent
  std::optional<CanFrame> refusal_;  // to another tester, at once
  std::optional<CanFrame> later_;    // to one that shares our identifiers
};

}  // namespace wire
