#include <array>
#include <string>

#include "feed.hpp"
#include "require.hpp"
#include "wire/dbc.hpp"

namespace fuzz {

Outcome feed_dbc(std::string_view text) {
  constexpr std::size_t kMessages = 32;
  constexpr std::size_t kSignals = 128;
  static std::array<wire::DbcMessage, kMessages> messages;
  static std::array<wire::DbcSignal, kSignals> signals;
  wire::Dbc dbc(messages, signals);
  const wire::DbcStatus status = dbc.parse(text);
  require(dbc.messages().size() <= kMessages, "messages within the storage");
  require(status.found.empty() ||
              (status.found.data() >= text.data() &&
               status.found.data() + status.found.size() <= text.data() + text.size()),
          "a finding inside the text");
  for (const wire::DbcMessage& message : dbc.messages()) {
    for (const wire::DbcSignal& signal : dbc.signals_of(message)) {
      const std::string reference =
          std::string(message.name) + '.' + std::string(signal.name);
      wire::FrameSignal found;
      if (!dbc.find(reference, found).ok()) continue;
      require(wire::check(found) == wire::SignalError::kNone, "a checked signal");
      wire::CanFrame frame;
      frame.id = found.frame_id;
      frame.extended = found.extended;
      frame.dlc = 8;
      double value = 0;
      if (wire::insert(found, found.signal.offset, frame) == wire::SignalError::kNone) {
        const wire::SignalError error = wire::extract(found, frame, value);
        require(error == wire::SignalError::kNone || found.multiplexed,
                "an inserted value that reads back");
        if (error == wire::SignalError::kNone && !found.multiplexed) {
          require(value == found.signal.offset, "raw zero means the offset");
        }
      }
    }
  }
  return status.ok() ? Outcome::kAccepted : Outcome::kRefused;
}

}  // namespace fuzz
