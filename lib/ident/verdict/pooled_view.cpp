#include "ident/verdict/pooled_view.hpp"

#include <cmath>

#include "ident/verdict/judge.hpp"

namespace ident {

template <class Real>
PooledView view_of(const LadderFinding<Real>& pooled, float windows) {
  if (windows < 2.0f || pooled.predicted == 0) {
    return PooledView::kSilent;
  }
  if (pooled.nats > Real(kAloneNats) * std::sqrt(static_cast<Real>(windows))) {
    return PooledView::kSticks;
  }
  return pooled.nats < Real(0) ? PooledView::kNothing : PooledView::kSilent;
}

template PooledView view_of<float>(const LadderFinding<float>&, float);
template PooledView view_of<double>(const LadderFinding<double>&, float);

}  // namespace ident
