// Ends work that takes its time where somebody asks for it.
#pragma once

#include <stop_token>

namespace workbench {

/// No std::exception, so that nothing on the way takes it for an error.
struct Stopped {};

/// Throws Stopped where `stop` was asked for. Some 1 ns.
inline void check_stop(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Stopped{};
}

}  // namespace workbench
