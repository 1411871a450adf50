// Valid inputs to start from, and the words that matter to the readers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

[[nodiscard]] std::vector<std::string> csv_seeds();
[[nodiscard]] std::vector<std::string> dbc_seeds();
/// A DBC file and the log it explains, in one text as feed_candump() takes it.
[[nodiscard]] std::vector<std::string> candump_seeds();
/// As feed_frames() takes them.
[[nodiscard]] std::vector<std::string> frames_seeds();
[[nodiscard]] std::vector<std::string> toml_seeds();
/// As feed_uds() and feed_isotp() take them.
[[nodiscard]] std::vector<std::string> uds_seeds();
[[nodiscard]] std::vector<std::string> isotp_seeds();
/// Fragments to insert.
[[nodiscard]] const std::vector<std::string_view>& words();

}  // namespace fuzz
