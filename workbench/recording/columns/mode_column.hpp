// The column that says whether the controller is in manual.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// The mode of the loop that `signal`, u or y, belongs to: a column MODE, A/M, AUTO,
/// MAN, AUTO/MAN, HAND, Betriebsart or the like with the same tag in front, or with none.
/// .ACTUAL and the like may follow. The first of several.
[[nodiscard]] std::optional<std::size_t> mode_column(
    const std::vector<LayoutColumn>& columns, std::size_t signal);

/// A cell of it as a code: kAutomatic for AUTO, A, CAS and other modes in which the
/// controller moves u; kManual for MAN, M, HAND, IMAN and other modes in which it does
/// not; a number as it is; kNoMode for anything else.
[[nodiscard]] double mode_code(std::string_view cell);
inline constexpr double kNoMode = -1;
inline constexpr double kAutomatic = -2;
inline constexpr double kManual = -3;

/// The stretches in manual, from the codes of all samples. What numbers mean is told by
/// the name, where that says AUTO or MAN alone; else by u, which rests in manual: a
/// number under which u hardly ever moves is manual if there is another under which it
/// mostly does. Nothing where that leaves it open. O(samples · different codes).
[[nodiscard]] std::vector<SampleRange> manual_stretches(std::span<const double> codes,
                                                        std::span<const double> u,
                                                        std::string_view name);

}  // namespace workbench
