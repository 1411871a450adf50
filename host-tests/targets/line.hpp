// Lines of `name value` text without a heap or printf, the same on board and host.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace targets {

class Line {
 public:
  static constexpr std::size_t kLongest = 120;

  explicit Line(std::string_view name) { add(name); }
  Line& operator<<(std::string_view word) {
    add(" ");
    add(word);
    return *this;
  }
  Line& operator<<(std::int64_t value) {
    add(value < 0 ? " -" : " ");
    add_digits(value < 0 ? 0 - static_cast<std::uint64_t>(value)
                         : static_cast<std::uint64_t>(value),
               1);
    return *this;
  }
  /// Six decimals; what is beyond 10¹² or not a number becomes "?".
  template <class Real>
  Line& fixed(Real value) {
    constexpr Real kScale = Real(1e6);
    constexpr Real kMost = Real(1e12);
    if (!(std::abs(value) < kMost)) {
      return *this << "?";
    }
    add(value < Real(0) ? " -" : " ");
    const std::uint64_t scaled =
        static_cast<std::uint64_t>(std::abs(value) * kScale + Real(0.5));
    add_digits(scaled / 1'000'000, 1);
    add(".");
    add_digits(scaled % 1'000'000, 6);
    return *this;
  }
  /// The line with its end, ended by a zero.
  [[nodiscard]] const char* text() {
    text_[size_] = '\n';
    text_[size_ + 1] = '\0';
    return text_.data();
  }

 private:
  void add(std::string_view word) {
    for (const char c : word) {
      if (size_ < kLongest) {
        text_[size_++] = c;
      }
    }
  }
  void add_digits(std::uint64_t value, std::size_t least) {
    std::array<char, 20> digits;
    std::size_t first = digits.size();
    while (value != 0 || digits.size() - first < least) {
      digits[--first] = static_cast<char>('0' + value % 10);
      value /= 10;
    }
    add({digits.data() + first, digits.size() - first});
  }

  std::array<char, kLongest + 2> text_;
  std::size_t size_ = 0;
};

}  // namespace targets
