// What the reader of one recording advises, in options that a screening has.
#pragma once

#include <string>

namespace workbench {

/// `error` of the file at `path`: --u and --y become --pairs; what a screening cannot be
/// told, a command for the file alone, at the end.
[[nodiscard]] std::string screen_advice(const std::string& error,
                                        const std::string& path);

}  // namespace workbench
