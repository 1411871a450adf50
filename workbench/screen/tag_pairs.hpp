// Which tags of an export make a loop.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/signal_choice.hpp"

namespace workbench {

/// How tags are paired beyond the usual names.
///
/// `rules`: u/y, u/y/sp or u/y/sp/x with one * each that stands for the tag, several
/// separated by commas: "*.OUT/*.PV/*.SP,*_AO/*_PV"; without a * the names themselves,
/// or #3 for the third column: "LV_106/FT_115". They come before the usual names.
/// `list`: the loops themselves, by name; nothing else is paired then.
struct PairRules {
  struct Rule {
    std::string u;
    std::string y;
    std::string sp;  ///< "" none
    std::string x;
  };
  struct Named {
    std::string loop;
    Rule tags;
  };
  std::vector<Rule> rules;
  std::vector<Named> list;

  /// From the text of --pairs: rules, or the name of a CSV file with the columns loop, u,
  /// y and perhaps sp, x. Throws std::invalid_argument for what is neither, and
  /// InputError for a list that cannot be read.
  [[nodiscard]] static PairRules parse(const std::string& text);
};

/// The signals of one loop: indices of candidates.
struct TagLoop {
  std::string name;  ///< the tag as written; "" where the columns are only u, y, ...
  std::size_t u = 0;
  std::size_t y = 0;
  std::optional<std::size_t> sp;
  std::optional<std::size_t> x;
};

struct TagPairs {
  std::vector<TagLoop> loops;         ///< in the order of the file
  std::vector<std::size_t> unpaired;  ///< measured signals of no loop
  /// Of a tag with two columns that may both be u, or y: "FIC101: both 'a' and 'b'".
  std::vector<std::string> doubts;
};

/// Pairs `candidates` by rules, then by what column_name.hpp knows of names: one tag with
/// u (OP, OUT, CO, ...) and y (PV, ...), or blocks of one loop apart
/// (FIC101.PIDA.OP, FIC101.DACA.PV). Without regard to case. O(n log n).
[[nodiscard]] TagPairs pair_tags(const std::vector<NamedSignal>& candidates,
                                 const PairRules& rules);

}  // namespace workbench
