#include "wire/dbc.hpp"

#include "wire/j1939.hpp"
#include "wire/text.hpp"

namespace wire {
namespace {

// The only message of that name.
DbcStatus find_message(std::span<const DbcMessage> messages, std::string_view name,
                       const DbcMessage*& message) {
  for (const DbcMessage& candidate : messages) {
    if (candidate.name != name) continue;
    if (message != nullptr) {
      return {DbcError::kAmbiguous, candidate.line, 0, name, {}};
    }
    message = &candidate;
  }
  if (message == nullptr) return {DbcError::kUnknownMessage, 0, 0, name, {}};
  return {};
}

// A signal among those of its message.
struct Found {
  const DbcSignal* signal = nullptr;
  const DbcSignal* multiplexor = nullptr;  // of the message, the last one
  std::size_t multiplexors = 0;
  bool nested = false;  // any signal of the message
};

DbcStatus find_signal(std::span<const DbcSignal> signals, std::string_view name,
                      std::uint32_t message_line, Found& out) {
  for (const DbcSignal& candidate : signals) {
    out.nested |= candidate.multiplexing == Multiplexing::kNested;
    if (candidate.multiplexing == Multiplexing::kMultiplexor) {
      out.multiplexor = &candidate;
      ++out.multiplexors;
    }
    if (candidate.name != name) continue;
    if (out.signal != nullptr) {
      return {DbcError::kAmbiguous, candidate.line, 0, name, {}};
    }
    out.signal = &candidate;
  }
  if (out.signal == nullptr) {
    return {DbcError::kUnknownSignal, message_line, 0, name, {}};
  }
  return {};
}

// No device sends from the null address of J1939: a broadcast message that names it is
// its parameter group, from whatever sender and of whatever priority.
void open_sender(FrameSignal& signal) {
  constexpr std::uint32_t kNobody = 0xFE;
  const bool of_nobody = (signal.frame_id & j1939::kSourceAddress) == kNobody;
  if (!signal.extended || !of_nobody ||
      j1939::is_to_one(j1939::pgn_of(signal.frame_id))) {
    return;
  }
  signal.ignored = j1939::kPriority | j1939::kSourceAddress;
  signal.frame_id &= ~signal.ignored;
}

}  // namespace

DbcStatus Dbc::find(std::string_view reference, FrameSignal& out) const {
  const std::size_t dot = reference.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == reference.size()) {
    return {DbcError::kReference, 0, 0, reference, {}};
  }
  const std::string_view message_name = slice(reference, 0, dot);
  const std::string_view signal_name = slice(reference, dot + 1, reference.size());

  const DbcMessage* message = nullptr;
  DbcStatus status = find_message(messages(), message_name, message);
  if (!status.ok()) return status;
  Found found;
  status = find_signal(signals_of(*message), signal_name, message->line, found);
  if (!status.ok()) return status;
  const DbcSignal* signal = found.signal;

  out = {};
  out.frame_id = message->id;
  out.extended = message->extended;
  open_sender(out);
  out.signal = signal->signal;
  out.multiplexed = signal->multiplexing == Multiplexing::kMultiplexed ||
                    signal->multiplexing == Multiplexing::kNested;
  if (out.multiplexed) {
    if (found.nested || signal->has_ranges) {
      return {DbcError::kExtendedMultiplexing, signal->line, 0, signal_name, {}};
    }
    if (found.multiplexors != 1) {
      return {DbcError::kNoMultiplexor, signal->line, 0, signal_name, {}};
    }
    out.multiplex_value = signal->multiplex_value;
    out.multiplexor = found.multiplexor->signal;
  }
  SignalError layout = check(out);
  if (layout == SignalError::kNone &&
      (bytes_needed(out.signal) > message->length ||
       (out.multiplexed && bytes_needed(out.multiplexor) > message->length))) {
    layout = SignalError::kShortFrame;
  }
  if (layout != SignalError::kNone) {
    return {DbcError::kLayout, signal->line, 0, signal_name, layout};
  }
  return {};
}

}  // namespace wire
