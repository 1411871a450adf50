// Which candidates may be u and y where their names do not say it outright.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/recording/named_signal.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/signal_choice.hpp"

namespace workbench {

/// The part of a name that means `column`.
[[nodiscard]] Part part_of(Column column);

/// Whether `of`, indices of `candidates` that may be u, is one CV alone: beside an MV the
/// controlled variable as well as the output of the controller.
[[nodiscard]] bool is_only_cv(const std::vector<NamedSignal>& candidates,
                              const std::vector<std::size_t>& of);

/// The candidates, an Input beside Output and a setpoint of one block as its measured
/// value: a controller's. Beside a PV, or without a setpoint, it stays open.
[[nodiscard]] std::vector<NamedSignal> with_block_inputs(
    std::vector<NamedSignal> candidates);

/// Whether the last word of the name is of an extreme or a spread: Min, Max, StdDev, ...
[[nodiscard]] bool is_extreme(const ColumnName& name);

/// For each of `wanted` a candidate whose name says so or hints at it, or, where as many
/// are left as are wanted, one whose name says nothing; of the test of a positioner its
/// position as y; candidates.size(): none. Good for an example, no more. `taken`: as long
/// as `candidates`, those that are something else.
[[nodiscard]] std::vector<std::size_t> suggested_signals(
    const std::vector<NamedSignal>& candidates, const std::vector<bool>& taken,
    const std::vector<Column>& wanted);

/// The candidates that alone may be u and y: the only output and the only measured value
/// of all, unless both are of instruments with different tags; or the only one of the two
/// and the only other signal, whose name must not speak against it. For u it must hint at
/// it; Input beside Output may be either. Empty: not so, or something else is wanted.
[[nodiscard]] std::vector<PickedSignal> only_signals(
    const std::vector<NamedSignal>& candidates, const std::vector<bool>& taken,
    const std::vector<Column>& wanted);

}  // namespace workbench
