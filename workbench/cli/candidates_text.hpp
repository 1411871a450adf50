// What explain() says of its candidates, for a terminal of 80 columns.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "workbench/model/search/explain.hpp"

namespace workbench::cli {

/// "dead time, and with it a second process lag".
[[nodiscard]] std::string titles_of(const Candidate& candidate);

/// "What is missing: dead time." and, where the recording cannot tell it from others,
/// what it may be instead.
[[nodiscard]] std::string missing_in_words(const Candidate& best);

/// What a further search could begin with.
struct SearchSoFar {
  std::string ladder;                   ///< ladder_words()
  std::vector<std::string> in_model;    ///< effects
  std::vector<std::string> begun_with;  ///< effects of --with
  bool has_further_columns = false;     ///< that move, and were not used
  std::string keep = {};                ///< file of its model; "": it is not kept
};

/// "stickband ladder a.csv --with … -o m2.json": from the effects in the model and `more`
/// on; "" for a search that begins as this one did, or with nothing.
[[nodiscard]] std::string search_on(const SearchSoFar& so_far,
                                    const std::vector<std::string>& more = {});

/// Where more than noise is left and nothing is accepted: `before`, then what comes
/// closest, or what could still be tried; and on a line of its own the command that adds
/// it. Wrapped; ends without a line feed.
[[nodiscard]] std::string what_comes_closest(const std::string& before,
                                             const ExplainResult& result,
                                             const SearchSoFar& so_far);

/// A paragraph for each candidate, in their order: status, code, evidence, and of an
/// accepted one its parameters. Those turned down by the same sentence share a paragraph,
/// where the first of them stands.
[[nodiscard]] std::string candidates_text(std::span<const Candidate> candidates);

}  // namespace workbench::cli
