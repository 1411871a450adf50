// What --replay prints: events as they happen, the state of each loop at the end, and the
// answers to diagnostic queries; for people or, with `json`, one object per line.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "firmware/replay.hpp"

namespace firmware {

[[nodiscard]] std::string event_line(const Notice& notice, double t_s,
                                     const config::Gateway& gateway, bool json);
/// The final state of a loop: every field of the table of diagnostic objects, and the
/// level of its line.
[[nodiscard]] std::string summary_line(const Replay& replay, std::size_t loop, bool json);
/// Request and answer in hex; the fields of objects of loops decoded from the answer.
[[nodiscard]] std::string answer_line(std::span<const std::uint8_t> request,
                                      std::span<const std::uint8_t> answer, bool json);

/// Bytes of "22 FD10"; empty when it is not pairs of hex digits.
[[nodiscard]] std::vector<std::uint8_t> bytes_of(std::string_view hex);

}  // namespace firmware
