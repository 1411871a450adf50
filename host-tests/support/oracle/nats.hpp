// What a judge who sees the stem could tell from a recording.
#pragma once

#include <span>

namespace workbench::test {

/// Evidence in nats that `stem` tells more about the next y than `signal`:
///   m/2 · ln(V_signal / V_stem),
/// V the least squared error of y(t) on 20 lags of y, 20 lags of the input and a
/// constant, over the m samples that have all lags. Negative where the signal tells more;
/// 0 where y cannot be predicted at all or needs no input. All of one length, at least
/// 100.
[[nodiscard]] double oracle_nats(std::span<const double> y,
                                 std::span<const double> signal,
                                 std::span<const double> stem);

}  // namespace workbench::test
