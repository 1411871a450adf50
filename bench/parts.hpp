// The parts of an identification, each as one call on a prepared window.
#pragma once

#include <memory>
#include <vector>

#include "bench/example_window.hpp"
#include "bench/structure_list.hpp"
#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "ident/two_path/structure_search.hpp"
#include "ident/valve/valve_search.hpp"

namespace bench {

/// One full structure search; two-path or linear.
template <class Real>
class SearchPart {
 public:
  using Search = ident::StructureSearch<Real>;
  SearchPart(const ScaledWindow<Real>& window, typename Search::ValveKind kind)
      : window_(window), kind_(kind), scratch_(window.u.size()) {}
  const ident::StructureCandidate<Real>& run() {
    constexpr int kLargeBudget = 1000;
    search_->start(window_.view(), kind_, scratch_);
    while (!search_->step(kLargeBudget)) {
    }
    return search_->best();
  }

 private:
  const ScaledWindow<Real>& window_;
  typename Search::ValveKind kind_;
  std::vector<Real> scratch_;
  std::unique_ptr<Search> search_ = std::make_unique<Search>();
};

/// The search for the physical valve, on means of `kDecimation` samples.
template <class Real>
class ValvePart {
 public:
  explicit ValvePart(const ScaledWindow<Real>& window);
  void run();

 private:
  static constexpr int kDecimation = 4;
  std::vector<Real> means_;
  std::vector<Real> stem_;
  std::vector<Real> scratch_;
  ident::SearchWindow<Real> window_;
  std::unique_ptr<typename ident::ValveSearch<Real>::Stems> stems_ =
      std::make_unique<typename ident::ValveSearch<Real>::Stems>();
  std::unique_ptr<ident::ValveSearch<Real>> search_ =
      std::make_unique<ident::ValveSearch<Real>>();
};

/// One step of the refinement on the simulation error, from where the iteration ended.
template <class Real>
class RefinementPart {
 public:
  RefinementPart(const ScaledWindow<Real>& window, const ident::Structure& structure);
  Real run();

 private:
  const ScaledWindow<Real>& window_;
  ident::TwoPathModel<Real> model_;
  std::vector<Real> scratch_;
  std::unique_ptr<ident::OutputErrorFit<Real>> fit_ =
      std::make_unique<ident::OutputErrorFit<Real>>();
};

/// Everything, from a recording to a verdict.
template <class Real>
using WholeIdentifier = ident::Identifier<Real, ident::kLargeWindow>;

}  // namespace bench
