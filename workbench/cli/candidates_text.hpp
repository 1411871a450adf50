// What explain() says of its candidates, for a terminal of 80 columns.
#pragma once

#include <span>
#include <string>

#include "workbench/model/search/explain.hpp"

namespace workbench::cli {

/// "dead time, and with it a second process lag".
[[nodiscard]] std::string titles_of(const Candidate& candidate);

/// Where more than noise is left and nothing is accepted: `before`, then what comes
/// closest, or what could still be tried; and on a line of its own the command that adds
/// it: `ladder` (ladder_words()) with it. Wrapped; ends without a line feed.
[[nodiscard]] std::string what_comes_closest(const std::string& before,
                                             const ExplainResult& result,
                                             const std::string& ladder);

/// A paragraph for each candidate, in their order: status, code, evidence, and of an
/// accepted one its parameters. Those turned down by the same sentence share a paragraph,
/// where the first of them stands.
[[nodiscard]] std::string candidates_text(std::span<const Candidate> candidates);

}  // namespace workbench::cli
