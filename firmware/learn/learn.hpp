// What --learn does: listens to a bus, or reads a log, and tells what travels there and
// which signals could be u and y of a loop. It sends nothing and writes no file.
#pragma once

#include <string>

#include "firmware/learn/learn_report.hpp"

namespace firmware {

struct LearnSettings {
  std::string log = {};  ///< a candump log; empty: listen to …
  std::string can = {};  ///< … this CAN interface of the kernel, or slcan:PORT
  std::string dbc = {};  ///< empty: guess
  double seconds = 60;   ///< to listen, or until SIGINT or SIGTERM
};

/// Throws std::runtime_error when the bus cannot be opened, config::ConfigError when a
/// file cannot be read.
[[nodiscard]] Learned learn(const LearnSettings& settings);

}  // namespace firmware
