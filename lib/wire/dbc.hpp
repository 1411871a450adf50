// A small DBC reader: enough to read signals off a bus, in fixed memory.
//
// Understood: BO_ (bit 31 of the identifier = extended), SG_ (M, mN, Motorola and
// Intel), SIG_VALTYPE_ (float and double). Everything else is passed over, strings
// with line breaks included. LF, CRLF, CR, a byte-order mark, tabs and // comments are
// accepted. Extended multiplexing (mNM, ranges in SG_MUL_VAL_) is recognised and
// refused by find(), as are signals that do not fit the bytes of their message, 64 in
// CAN FD: a file may hold them as long as nobody asks for them.
//
// Use: storage of the caller → Dbc → parse(text) → find("MESSAGE.SIGNAL"). Names are
// views into `text`, which has to outlive the Dbc. parse() is linear in the text, save
// for SIG_VALTYPE_ and SG_MUL_VAL_ (times messages); find() linear in what was stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "wire/signal.hpp"

namespace wire {

enum class Multiplexing : std::uint8_t {
  kNone,
  kMultiplexor,  ///< M
  kMultiplexed,  ///< mN
  kNested,       ///< mNM
};

struct DbcMessage {
  std::string_view name;
  std::uint32_t id = 0;  ///< without bit 31
  bool extended = false;
  std::uint16_t length = 0;        ///< bytes
  std::uint32_t line = 0;          ///< where it is defined, from 1
  std::uint32_t first_signal = 0;  ///< index into the stored signals
  std::uint32_t signals = 0;
};

struct DbcSignal {
  std::string_view name;
  std::string_view unit;
  Signal signal;
  Multiplexing multiplexing = Multiplexing::kNone;
  bool has_ranges = false;  ///< SG_MUL_VAL_ says more than "mN" does
  std::uint32_t multiplex_value = 0;
  std::uint32_t line = 0;  ///< where it is defined, from 1
};

enum class DbcError : std::uint8_t {
  kNone,
  // parse()
  kMessageId,
  kMessageName,
  kMessageColon,
  kMessageLength,
  kSignalOutsideMessage,
  kSignalName,
  kMultiplexing,
  kSignalColon,
  kStart,
  kLength,
  kByteOrder,
  kSign,
  kScaleOffset,
  kLimits,
  kUnit,
  kValueType,
  kMultiplexRange,
  kOpenString,
  kTooManyMessages,
  kTooManySignals,
  kNoMessage,
  // find()
  kReference,
  kUnknownMessage,
  kUnknownSignal,
  kAmbiguous,
  kNoMultiplexor,
  kExtendedMultiplexing,
  kLayout,
};

/// What the file (or the reference) should hold where `error` was found, for
/// "expected …" messages.
[[nodiscard]] const char* expected_at(DbcError error);

struct DbcStatus {
  DbcError error = DbcError::kNone;
  std::uint32_t line = 0;    ///< from 1; 0 when no line is to blame
  std::uint32_t column = 0;  ///< in bytes from 1; 0 when the whole line is meant
  std::string_view found;    ///< what stands there instead; empty at the end of a line
  SignalError layout = SignalError::kNone;  ///< the reason behind kLayout
  [[nodiscard]] constexpr bool ok() const { return error == DbcError::kNone; }
};

class Dbc {
 public:
  /// Stores into the spans, which have to outlive this object.
  Dbc(std::span<DbcMessage> messages, std::span<DbcSignal> signals)
      : message_store_(messages), signal_store_(signals) {}

  /// Replaces the content by that of `text`. After an error, what came before it stays.
  [[nodiscard]] DbcStatus parse(std::string_view text);

  /// Everything needed to read MESSAGE.SIGNAL; `out` passes wire::check(). A broadcast
  /// message from the null address of J1939, 0xFE, is its parameter group from any sender.
  [[nodiscard]] DbcStatus find(std::string_view reference, FrameSignal& out) const;

  [[nodiscard]] std::span<const DbcMessage> messages() const {
    return message_store_.first(message_count_);
  }
  [[nodiscard]] std::span<const DbcSignal> signals_of(const DbcMessage& message) const {
    return signal_store_.subspan(message.first_signal, message.signals);
  }

 private:
  class Parser;
  [[nodiscard]] DbcSignal* stored_signal(std::uint32_t raw_id, std::string_view name);

  std::span<DbcMessage> message_store_;
  std::span<DbcSignal> signal_store_;
  std::size_t message_count_ = 0;
  std::size_t signal_count_ = 0;
};

}  // namespace wire
