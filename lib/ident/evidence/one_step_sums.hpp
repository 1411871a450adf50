// Sums of squares and products from which the error of predicting y one sample ahead
// follows, for u or for any stem in its place.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "ident/base/limits.hpp"
#include "ident/evidence/lag_bins.hpp"

namespace ident {

/// Fewer predicted samples tell nothing of so many unknowns.
inline constexpr std::size_t kFewestRows = 60;

/// A signal of which every `thinning` samples count as their mean.
template <class Real>
struct ThinnedSignal {
  std::span<const Real> values;
  std::size_t thinning = 1;
};

/// y(t) − y(t−1) regressed on the lags (lag_bins.hpp) of y, a constant, and the lags of
/// one further signal z: docs/model.md (E10). What y brings is summed once, for every z.
/// Where stems are searched, the lags of a setpoint that moves stand beside y, too: u
/// answers it, and would know of y by that what no stem knows.
///
/// Life: `start`, `add` over all rows without a z, then for each z `begin_input`, `add`
/// over the same rows, `error`; where `begin_input` is given a second signal, it stands
/// beside z, as after `begin_bent_input` its square does.
/// And, while z is u, `begin_planted`, `add_planted` over the rows, `planted`.
/// A row is one predicted sample. The columns are differences of neighbouring bins and
/// the sums are taken in blocks, so that float keeps them to some 10⁻⁶ of themselves; no
/// column counts for less than that.
///
/// Cost a row, multiplications: 231 for y, 589 for z, 60 planted, 39 its error; beside a
/// setpoint 378, 703, 66, 45. `error`: a factorisation of 39 unknowns, 11,000
/// multiplications, 17,000 beside a setpoint. (19 bins.)
/// Memory: 460 numbers in the small sizes, 760 on a bare board, 2,400 where stems are
/// searched.
template <class Real>
class OneStepSums {
 public:
  static constexpr std::size_t kColumns =
      2 * kLagBins.size() + 2 +
      (kStemSearch ? std::max(kSetpointLagBins.size(), kNewestBeside) : 0);

  /// Begins anew with these of lag_bins.hpp, at most kLagBins.size(); they must outlive
  /// the sums.
  void start(std::span<const LagBin> bins);
  /// Where stems are searched, right after `start`: a setpoint as long as y times its
  /// thinning, which must outlive the sums, stands beside y.
  void stand_beside(const ThinnedSignal<Real>& setpoint);
  /// Where stems are searched `second`, which must outlive the rows, may stand beside
  /// each z: with so many of the newest bins, or, with coarse lags, with all.
  void begin_input(const ThinnedSignal<Real>& second = {},
                   std::size_t newest = kLagBins.size());
  /// Where stems are searched, and with coarse lags: (z − centre)² stands beside z.
  void begin_bent_input(Real centre);
  /// Rows first … last − 1 of y, `first` at least reach(): products with the lags of z
  /// and of what is beside it, or, where z is empty, those of y alone.
  void add(std::span<const Real> y, std::span<const Real> z, std::size_t first,
           std::size_t last);
  /// Sum of the squared errors of the prediction; above 0.
  [[nodiscard]] Real error();
  /// What each column brings to the prediction, for `add_planted` and `error_of`; after
  /// `error`.
  void solve_weights();
  /// Sum of the squared errors of some of the rows, with the weights of all.
  [[nodiscard]] Real error_of(std::span<const Real> y, std::span<const Real> z,
                              std::size_t first, std::size_t last) const;
  void begin_planted() { planted_ = {}; }
  /// As if y had followed a stem x = z + w in z's place: w, the rows as before.
  void add_planted(std::span<const Real> y, const ThinnedSignal<Real>& z,
                   std::span<const Real> w, std::size_t first, std::size_t last);
  /// Sum of squares that the prediction from z would have left of w's part in y.
  [[nodiscard]] Real planted() const;
  [[nodiscard]] std::size_t bins() const { return bins_.size(); }
  /// The oldest lag that is looked at, samples.
  [[nodiscard]] std::size_t reach() const {
    return static_cast<std::size_t>(bins_.back().last);
  }

 private:
  // That are laid and multiplied together: each sum is read and written once for all.
  static constexpr std::size_t kTogether = 4;
  using Row = std::array<Real, kColumns>;
  using Rows = std::array<Row, kTogether>;
  using Triangle = std::array<Real, kColumns*(kColumns + 1) / 2>;

  static constexpr std::size_t place(std::size_t row, std::size_t column) {
    return row * (row + 1) / 2 + column;
  }
  // Columns that are the same for every z.
  [[nodiscard]] std::size_t outputs() const {
    if constexpr (kStemSearch) {
      return bins_.size() + 2 + more_.setpoint_bins.size();
    } else {
      return bins_.size() + 2;
    }
  }
  [[nodiscard]] std::size_t columns() const {
    if constexpr (kStemSearch) {
      return outputs() + bins_.size() + more_.bins_beside;
    } else {
      return outputs() + bins_.size();
    }
  }
  void clear_inputs();
  template <class Value>
  static void lay(std::span<const LagBin> bins, const ThinnedSignal<Real>& v,
                  std::size_t t, std::size_t count, Rows& rows, std::size_t column,
                  Value value);
  void lay_bins(const ThinnedSignal<Real>& v, std::size_t t, std::size_t count,
                Rows& rows, std::size_t column) const {
    lay(bins_, v, t, count, rows, column, [](Real value) { return value; });
  }
  void lay_second(std::span<const Real> z, std::size_t t, std::size_t count,
                  Rows& rows) const;
  void lay_setpoint(std::size_t t, std::size_t count, Rows& rows,
                    std::size_t column) const;
  static void multiply(const Rows& rows, std::size_t from, std::size_t to,
                       Triangle& block);

  std::span<const LagBin> bins_ = kLagBins;
  // Columns: bins of y, 1, what is predicted, bins of the setpoint, bins of z.
  Triangle sums_{};
  // The same with what is predicted at the end; inverse pivots. While rows are added, the
  // sums of a block of them.
  Triangle factor_{};
  Row weights_{};  // of the same without what is predicted
  Row planted_{};  // sums of w's part with each column; its square last
  struct More {
    ThinnedSignal<Real> second;
    std::size_t bins_beside = 0;  // of what stands beside z
    ThinnedSignal<Real> setpoint;
    std::span<const LagBin> setpoint_bins;  // empty: no setpoint
    Real centre = 0;
    bool bent = false;  // the square of z around it stands beside z
  };
  struct NoMore {};
  [[no_unique_address]] std::conditional_t<kStemSearch, More, NoMore> more_;
};

}  // namespace ident
