// Where the unknowns of an OutputErrorFit stand in its sums.
#pragma once

#include "ident/two_path/two_path_model.hpp"

namespace ident {

/// Order of the unknowns: a, b, d, initial state, κ, increments of both paths.
template <class Real>
struct Unknowns {
  Unknowns(const TwoPathModel<Real>& model, bool with_paths)
      : na(model.process.na),
        nb(model.process.nb),
        ascending(with_paths ? model.ascending.segments : 0),
        descending(with_paths ? model.descending.segments : 0),
        paths(with_paths) {}
  [[nodiscard]] int b() const { return na; }
  [[nodiscard]] int d() const { return na + nb; }
  [[nodiscard]] int initial() const { return na + nb + 1; }
  [[nodiscard]] int offset() const { return initial() + na; }
  [[nodiscard]] int increments() const { return offset() + 1; }
  [[nodiscard]] int count() const {
    return paths ? increments() + ascending + descending : offset();
  }
  int na;
  int nb;
  int ascending;
  int descending;
  bool paths;
};

}  // namespace ident
