// The answer of `stickband identify` for people.
#pragma once

#include <string>

#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/recording_view.hpp"

namespace workbench::cli {

/// At most 80 characters a line.
[[nodiscard]] std::string identification_text(const RecordingView& recording,
                                              const Analysis& analysis);

/// "125.0 (122.7 to 125.6)", or "unknown".
[[nodiscard]] std::string with_interval(const ident::Estimate<double>& estimate);

/// kDone, or kCannotAnswer after saying on stderr what data would answer; not again where
/// it `is_told` on the same terminal.
[[nodiscard]] int exit_code_for(ident::Verdict verdict, ident::Reason reason,
                                bool is_told = false);

}  // namespace workbench::cli
