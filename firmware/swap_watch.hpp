// Tells when the signals called u and y were exchanged, in the window that was judged.
//
// Life: new → exchanged, any window of any loop. No heap; 72 KiB. Cost: six passes.
#pragma once

#include <array>
#include <cstddef>

#include "ident/base/configurations.hpp"
#include "ident/signal/sample_window.hpp"

namespace firmware {

class SwapWatch {
 public:
  using Window = ident::SampleWindow<float, ident::kStandardWindow>;

  /// Whether ident/signal/swap.hpp finds it in the newest `usable` samples.
  [[nodiscard]] bool exchanged(const Window& window, std::size_t usable);

 private:
  template <class Real>
  struct Signals {
    std::array<Real, ident::kStandardWindow> u;
    std::array<Real, ident::kStandardWindow> y;
    std::array<Real, ident::kStandardWindow> sp;
  };

  Signals<float> held_;
  Signals<double> wide_;
};

}  // namespace firmware
