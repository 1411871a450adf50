// Whether anything is left in a residual that another model could explain.
#pragma once

#include <array>
#include <cstddef>

namespace ident {

/// Below this nothing is left to explain.
inline constexpr double kWhiteResidual = 2;

/// (T5) How far a residual is from Gaussian white noise, in standard deviations, the
/// larger of two: how much longer it keeps its sign, the largest of Σ r(k)·√(n/K) over k
/// = 1 … K and K = 1, 2, 4, 8, 16 with r the autocorrelation; and its excess kurtosis,
/// √(n/24)·(m₄/m₂² − 3). A valve that is modelled wrongly shifts the output for as long
/// as the process remembers, or for the moment by which its slips come too early. White
/// noise exceeds 2 in one case of ten. 0 for an error of 0 or fewer than 32 samples.
///
/// Life: new → add, sample by sample → value. Memory: 35 numbers.
template <class Real>
class ResidualStructure {
 public:
  /// What one sample takes on a Cortex-M4F, instructions, most.
  static constexpr int kPerSample = 200;

  /// The residual at the next sample.
  void add(Real e);
  [[nodiscard]] Real value() const;

 private:
  static constexpr std::size_t kLags = 16;

  std::array<Real, kLags> ring_{};
  std::array<Real, kLags> products_{};
  Real square_ = 0;
  Real fourth_ = 0;
  std::size_t count_ = 0;
};

}  // namespace ident
