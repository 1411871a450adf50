// The paper's Example 5.1 as the identifier sees it: scaled, with marked directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ident/two_path/lagged_gram.hpp"
#include "workbench/simulate/simulated_loop.hpp"

namespace bench {

inline constexpr std::uint64_t kSeed = 1;
inline constexpr std::size_t kSamples = 2800;  ///< of Example 5.1

/// The simulated recording; made once.
[[nodiscard]] const workbench::SimulatedLoop& example();
/// u and y of the recording's first `samples` samples, in the asked precision.
template <class Real>
[[nodiscard]] std::vector<Real> example_u(std::size_t samples = kSamples);
template <class Real>
[[nodiscard]] std::vector<Real> example_y(std::size_t samples = kSamples);

/// A window that owns its samples: u in 0 … 1, y with zero mean and unit variance,
/// directions by the zig-zag rule at 30 % of the range of u.
template <class Real>
struct ScaledWindow {
  std::vector<Real> u;
  std::vector<Real> y;
  std::vector<unsigned char> ascending;

  [[nodiscard]] ident::WindowView<Real> view() const { return {u, y, ascending}; }
};

/// Cost: four passes.
template <class Real>
[[nodiscard]] ScaledWindow<Real> scaled_window(std::span<const Real> u,
                                               std::span<const Real> y);

/// The first `samples` samples of the example, scaled.
template <class Real>
[[nodiscard]] ScaledWindow<Real> example_window(std::size_t samples = kSamples);

}  // namespace bench
