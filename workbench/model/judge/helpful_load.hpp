// Which of the measured signals that a model does not use would help it most.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/model/base/model.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

struct HelpfulLoad {
  std::string name;
  double share = 0;  ///< of the squared validation error that it would take away, 0 … 1
};

/// Of `unused`, laid beside `recording` sample by sample, the one that takes away most of
/// what `model` leaves over there, where that is more than chance among so many. What
/// moves as u or the output does is another reading of them and no load. Nothing where a
/// model cannot be asked. Cost: a correlation for each signal and three short searches.
[[nodiscard]] std::optional<HelpfulLoad> helpful_load(
    const Recording& recording, const Model& model, const std::vector<Load>& unused,
    const Work& work = Work::unlimited());

}  // namespace workbench
