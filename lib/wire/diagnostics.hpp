// The diagnostic objects of the gateway: one table, from which UDS, the broadcast frame,
// the DBC, the Prometheus file and docs/can.md are made.
//
// The daemon keeps a GatewayStatus and one LoopStatus per loop up to date; the fields of
// the table read them. A field is a number (or a text) with a unit; on the wire numbers
// are big-endian integers, raw = number / scale, rounded and saturated. "Not available"
// is NaN here and all ones on the wire (0x7FFF in signed fields).
//
// No heap, clock or exceptions; every call is linear in what it writes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "wire/can_frame.hpp"

namespace wire {

inline constexpr int kMostLoops = 31;
inline constexpr std::size_t kTagBytes = 32;  ///< of a loop, zero-padded in images
inline constexpr std::size_t kMostPathKnots = 24;
inline constexpr double kNotAvailable = std::numeric_limits<double>::quiet_NaN();

/// Verdict of a loop, as on the wire.
enum class LoopVerdict : std::uint8_t {
  kNotEvaluated = 0,
  kNoStiction = 1,
  kOtherOscillation = 2,
  kUndecided = 3,
  kStiction = 4,
  kBacklash = 5,
  kInputInvalid = 7,
};

/// True for the codes above.
[[nodiscard]] constexpr bool is_verdict(std::uint8_t code) {
  return code <= 5 || code == 7;
}

/// NAMUR NE107 with the numbers of OPC UA DeviceHealth; worst first F > C > S > M.
enum class Ne107 : std::uint8_t {
  kNormal = 0,
  kFailure = 1,
  kCheckFunction = 2,
  kOffSpec = 3,
  kMaintenanceRequired = 4,
};
/// 0 (normal) … 4 (failure): larger is worse.
[[nodiscard]] int severity(Ne107 status);

/// State of the inputs of a loop, after debouncing.
enum class InputStatus : std::uint8_t {
  kGood = 0,
  kMissing = 1,        ///< no message or reading for longer than stale_after_s
  kCurrentLow = 2,     ///< NE43 failure, below
  kCurrentHigh = 3,    ///< NE43 failure, above
  kFrozen = 4,         ///< one signal stands still while the other moves
  kClipped = 5,        ///< rests at its limit
  kOutOfRange = 6,     ///< outside minimum … maximum, or not a number
  kNotConfigured = 7,  ///< the signal or device does not exist
  kUncertain = 8,      ///< gaps, drops or saturation: used, with less confidence
};
/// True when the loop can be evaluated with it: good and uncertain.
[[nodiscard]] bool is_usable(InputStatus status);

enum class LoopMode : std::uint8_t { kUnknown = 0, kAutomatic = 1, kManual = 2 };

/// A text in fixed memory; what does not fit is cut off.
template <std::size_t Size>
class FixedText {
 public:
  FixedText() = default;
  FixedText(std::string_view text) { assign(text); }
  void assign(std::string_view text) {
    length_ = text.size() < Size ? text.size() : Size;
    for (std::size_t i = 0; i < length_; ++i) text_[i] = text[i];
  }
  [[nodiscard]] std::string_view view() const { return {text_.data(), length_}; }

 private:
  std::array<char, Size> text_{};
  std::size_t length_ = 0;
};

/// One quantity for each stroke, % of span.
struct StrokeValues {
  double ascending = kNotAvailable;
  double descending = kNotAvailable;
};

/// What may be written into a loop (object +5).
struct LoopParameters {
  std::uint16_t on_delay_windows = 2;   ///< windows, 1 … 1000
  std::uint16_t off_delay_windows = 6;  ///< windows, 1 … 1000
  double band_min_pct = 0.5;            ///< % of span, 0 … 100
  Ne107 stiction = Ne107::kMaintenanceRequired;
  Ne107 backlash = Ne107::kMaintenanceRequired;
  Ne107 oscillation_other = Ne107::kNormal;
  Ne107 input_invalid = Ne107::kFailure;

  friend constexpr bool operator==(const LoopParameters&,
                                   const LoopParameters&) = default;
};
[[nodiscard]] bool is_valid(const LoopParameters& parameters);

/// What is counted of the inputs of a loop.
struct InputCounters {
  std::uint32_t frames = 0;          ///< with a signal of this loop
  std::uint32_t gaps = 0;            ///< sample periods without a new value
  std::uint32_t stale = 0;           ///< times the input went missing
  std::uint32_t dropped = 0;         ///< frames lost before we saw them
  std::uint32_t ne43_faults = 0;     ///< current outside the NE43 limits
  std::uint32_t refused_values = 0;  ///< out of range, or not a number
};
/// The same, and what is counted of its windows.
struct LoopCounters : InputCounters {
  std::uint32_t refused_fits = 0;  ///< windows that could not be decided
};

/// A knot of the identified valve paths, % of span.
struct PathKnot {
  double u_pct = kNotAvailable;
  double x_ascending_pct = kNotAvailable;
  double x_descending_pct = kNotAvailable;
};

/// Everything the views show of one loop; the daemon fills it.
struct LoopStatus {
  std::uint8_t id = 0;       ///< 1 … 31
  FixedText<kTagBytes> tag;  ///< ASCII
  FixedText<160> mapping;    ///< where u, y, sp come from, for people

