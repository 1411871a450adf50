// Work that takes its time: without the interpreter's lock, and Ctrl-C ends it.
#pragma once

#include <functional>
#include <stop_token>

namespace stickband_python {

/// Runs `work` on a thread of its own and waits for it, for the program's searches count
/// what their thread has spent. Meanwhile other threads of Python run. Where a signal's
/// handler raises (Ctrl-C), asks `work` to stop, waits for that and throws what was
/// raised. Else throws what `work` has thrown. Needs the interpreter's lock.
void run_long(const std::function<void(const std::stop_token&)>& work);

}  // namespace stickband_python
