// Switches of the instrumented copy that mutants.py makes. Every file of the copy
// includes this; what is evaluated by the compiler is never changed.
#pragma once

#include <type_traits>

namespace mutant {

inline constexpr int kMost = 1 << 15;
inline int active = 0;                ///< number of the mutant that is on, 0: none
inline unsigned char reached[kMost];  ///< points that ran, until somebody clears them

[[gnu::always_inline]] inline constexpr bool is(int point) {
  if (std::is_constant_evaluated()) return false;
  reached[point] = 1;
  return active == point;
}

#define MUTANT_OPERATOR(Name, op)                                           \
  struct Name {                                                             \
    template <class A, class B>                                             \
    [[gnu::always_inline]] static constexpr auto of(const A& a, const B& b) \
        -> decltype(a op b) {                                               \
      return a op b;                                                        \
    }                                                                       \
  };
MUTANT_OPERATOR(Less, <)
MUTANT_OPERATOR(LessEqual, <=)
MUTANT_OPERATOR(Greater, >)
MUTANT_OPERATOR(GreaterEqual, >=)
MUTANT_OPERATOR(Equal, ==)
MUTANT_OPERATOR(NotEqual, !=)
MUTANT_OPERATOR(Plus, +)
MUTANT_OPERATOR(Minus, -)
MUTANT_OPERATOR(Times, *)
MUTANT_OPERATOR(Over, /)
MUTANT_OPERATOR(Left, <<)
MUTANT_OPERATOR(Right, >>)
MUTANT_OPERATOR(BitAnd, &)
MUTANT_OPERATOR(BitOr, |)
#undef MUTANT_OPERATOR

/// Was(a, b), or Becomes(a, b); only of numbers, so that matrices stay as they are.
template <int kPoint, class Was, class Becomes, class A, class B>
[[gnu::always_inline]] inline constexpr auto binary(const A& a, const B& b) {
  using Result = decltype(Was::of(a, b));
  if constexpr (std::is_arithmetic_v<Result> && requires { Becomes::of(a, b); }) {
    return is(kPoint) ? static_cast<Result>(Becomes::of(a, b)) : Was::of(a, b);
  } else {
    return Was::of(a, b);
  }
}

/// A condition, or its opposite.
template <int kPoint, class T>
[[gnu::always_inline]] inline constexpr bool flip(const T& value) {
  return is(kPoint) != static_cast<bool>(value);
}

/// A number, or one more, or for true false.
template <int kPoint, class T>
[[gnu::always_inline]] inline constexpr T next(T value) {
  if constexpr (std::is_same_v<T, bool>) {
    return is(kPoint) != value;
  } else if constexpr (std::is_arithmetic_v<T>) {
    return is(kPoint) ? static_cast<T>(value + 1) : value;
  } else {
    return value;
  }
}

/// A number, or twice that; for nought one.
template <int kPoint, class T>
[[gnu::always_inline]] inline constexpr T twice(T value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return is(kPoint) ? (value == T(0) ? T(1) : static_cast<T>(2 * value)) : value;
  } else {
    return value;
  }
}

}  // namespace mutant
