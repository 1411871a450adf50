// Instructions and stack of calls, measured on the emulated board.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace targets {

/// The board's timer runs at 25 MHz of a time that goes on by 2^6 ns with every
/// instruction (toolchains/cortex-m4f.cmake): 1.6 ticks are one instruction.
class InstructionTimer {
 public:
  InstructionTimer() {
    reg(kReload) = 0xFFFFFFFF;
    reg(kValue) = 0xFFFFFFFF;
    reg(kControl) = 1;
  }
  /// Counts down, wraps after 2.7·10⁹ instructions.
  [[nodiscard]] std::uint32_t ticks() const { return reg(kValue); }
  [[nodiscard]] static std::uint32_t instructions(std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(from - to) * 5 / 8);
  }

 private:
  static constexpr std::uintptr_t kTimer = 0x40000000;
  static constexpr std::uintptr_t kControl = 0x0;
  static constexpr std::uintptr_t kValue = 0x4;
  static constexpr std::uintptr_t kReload = 0x8;
  static volatile std::uint32_t& reg(std::uintptr_t offset) {
    return *reinterpret_cast<volatile std::uint32_t*>(kTimer + offset);
  }
};

struct CallFigures {
  const char* name = nullptr;
  std::int64_t calls = 0;
  std::int64_t instructions = 0;  ///< of all calls
  std::uint32_t most = 0;         ///< of one call
  std::uint32_t stack_bytes = 0;  ///< deepest of all calls
};

/// Paints the stack below itself before each call and looks afterwards how far the paint
/// is gone.
class CallMeter {
 public:
  template <class Call>
  auto around(const char* name, Call call) {
    if (!counts_) {
      return call();
    }
    CallFigures& figures = of(name);
    const std::uintptr_t top = stack_pointer();
    paint(top);
    const std::uint32_t from = timer_.ticks();
    const auto result = call();
    const std::uint32_t to = timer_.ticks();
    ++figures.calls;
    const std::uint32_t spent = InstructionTimer::instructions(from, to) - overhead_;
    figures.instructions += spent;
    if (spent > figures.most) {
      figures.most = spent;
    }
    const std::uint32_t used = painted_over(top);
    if (used > figures.stack_bytes) {
      figures.stack_bytes = used;
    }
    return result;
  }
  /// Counts from now on. What an empty call costs is taken off every figure.
  void start() {
    counts_ = true;
    const std::uint32_t from = timer_.ticks();
    const std::uint32_t to = timer_.ticks();
    overhead_ = InstructionTimer::instructions(from, to);
  }
  [[nodiscard]] const auto& figures() const { return figures_; }

 private:
  static constexpr std::uint32_t kPaint = 0xC5C5C5C5;
  static constexpr std::size_t kWords = 3072;

  [[gnu::always_inline]] static std::uintptr_t stack_pointer() {
    std::uintptr_t sp;
    asm volatile("mov %0, sp" : "=r"(sp));
    return sp;
  }
  [[gnu::always_inline]] static volatile std::uint32_t* bottom(std::uintptr_t top) {
    return reinterpret_cast<volatile std::uint32_t*>(top) - kWords;
  }
  [[gnu::always_inline]] static void paint(std::uintptr_t top) {
    volatile std::uint32_t* word = bottom(top);
    for (std::size_t k = 0; k < kWords; ++k) {
      word[k] = kPaint;
    }
  }
  [[gnu::always_inline]] static std::uint32_t painted_over(std::uintptr_t top) {
    volatile std::uint32_t* word = bottom(top);
    std::size_t k = 0;
    while (k < kWords && word[k] == kPaint) {
      ++k;
    }
    return static_cast<std::uint32_t>((kWords - k) * sizeof(std::uint32_t));
  }
  CallFigures& of(const char* name) {
    for (CallFigures& figures : figures_) {
      if (figures.name == nullptr || std::strcmp(figures.name, name) == 0) {
        figures.name = name;
        return figures;
      }
    }
    return figures_[0];
  }

  InstructionTimer timer_;
  bool counts_ = false;
  std::uint32_t overhead_ = 0;
  std::array<CallFigures, 3> figures_;
};

}  // namespace targets
