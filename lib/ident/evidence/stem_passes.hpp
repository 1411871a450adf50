// Passes over the rows of a window in which one stem after the other stands where u does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/base/configurations.hpp"
#include "ident/base/elementary.hpp"
#include "ident/base/limits.hpp"
#include "ident/evidence/lag_bins.hpp"
#include "ident/evidence/one_step_sums.hpp"
#include "ident/evidence/spoken_parts.hpp"

namespace ident {

/// The window that is asked. Spans and sums must outlive the evidence.
template <class Real>
struct EvidenceWindow {
  std::span<const Real> u;  ///< scaled, oldest first
  std::span<const Real> y;  ///< zero mean, unit variance; as long
  std::span<Real> scratch;  ///< as long
  OneStepSums<Real>* sums = nullptr;
  Real period = 0;  ///< of u, samples
  Real swing = 1;   ///< usual distance of two turning points, unit of u
  Real span = 1;    ///< of u, unit of u: the ladder's
};

/// The means of `thinning` samples each, as many as `to` holds: there, or, where one
/// sample is its own mean, where they are.
template <class Real>
std::span<const Real> thin_out(std::span<const Real> from, std::size_t thinning,
                               std::span<Real> to) {
  if (thinning == 1) {
    return from.first(to.size());
  }
  for (std::size_t t = 0; t < to.size(); ++t) {
    Real sum = 0;
    for (std::size_t k = 0; k < thinning; ++k) {
      sum += from[t * thinning + k];
    }
    to[t] = sum / static_cast<Real>(thinning);
  }
  return to;
}

/// What free parameters cost where so many rows are predicted, nats (Schwarz's BIC).
template <class Real>
[[nodiscard]] Real cost_of(int parameters, std::size_t rows) {
  return static_cast<Real>(parameters) / Real(2) *
         elementary::log(static_cast<Real>(rows));
}

/// What is summed of a stem (one_step_sums.hpp).
enum class PassOf : std::uint8_t {
  kStem,           ///< the stem where u stood
  kStemAndU,       ///< u beside it
  kStemAndNewest,  ///< only the newest lags of u beside it
  kStemAndSquare,  ///< its square beside it
  kPlanted         ///< what it lacks of u, planted in y
};

/// (E10) One stem after the other, each laid over the window and then summed, in pieces.
/// The window is thinned out to kEvidencePerCycle samples a cycle where that leaves 500.
///
/// Life: `start`; for each set of lags `begin`, and `piece` until it takes u itself; then
/// for each stem `next`, and `piece` until it takes that. `nats` of what was taken; where
/// the parts of the window are asked, `divide`, and `piece` until it takes the same
/// again. Cost: that of the sums for each row. Pieces of about a unit.
///
/// kRowsOfOutput: rows of y in a piece, which is a block of the sums.
template <class Real, std::size_t kRowsOfOutput = 16>
class StemPasses {
 public:
  void start(const EvidenceWindow<Real>& window);
  /// Thins out y, unless the first piece has to.
  void thin();
  /// By these lags, as many as the window bears; false, and nothing changes, where it is
  /// too short for them.
  bool begin(std::span<const LagBin> bins, PassOf of_u = PassOf::kStem) {
    return begin_at(0, lag_bins_for(count_, bins), of_u);
  }
  /// By all of these, which must outlive the passes; no row before `first`.
  bool begin_at(std::size_t first, std::span<const LagBin> bins,
                PassOf of_u = PassOf::kStem);
  /// Right after `begin`: a setpoint as long as u, in any unit, beside every stem.
  void stand_beside(std::span<const Real> setpoint) {
    sums().stand_beside({setpoint, thinning_});
  }
  void next(PassOf of = PassOf::kStem) {
    of_ = of;
    follows_ = false;
    begin_stem();
  }
  /// `move` takes the next u and returns where the stem is then; of no account for u
  /// itself. Calls `take` where a pass is over. Returns what the piece cost, in
  /// hundredths of a unit.
  template <class Move, class Take>
  int piece(Move move, Take take);
  /// Whether the pass is that of u itself.
  [[nodiscard]] bool follows() const { return follows_; }
  /// m/2·ln(V_u/V_x) of the stem that was summed, before any cost; 0 of u itself.
  [[nodiscard]] Real nats();
  /// Asks the parts (E14); after `nats`.
  void divide();
  [[nodiscard]] bool divided() const { return divided_; }
  /// (E14) Of `nats` those that are left where no part counts for too much.
  [[nodiscard]] Real without_excess(Real nats) const {
    return parts_.without_excess(nats);
  }

  [[nodiscard]] const EvidenceWindow<Real>& window() const { return window_; }
  [[nodiscard]] OneStepSums<Real>& sums() { return *window_.sums; }
  [[nodiscard]] std::span<const Real> y() const { return y_; }  ///< thinned
  [[nodiscard]] std::size_t count() const { return count_; }    ///< of thinned samples
  [[nodiscard]] std::size_t thinning() const { return thinning_; }
  /// m, those that are predicted; 0 before `begin`.
  [[nodiscard]] std::size_t rows() const { return count_ - first_; }
  /// V_u, the squared error of the prediction with u.
  [[nodiscard]] Real error_of_u() const { return error_of_u_; }

 private:
  enum class Stage : std::uint8_t { kThin, kOutput, kLay, kInput, kPlant, kParts, kOver };
  static constexpr std::size_t kSamplesOfStem = 1024;  // a piece

  [[nodiscard]] bool plants() const { return of_ == PassOf::kPlanted; }
  [[nodiscard]] std::span<Real> stem() const { return window_.scratch.first(count_); }
  void begin_stem() {
    next_ = 0;
    divided_ = false;
    stage_ = Stage::kLay;
  }
  template <class Move>
  int lay_some(Move move);
  void begin_rows();
  int sum_some();
  int sum_part();

  EvidenceWindow<Real> window_;
  std::span<const Real> y_;
  std::size_t thinning_ = 1;
  std::size_t count_ = 0;
  std::size_t first_ = 0;  // row
  std::size_t next_ = 0;   // sample, or part
  Real error_of_u_ = 0;
  Real log_of_u_ = 0;  // of this error
  SpokenParts<Real> parts_;
  PassOf of_ = PassOf::kStem;
  bool follows_ = false;
  bool divided_ = false;
  Stage stage_ = Stage::kOver;
};

template <class Real, std::size_t kRowsOfOutput>
template <class Move>
int StemPasses<Real, kRowsOfOutput>::lay_some(Move move) {
  const bool lacks = plants();
  const std::size_t end = std::min(next_ + kSamplesOfStem / thinning_, count_);
  for (; next_ < end; ++next_) {
    Real sum = 0;
    for (std::size_t k = 0; k < thinning_; ++k) {
      const Real u = window_.u[next_ * thinning_ + k];
      sum += (follows_ ? u : move(u)) - (lacks ? u : Real(0));
    }
    stem()[next_] = sum / static_cast<Real>(thinning_);
  }
  if (next_ == count_) {
    begin_rows();
  }
  return kUnit / 2;
}

template <class Real, std::size_t kRowsOfOutput>
template <class Move, class Take>
int StemPasses<Real, kRowsOfOutput>::piece(Move move, Take take) {
  const int cost = stage_ == Stage::kLay ? lay_some(move) : sum_some();
  if (stage_ == Stage::kOver) {
    take();
  }
  return cost;
}

}  // namespace ident
