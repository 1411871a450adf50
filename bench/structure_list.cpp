#include "bench/structure_list.hpp"

#include <array>
#include <cmath>

#include "ident/two_path/structure_search.hpp"

namespace bench {

template <class Real>
ident::KnotGrid<Real> uniform_grid() {
  ident::KnotGrid<Real> grid;
  for (ident::Path<Real>* path : {&grid.ascending, &grid.descending}) {
    path->segments = ident::kMaxSegments;
    for (int i = 0; i <= ident::kMaxSegments; ++i) {
      path->knots[i] = static_cast<Real>(i) / Real(ident::kMaxSegments);
    }
  }
  return grid;
}

template <class Real>
void sum_up(const ident::WindowView<Real>& window, ident::LaggedGram<Real>& gram) {
  gram.start(uniform_grid<Real>(), window);
  gram.step(static_cast<int>(window.u.size()));
}

template <class Real>
void StructureEvaluator<Real>::start(const ScaledWindow<Real>& window) {
  window_ = window.view();
  simulated_.resize(window.y.size());
  sum_up(window_, gram_);
}

template <class Real>
StructureFit<Real> StructureEvaluator<Real>::evaluate(const ident::Structure& structure) {
  StructureFit<Real> result;
  result.structure = structure;
  iteration_.start(gram_, structure, result.model);
  while (!iteration_.step()) {
  }
  if (!iteration_.solved() || !ident::is_stable(result.model.process)) {
    return result;
  }
  // The simulation starts from the first measured outputs.
  ident::InitialState<Real> initial{};
  for (int k = 0; k < structure.na; ++k) {
    const ident::WindowView<Real> head{window_.u.first(k + 1), window_.y.first(k + 1),
                                       window_.ascending.first(k + 1)};
    ident::simulate_paths<Real>(head, {}, result.model, initial, simulated_);
    initial[k] += window_.y[k] - simulated_[k];
  }
  const Real error =
      ident::simulate_paths<Real>(window_, {}, result.model, initial, simulated_);
  const int dimension = structure.na + structure.nb + 1 + structure.segments_ascending +
                        structure.segments_descending + 2;
  const Real samples = static_cast<Real>(window_.y.size());
  result.aic = samples * std::log(error) + Real(2) * static_cast<Real>(dimension);
  result.fit_percent = Real(100) * (Real(1) - std::sqrt(error / samples));
  result.known = std::isfinite(error);
  return result;
}

std::vector<StructureFit<double>> coordinate_sweep(const ScaledWindow<double>& window) {
  constexpr std::array<int, 6> kSegments{1, 2, 3, 4, 6, 12};
  constexpr int kSweeps = 3;
  const auto evaluator = std::make_unique<StructureEvaluator<double>>();
  evaluator->start(window);
  std::vector<StructureFit<double>> tried;
  ident::Structure centre{2, 2, 2, 6, 6};
  bool any = false;
  double centre_aic = 0;
  const auto attempt = [&](const ident::Structure& structure) {
    tried.push_back(evaluator->evaluate(structure));
    const StructureFit<double>& now = tried.back();
    if (now.known && ident::is_process_like(now.model.process) &&
        (!any || now.aic < centre_aic)) {
      any = true;
      centre = structure;
      centre_aic = now.aic;
    }
  };
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double before = centre_aic;
    const bool had_any = any;
    for (int nk = 0; nk <= ident::kMaxNk; ++nk) {
      ident::Structure s = centre;
      s.nk = nk;
      attempt(s);
    }
    for (int na = 1; na <= ident::kMaxNa; ++na) {
      for (int nb = 1; nb <= ident::kMaxNb; ++nb) {
        ident::Structure s = centre;
        s.na = na;
        s.nb = nb;
        attempt(s);
      }
    }
    for (const int segments : kSegments) {
      ident::Structure s = centre;
      s.segments_ascending = segments;
      attempt(s);
    }
    for (const int segments : kSegments) {
      ident::Structure s = centre;
      s.segments_descending = segments;
      attempt(s);
    }
    if (had_any && !(centre_aic < before)) {
      break;
    }
  }
  return tried;
}

template ident::KnotGrid<float> uniform_grid<float>();
template ident::KnotGrid<double> uniform_grid<double>();
template void sum_up<float>(const ident::WindowView<float>&, ident::LaggedGram<float>&);
template void sum_up<double>(const ident::WindowView<double>&,
                             ident::LaggedGram<double>&);
template class StructureEvaluator<float>;
template class StructureEvaluator<double>;

}  // namespace bench