  LoopVerdict verdict = LoopVerdict::kNotEvaluated;         ///< that is published
  LoopVerdict window_verdict = LoopVerdict::kNotEvaluated;  ///< newest window, no delay
  bool confirmed = false;  ///< `verdict` has stood for the on-delay
  bool flag = false;       ///< the flag of this loop is raised
  bool simulated = false;  ///< `verdict` was set by routine F002
  InputStatus input = InputStatus::kNotConfigured;
  double confidence_pct = kNotAvailable;  ///< %, 0 … 100

  StrokeValues stick_band_pct;                 ///< % of span
  StrokeValues stick_band_low_pct;             ///< 95 % interval, % of span
  StrokeValues stick_band_high_pct;            ///< the same
  double detectable_band_pct = kNotAvailable;  ///< smallest that would show, % of span
  double evidence_nats = kNotAvailable;        ///< closed-loop, of the window
  /// Slope of the stick band over weeks, % of span a day, with its 95 % interval; not
  /// available where the interval holds zero.
  double trend_pct_per_day = kNotAvailable;
  double trend_low_pct_per_day = kNotAvailable;
  double trend_high_pct_per_day = kNotAvailable;
  double days_to_limit = kNotAvailable;  ///< until the band reaches the loop's limit
  StrokeValues slip_jump_pct;            ///< % of span
  double period_s = kNotAvailable;       ///< of the oscillation, s
  double age_s = kNotAvailable;          ///< since the end of the window judged, s

  double u_pct = kNotAvailable;   ///< live, % of span
  double y_pct = kNotAvailable;   ///< live, % of span
  double sp_pct = kNotAvailable;  ///< live, % of span
  LoopMode mode = LoopMode::kUnknown;

  double window_samples = kNotAvailable;      ///< of the window judged
  double window_cycles = kNotAvailable;       ///< of the oscillation in it
  double fit_percent = kNotAvailable;         ///< %, ≤ 100
  double fit_linear_percent = kNotAvailable;  ///< %, behind a linear valve

  std::uint8_t suspect_effect = 0;            ///< row of the contract's table, 0: none
  double share_of_error_pct = kNotAvailable;  ///< of the suspect, %
  double residual_share_pct = kNotAvailable;  ///< RMS residual, % of the span of y

