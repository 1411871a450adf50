// Whether the detectable bands that were told are true, for the scorers.
#pragma once

#include <cstdio>
#include <vector>

#include "ident/verdict/identification.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench::test {

class DetectableTally {
 public:
  /// `wider_band`: the true one, unit of u; 0: nothing sticks.
  void add(const ident::Identification<double>& found, double wider_band) {
    const double told = found.detectable_band;
    if (wider_band > 0) {
      ++sticking_;
      told_ += told > 0 ? 1 : 0;
      narrower_ += told > 0 && told < wider_band ? 1 : 0;
    } else if (found.verdict == ident::Verdict::kNoStiction) {
      ++denied_;
      if (told > 0) shares_.push_back(found.evidence.ladder.detectable_band);
    }
  }
  void print() const {
    std::printf(
        "\nDetectable band: told to %d of %d sticking loops, to %d of them one narrower "
        "than theirs; to %zu of %d healthy loops that do not stick",
        told_, sticking_, narrower_, shares_.size(), denied_);
    if (!shares_.empty())
      std::printf(", median %.0f %% of the swing", 100 * median(shares_));
    std::printf("\n");
  }

 private:
  int sticking_ = 0;
  int told_ = 0;
  int narrower_ = 0;
  int denied_ = 0;
  std::vector<double> shares_;  // of the swing of u
};

}  // namespace workbench::test
