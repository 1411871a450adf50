// The diagnostic services (UDS, ISO 14229-1): request in, response out.
//
// Life: states and actions of the daemon → UdsServer → handle() with each request →
// advance() at least every 100 ms, so that sessions end.
//
// Services: 10 (01, 03), 14, 19 (01, 02, 04, 06, 0A), 22, 2E, 27 (with a key only), 31,
// 3E, 35, 36, 37; anything else NRC 11. Checked in the order length, session, security,
// range, conditions. Functional requests: silence on NRC 11, 12, 31, 7E, 7F.
// Read-only unless `writes`: 14, 2E and the routines F000 and F002 need it, the extended
// session and the key; each, and each key that is sent, is told (UdsActions::tell).
//
// Testers: each source address has a session, a lock and tries of its own, which nobody
// else's requests touch; 0 is the one of those who share an identifier.
//
// Routines (31 01): F000 reset [loop], F001 evaluate now [loop], F002 simulate loop
// verdict, until 31 02 F002 [loop] or the session ends; without loop: all of them.
// Upload (35 00 44 loop:u32 size:u32): the recording of wire/recording_image.hpp, or with
// 0x100 + loop the history of wire/history_row.hpp, at most
// `size` bytes of it; 37 answers with the CRC-32 of what was transferred. One at a time,
// of the tester who began it; it ends with its session, or kTransferUs after its newest
// request.
//
// One thread; no heap, clock, exceptions; time is the caller's, µs. Cost: linear in the
// response, plus two SHA-256 of 96 bytes for 27 02. Everything is answered within the
// call: P2 is the daemon's loop.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "wire/diagnostics.hpp"
#include "wire/dtc_store.hpp"
#include "wire/uds_codes.hpp"

namespace wire {

struct UdsSettings {
  bool writes = false;
  bool has_key = false;                ///< false: no service 27, hence no writing
  std::array<std::uint8_t, 32> key{};  ///< secret of HMAC-SHA-256
  std::uint16_t block_bytes = 1024;    ///< of data in one transfer block, 1 … 4093
};

/// What leaves a line in the log and a counter.
enum class UdsAct : std::uint8_t {
  kUnlocked,    ///< the right key
  kRefusedKey,  ///< a wrong one
  kWritten,     ///< parameters of a loop
  kCleared,     ///< DTCs
  kReset,       ///< a loop, or all
  kSimulated,   ///< a verdict, or its end
};

/// What a tester may ask the daemon to do. `loop` is configured, or 0: all. False:
/// conditions not correct. Called from handle() and advance(); must return at once.
class UdsActions {
 public:
  /// Unpredictable bytes for the seed.
  [[nodiscard]] virtual bool fill_random(std::span<std::uint8_t> out) = 0;
  /// `parameters` are in range.
  [[nodiscard]] virtual bool write_parameters(int loop,
                                              const LoopParameters& parameters) = 0;
  [[nodiscard]] virtual bool reset(int loop) = 0;
  [[nodiscard]] virtual bool evaluate(int loop) = 0;
  /// From now on `LoopStatus` shows `verdict`, confirmed, with `simulated` set.
  [[nodiscard]] virtual bool simulate(int loop, LoopVerdict verdict) = 0;
  virtual void end_simulation(int loop) = 0;
  /// Takes a copy of the loop's window that does not change until end_recording().
  /// Its size in bytes; 0: none to be had.
  [[nodiscard]] virtual std::uint32_t begin_recording(int loop) = 0;
  /// The same for its history (wire/history_row.hpp), which may go on meanwhile.
  [[nodiscard]] virtual std::uint32_t begin_history(int loop) = 0;
  /// Bytes `offset` … of that copy, or history; fills `out`, within the size above.
  virtual void read_recording(std::uint32_t offset, std::span<std::uint8_t> out) = 0;
  virtual void end_recording() = 0;
  /// The tester with that source address has done it; `loop` 0: all, or none.
  virtual void tell(UdsAct act, std::uint8_t tester, int loop) = 0;

 protected:
  ~UdsActions() = default;
};

class UdsReply;

class UdsServer {
 public:
  static constexpr std::int64_t kS3Us = 5'000'000;
  static constexpr std::int64_t kTransferUs = 5'000'000;
  static constexpr std::int64_t kLockoutUs = 10'000'000;
  static constexpr int kMostTries = 3;
  static constexpr std::uint8_t kDefaultSession = 1;
  static constexpr std::uint8_t kExtendedSession = 3;

