// What the sum of several windows' closed-loop evidence amounts to.
#pragma once

#include <cmath>
#include <cstdint>

#include "ident/evidence/closed_loop_evidence.hpp"
#include "ident/verdict/judge.hpp"

namespace ident {

/// What the windows of a loop say together.
enum class PooledView : std::uint8_t {
  kSilent,   ///< neither
  kSticks,   ///< one stick band, beyond doubt
  kNothing,  ///< none serves all windows: each may have been fooled by something else
};

/// `pooled` is the sum of so many windows, each counted by its weight; of fewer than two
/// it says nothing that the newest window does not. What a wrong model brings by chance
/// in each window adds up like their root: one stick band beyond doubt needs kAloneNats
/// times that (judge.hpp).
template <class Real>
[[nodiscard]] PooledView view_of(const LadderFinding<Real>& pooled, float windows) {
  if (windows < 2.0f || pooled.predicted == 0) {
    return PooledView::kSilent;
  }
  if (pooled.nats > Real(kAloneNats) * std::sqrt(static_cast<Real>(windows))) {
    return PooledView::kSticks;
  }
  return pooled.nats < Real(0) ? PooledView::kNothing : PooledView::kSilent;
}

}  // namespace ident
