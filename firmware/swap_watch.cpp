#include "firmware/swap_watch.hpp"

#include <algorithm>
#include <span>

#include "ident/signal/signal_scale.hpp"
#include "ident/signal/swap.hpp"

namespace firmware {

bool SwapWatch::exchanged(const Window& window, std::size_t usable) {
  const std::size_t most = std::min(usable, held_.u.size());
  const std::size_t count =
      window.copy(std::span(held_.u).first(most), held_.y, held_.sp);
  const auto widened = [count](const auto& from, auto& to) {
    std::copy_n(from.begin(), count, to.begin());
    return std::span<const double>(to).first(count);
  };
  std::span<const double> sp;
  if (ident::all_finite<float>(std::span(held_.sp).first(count))) {
    sp = widened(held_.sp, wide_.sp);
  }
  return ident::are_swapped(widened(held_.u, wide_.u), widened(held_.y, wide_.y), sp);
}

}  // namespace firmware
