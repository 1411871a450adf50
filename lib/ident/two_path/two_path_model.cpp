#include "ident/two_path/two_path_model.hpp"

#include <cmath>

namespace ident {

template <class Real>
bool is_stable(const Process<Real>& process, Real margin) {
  // Roots inside the circle of radius 1 − margin: scale them out to radius 1 first.
  std::array<Real, kMaxNa> c{};
  const Real stretch = Real(1) / (Real(1) - margin);
  Real power = 1;
  for (int i = 0; i < process.na; ++i) {
    power *= stretch;
    c[i] = process.a[i] * power;
  }
  for (int order = process.na; order > 0; --order) {
    const Real k = c[order - 1];
    if (!(std::abs(k) < Real(1))) {
      return false;
    }
    const Real scale = Real(1) / (Real(1) - k * k);
    std::array<Real, kMaxNa> next{};
    for (int i = 0; i + 1 < order; ++i) {
      next[i] = (c[i] - k * c[order - 2 - i]) * scale;
    }
    c = next;
  }
  return true;
}

template bool is_stable<float>(const Process<float>&, float);
template bool is_stable<double>(const Process<double>&, double);

}  // namespace ident
