// Notices of the daemon in words.
#pragma once

#include <string_view>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "firmware/log.hpp"
#include "hal/message.hpp"

namespace firmware {

/// One line without its time, e.g. "FIC-211: flag raised". No heap.
[[nodiscard]] hal::Message text_of(const Notice& notice, const config::Gateway& gateway);
/// What `mode` makes of the evaluation, e.g. "suspended: mode reads 2, automatic is 1".
[[nodiscard]] hal::Message text_of_mode(const config::Loop& loop, bool suspended,
                                        double mode);
[[nodiscard]] Priority priority_of(const Notice& notice);
[[nodiscard]] Topic topic_of(const Notice& notice);
/// The contract's name of the event, or ours, e.g. "stiction_raised", "flag_raised".
[[nodiscard]] std::string_view name_of(const Notice& notice);
/// Name of an input status as in the table of diagnostic objects, e.g. "missing".
[[nodiscard]] std::string_view name_of(wire::InputStatus status);

}  // namespace firmware