  LoopParameters parameters;
  double changed_ms = kNotAvailable;  ///< last change of verdict, ms since the epoch
  LoopCounters counters;
  std::array<PathKnot, kMostPathKnots> path{};
  std::uint8_t path_knots = 0;  ///< 0 … kMostPathKnots
};

/// What testers did with the key, and tried to; since start.
struct AccessCounters {
  std::uint32_t unlocks = 0;
  std::uint32_t refused_keys = 0;
  std::uint32_t writes = 0;       ///< of parameters
  std::uint32_t clears = 0;       ///< of DTCs
  std::uint32_t resets = 0;       ///< of loops
  std::uint32_t simulations = 0;  ///< of verdicts, begun or ended
};

/// What the views show of the gateway itself; the daemon fills it.
struct GatewayStatus {
  FixedText<32> name;              ///< F18C, `gateway.name`
  FixedText<32> software_version;  ///< F195
  double uptime_s = 0;
  std::uint32_t config_crc32 = 0;       ///< CRC-32 of the configuration file
  std::uint32_t textfile_failures = 0;  ///< times it could not be written
  std::uint32_t state_failures = 0;     ///< times the state file could not
  std::uint32_t history_failures = 0;   ///< times the history could not be written
  AccessCounters access;
};

/// NE107 of a loop: check function while simulated, else what `parameters` say of the
/// input or of the confirmed verdict.
[[nodiscard]] Ne107 ne107_of(const LoopStatus& loop);
/// The worst of all loops; normal without loops.
[[nodiscard]] Ne107 worst_ne107(std::span<const LoopStatus> loops);

enum class FieldType : std::uint8_t { kU8, kU16, kU32, kU64, kI16, kText, kPath };

/// Bytes of a number on the wire; 0 for texts and paths.
[[nodiscard]] constexpr std::size_t size_of(FieldType type) {
  constexpr std::array<std::size_t, 7> kSizes = {1, 2, 4, 8, 2, 0, 0};
  return kSizes[static_cast<std::size_t>(type)];
}

/// A number with a name.
struct Choice {
  std::uint8_t value = 0;
  std::string_view name;
};

/// All that the getters may look at.
struct GatewayView {
  const GatewayStatus& gateway;
  std::span<const LoopStatus> loops;
  std::uint8_t session = 1;  ///< UDS session
};

/// A field of a diagnostic object of one loop (Subject LoopStatus) or of the gateway
/// (GatewayView). Exactly one of `number` and `text` is set, none for a path.
template <class Subject>
struct Field {
  std::uint16_t object = 0;  ///< loop: offset of its DID, 0 … 10; gateway: its DID
  std::string_view name;     ///< snake_case, unique, for every view
  FieldType type = FieldType::kU8;
  std::string_view unit;  ///< empty for counts and codes
  double scale = 1;       ///< units per raw step
  std::string_view meaning;
  double (*number)(const Subject&) = nullptr;
  std::string_view (*text)(const Subject&) = nullptr;
  std::uint8_t text_bytes = 0;  ///< padded with zeros to this length; 0: as long as it is
  std::span<const Choice> choices;  ///< names of codes; empty for quantities
  std::uint8_t frame = 0;  ///< cyclic, that carries it: 1 … kBroadcastFrames; 0: none
  bool grows = false;      ///< a count since the start: it only grows
};
using LoopField = Field<LoopStatus>;
using GatewayField = Field<GatewayView>;

/// A diagnostic object: the fields that share a DID, in the order of the wire.
struct LoopObject {
  std::uint8_t offset = 0;  ///< DID = loop_did(loop, offset)
  std::string_view name;
  bool writable = false;
};

/// The table. Fields of one object follow each other.
[[nodiscard]] std::span<const LoopObject> loop_objects();
[[nodiscard]] std::span<const LoopField> loop_fields();
[[nodiscard]] std::span<const GatewayField> gateway_fields();

inline constexpr std::uint16_t kDirectoryDid = 0xFD01;
[[nodiscard]] constexpr std::uint16_t loop_did(int loop, int offset) {
  return static_cast<std::uint16_t>(0xFD00 + 16 * loop + offset);
}

/// Raw integer of a number as it goes on the wire: rounded, saturated to the values of
/// the type that are not "not available", which stands for NaN.
[[nodiscard]] std::uint64_t to_raw(FieldType type, double scale, double number);
/// Back; nullopt: not available.
[[nodiscard]] std::optional<double> from_raw(FieldType type, double scale,
                                             std::uint64_t raw);
/// What the wire would say of a numeric field: the value after rounding. nullopt: not
/// available. The other views show this number, so that all views agree to the digit.
[[nodiscard]] std::optional<double> shown(const LoopField& field, const LoopStatus& loop);
[[nodiscard]] std::optional<double> shown(const GatewayField& field,
                                          const GatewayView& view);

inline constexpr std::size_t kStateBytes = 20;      ///< object +0
inline constexpr std::size_t kWindowBytes = 8;      ///< object +3
inline constexpr std::size_t kParameterBytes = 10;  ///< object +5

/// Writes object `offset` of a loop; bytes written, 0 when `out` is too small or there is
/// no such object.
[[nodiscard]] std::size_t encode_loop_object(int offset, const LoopStatus& loop,
                                             std::span<std::uint8_t> out);
/// Writes the object of any DID: gateway, directory, loops. Bytes it takes, which were
/// written if they fit into `out`; nullopt: no such object.
[[nodiscard]] std::optional<std::size_t> encode_did(std::uint16_t did,
                                                    const GatewayView& view,
                                                    std::span<std::uint8_t> out);
/// Reads object +5; false when it is not exactly that long or a value is out of range.
[[nodiscard]] bool decode_parameters(std::span<const std::uint8_t> data,
                                     LoopParameters& out);

/// Cyclic frames of a loop: 1 has what it says of the valve, the first eight bytes of
/// object +0; 2 the intervals of the stick band, 3 its age and where it goes to. A frame
/// has the fields of the table that name it, in their order.
inline constexpr int kBroadcastFrames = 3;
inline constexpr std::uint32_t kBroadcastBaseId = 0x190;  ///< of frame 1
inline constexpr std::uint32_t kDetailBaseId = 0x1B0;     ///< of frames 2 and 3
/// Identifiers of one frame of all loops; those of frame 3 follow those of frame 2.
inline constexpr std::uint32_t kBroadcastIds = 32;
[[nodiscard]] constexpr std::uint32_t detail_id(int frame, int loop,
                                                std::uint32_t base_id) {
  return base_id + kBroadcastIds * static_cast<std::uint32_t>(frame - 2) +
         static_cast<std::uint32_t>(loop);
}
/// Frame 1, with the identifier base_id + loop.
[[nodiscard]] CanFrame broadcast_frame(const LoopStatus& loop,
                                       std::uint32_t base_id = kBroadcastBaseId);
/// Frame 2 or 3, with its detail_id().
[[nodiscard]] CanFrame detail_frame(int frame, const LoopStatus& loop,
                                    std::uint32_t base_id = kDetailBaseId);

}  // namespace wire
