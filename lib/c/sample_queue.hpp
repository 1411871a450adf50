// Samples from an interrupt, or from another thread, to the one that steps.
//
// One pusher and one taker, neither of which waits for the other: each owns one counter
// and reads the other's. Only loads and stores, so that a Cortex-M needs neither locked
// instructions nor interrupts turned off. No heap, clock or exceptions.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace c {

/// `Size` is a power of two, so that the counters may wrap.
template <class Item, std::uint32_t Size>
class SampleQueue {
 public:
  static_assert((Size & (Size - 1)) == 0);
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

  /// By the pusher: false, and counted, when it is full. Constant time.
  bool push(const Item& item) {
    const std::uint32_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == Size) {
      refused_.store(refused() + 1, std::memory_order_relaxed);
      return false;
    }
    items_[end % Size] = item;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  /// By the taker: false when it is empty. Constant time.
  bool take(Item& item) {
    const std::uint32_t begin = begin_.load(std::memory_order_relaxed);
    if (end_.load(std::memory_order_acquire) == begin) return false;
    item = items_[begin % Size];
    begin_.store(begin + 1, std::memory_order_release);
    return true;
  }

  /// By the taker: how many wait, at least.
  [[nodiscard]] std::uint32_t size() const {
    return end_.load(std::memory_order_acquire) - begin_.load(std::memory_order_relaxed);
  }
  /// Pushes that found it full.
  [[nodiscard]] std::uint32_t refused() const {
    return refused_.load(std::memory_order_relaxed);
  }

 private:
  std::array<Item, Size> items_{};
  std::atomic<std::uint32_t> begin_ = 0;    // the taker's
  std::atomic<std::uint32_t> end_ = 0;      // the pusher's
  std::atomic<std::uint32_t> refused_ = 0;  // the pusher's
};

}  // namespace c
