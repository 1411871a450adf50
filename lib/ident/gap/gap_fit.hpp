// Least squares of a residual on what the model may change anyway and on one candidate's
// columns, judged on blocks that had no part in it.
#pragma once

#include <array>

namespace ident {

/// Sums over two folds of alternating blocks, equation (G3). Memory: 30 numbers.
template <class Real>
class GapFit {
 public:
  /// A constant and ŷ: what another offset and gain would change.
  static constexpr int kNuisances = 2;
  static constexpr int kMostColumns = 2;
  static constexpr int kUnknowns = kNuisances + kMostColumns;
  /// Nuisances and columns at one sample; an unused column is 0.
  using Row = std::array<Real, kUnknowns>;

  void clear() { folds_ = {}; }
  /// Takes one sample with residual e into fold 0 or 1. 15 multiplications.
  void add(int fold, const Row& row, Real e);
  /// Share of the error that the columns explain in each fold with the weights of the
  /// other, beyond the nuisances; 0 where they do not help. Constant time.
  [[nodiscard]] Real share(int columns) const;
  /// Weights of nuisances and columns on both folds; a column that the ones before it
  /// explain gets 0. Constant time.
  [[nodiscard]] Row weights() const;

 private:
  using Sums = std::array<Real, (kUnknowns + 1) * (kUnknowns + 2) / 2>;

  std::array<Sums, 2> folds_{};
};

}  // namespace ident