  /// All references outlive this object. `loops` have their ids set and unique.
  UdsServer(const UdsSettings& settings, const GatewayStatus& gateway,
            std::span<const LoopStatus> loops, DtcStore& dtcs, UdsActions& actions);
  UdsServer(const UdsServer&) = delete;
  UdsServer& operator=(const UdsServer&) = delete;

  /// Answers `request` of a tester into `storage` (≥ 64 bytes; 4095 for everything);
  /// empty: silence.
  [[nodiscard]] std::span<const std::uint8_t> handle(
      std::span<const std::uint8_t> request, bool functional, std::int64_t now_us,
      std::span<std::uint8_t> storage, std::uint8_t tester = 0);
  /// Ends sessions that have been silent for S3, and an abandoned upload. Call
  /// keep_alive() before while a response is being sent.
  void advance(std::int64_t now_us);
  /// That tester is still being answered.
  void keep_alive(std::int64_t now_us, std::uint8_t tester);

  [[nodiscard]] std::uint8_t session(std::uint8_t tester = 0) const {
    return testers_[tester].session;
  }
  [[nodiscard]] bool unlocked(std::uint8_t tester = 0) const {
    return testers_[tester].unlocked;
  }

 private:
  using Bytes = std::span<const std::uint8_t>;

  struct Tester {
    std::int64_t active_us = 0;
    std::int64_t locked_until_us = 0;
    std::array<std::uint8_t, 16> seed{};
    std::uint8_t session = kDefaultSession;
    std::uint8_t tries = 0;
    bool unlocked = false;
    bool seed_given = false;
    bool locked_out = false;
  };

  [[nodiscard]] Nrc dispatch(Bytes request, std::int64_t now_us, UdsReply& reply);
  [[nodiscard]] Nrc session_control(Bytes request, UdsReply& reply);
  [[nodiscard]] Nrc clear_dtcs(Bytes request);
  [[nodiscard]] Nrc read_dtcs(Bytes request, UdsReply& reply);
  [[nodiscard]] Nrc read_dtc_record(Bytes request, UdsReply& reply);
  [[nodiscard]] Nrc read_data(Bytes request, UdsReply& reply);
  [[nodiscard]] Nrc write_data(Bytes request, UdsReply& reply);
  [[nodiscard]] Nrc security_access(Bytes request, std::int64_t now_us, UdsReply& reply);
  [[nodiscard]] Nrc check_key(Bytes key, std::int64_t now_us);
  [[nodiscard]] bool simulate(int loop, LoopVerdict verdict);
  [[nodiscard]] Nrc routine(Bytes request, UdsReply& reply);
  [[nodiscard]] Nrc tester_present(Bytes request, UdsReply& reply);
  [[nodiscard]] Nrc request_upload(Bytes request, std::int64_t now_us, UdsReply& reply);
  [[nodiscard]] Nrc transfer_data(Bytes request, std::int64_t now_us, UdsReply& reply);
  [[nodiscard]] Nrc transfer_exit(Bytes request, UdsReply& reply);

  [[nodiscard]] const LoopStatus* loop_of(int id) const;
  [[nodiscard]] Nrc may_write(Nrc in_default_session) const;
  void enter(std::uint8_t tester, std::uint8_t session);
  void end_if_silent(std::uint8_t tester, std::int64_t now_us);
  void end_transfer();
  [[nodiscard]] bool transfers(std::uint8_t tester) const {
    return transferring_ && uploader_ == tester;
  }
  void tell(UdsAct act, int loop) { actions_.tell(act, asking_, loop); }

  UdsSettings settings_;
  const GatewayStatus& gateway_;
  std::span<const LoopStatus> loops_;
  DtcStore& dtcs_;
  UdsActions& actions_;

  std::array<Tester, 256> testers_{};
  std::uint8_t asking_ = 0;  // whose request is worked on
  bool simulating_ = false;
  std::uint8_t simulator_ = 0;  // whose session it ends with

  bool transferring_ = false;
  std::uint8_t uploader_ = 0;
  std::int64_t transfer_us_ = 0;  // newest request of it
  std::uint8_t block_ = 0;        // counter of the newest block sent
  std::uint32_t transfer_size_ = 0;
  std::uint32_t block_start_ = 0;  // of the newest block
  std::uint32_t transferred_ = 0;
  std::uint32_t crc_ = 0;
  std::uint16_t block_bytes_ = 1;
};

}  // namespace wire
