// Tells when u does not run where the configured span says that it does.
//
// Life: new → push, sample by sample → once it is true, doubted. A window of u doubts the
// span when most of it lies outside, or when the loop oscillates and u uses less than
// kLeastShare of it. Percentages of span mean nothing then, the alarm's limit least of
// all. Constant time, no heap.
#pragma once

#include <array>
#include <cstddef>

namespace firmware {

class SpanWatch {
 public:
  static constexpr double kLeastShare = 0.02;

  /// `span`: low and high, units of u; `window`: samples, ≥ 1.
  SpanWatch(const std::array<double, 2>& span, std::size_t window)
      : span_(span), window_(window) {}

  /// Takes the next sample of u; true: it completes a window.
  [[nodiscard]] bool push(double u);
  /// Of the window that is complete.
  [[nodiscard]] bool doubted(bool oscillates) const;
  /// Its lowest and its highest u.
  [[nodiscard]] const std::array<double, 2>& range() const { return range_; }

 private:
  std::array<double, 2> span_;
  std::size_t window_;
  std::array<double, 2> range_{};
  std::size_t count_ = 0;    // samples of the window
  std::size_t outside_ = 0;  // of them
};

}  // namespace firmware
