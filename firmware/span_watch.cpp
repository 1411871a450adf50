#include "firmware/span_watch.hpp"

#include <algorithm>

namespace firmware {

bool SpanWatch::push(double u) {
  if (count_ == window_) count_ = 0;
  if (count_ == 0) {
    range_ = {u, u};
    outside_ = 0;
  }
  range_ = {std::min(range_[0], u), std::max(range_[1], u)};
  outside_ += u < span_[0] || u > span_[1] ? 1 : 0;
  return ++count_ == window_;
}

bool SpanWatch::doubted(bool oscillates) const {
  const double used = (range_[1] - range_[0]) / (span_[1] - span_[0]);
  return 2 * outside_ > window_ || (oscillates && used < kLeastShare);
}

}  // namespace firmware
