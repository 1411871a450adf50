#include "ident/signal/seam.hpp"

#include <algorithm>
#include <cmath>

#include "ident/signal/controller_action.hpp"

namespace ident {
namespace {

// How many times further than anywhere else a signal jumps at a seam, or its law fails.
constexpr double kClear = 3;
// Samples on each side that must lie on their own side of the jump.
constexpr std::size_t kSide = 4;
// Share of the jump of u that the law may leave over where it explains it.
constexpr double kLeft = 0.5;
constexpr std::size_t kFewest = 16;

struct Signals {
  std::span<const double> u;
  std::span<const double> y;
  std::span<const double> sp;
};

// The largest moves of a signal, largest first.
struct Moves {
  static constexpr std::size_t kKept = Seams::kMost + 1;
  std::array<double, kKept> size{};
  std::array<std::size_t, kKept> at{};

  void take(double move, std::size_t t) {
    if (!(move > size[kKept - 1])) {
      return;
    }
    std::size_t place = kKept - 1;
    for (std::size_t k = kKept - 1; k > 0 && move > size[k - 1]; --k) {
      size[k] = size[k - 1];
      at[k] = at[k - 1];
      place = k - 1;
    }
    size[place] = move;
    at[place] = t;
  }

  [[nodiscard]] bool among_first(std::size_t count, std::size_t t) const {
    const auto end = at.begin() + static_cast<std::ptrdiff_t>(count);
    return std::find(at.begin(), end, t) != end;
  }

  [[nodiscard]] double clearness(std::size_t count) const {
    return size[count] > 0 ? size[count - 1] / size[count] : 0.0;
  }
};

// Whether the samples before and after the jump to `t` lie apart: no spike.
bool stays(std::span<const double> x, std::size_t t) {
  const double middle = (x[t - 1] + x[t]) / 2;
  const bool up = x[t] > x[t - 1];
  const std::size_t before = t - std::min(t, kSide);
  const std::size_t after = std::min(x.size(), t + kSide);
  for (std::size_t k = before; k < after; ++k) {
    if ((x[k] > middle) != ((k >= t) == up)) {
      return false;
    }
  }
  return true;
}

// The m largest moves of y; whether u has its own, as clear, at the same m places.
bool find_moves(const Signals& s, Seams& seams) {
  Moves of_u;
  Moves of_y;
  for (std::size_t t = 1; t < s.u.size(); ++t) {
    of_u.take(std::abs(s.u[t] - s.u[t - 1]), t);
    of_y.take(std::abs(s.y[t] - s.y[t - 1]), t);
  }
  bool found_in_u = false;
  for (std::size_t count = 1; count <= Seams::kMost; ++count) {
    bool jumps = of_y.clearness(count) > kClear;
    bool u_jumps = of_u.clearness(count) > kClear;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t t = of_y.at[k];
      jumps = jumps && stays(s.y, t);
      u_jumps = u_jumps && of_u.among_first(count, t) && stays(s.u, t);
    }
    if (jumps && (u_jumps || !found_in_u)) {
      found_in_u = u_jumps;
      seams.count = count;
      const auto end = std::copy_n(of_y.at.begin(), count, seams.at.begin());
      std::sort(seams.at.begin(), end);
    }
  }
  return found_in_u;
}

void measure_parts(std::size_t samples, Seams& seams) {
  seams.first = 0;
  seams.length = 0;
  std::size_t first = 0;
  for (std::size_t k = 0; k <= seams.count; ++k) {
    const std::size_t end = k < seams.count ? seams.at[k] : samples;
    if (end - first > seams.length) {
      seams.first = first;
      seams.length = end - first;
    }
    first = end;
  }
}

// Keeps the places at which u breaks with the law of the longest part.
void check_law(const Signals& s, const ControllerAction<double>& law, bool found_in_u,
               Seams& seams) {
  const auto error = [&](std::size_t t) {
    return (s.sp.empty() ? 0.0 : s.sp[t]) - s.y[t];
  };
  const auto missed = [&](std::size_t t) {
    return s.u[t] - s.u[t - 1] - law.proportional * (error(t) - error(t - 1)) -
           law.integral * error(t);
  };
  double usual = 0;
  const std::size_t end = seams.first + seams.length;
  for (std::size_t t = seams.first + 1; t < end; ++t) {
    usual += missed(t) / static_cast<double>(seams.length - 1);
  }
  Moves misses;
  for (std::size_t t = 1; t < s.u.size(); ++t) {
    misses.take(std::abs(missed(t) - usual), t);
  }
  const std::size_t count = seams.count;
  const bool law_fails = misses.clearness(count) > kClear;
  seams.count = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t t = seams.at[k];
    const bool jumps =
        found_in_u && std::abs(missed(t) - usual) > kLeft * std::abs(s.u[t] - s.u[t - 1]);
    if (jumps || (law_fails && misses.among_first(count, t))) {
      seams.at[seams.count++] = t;
    }
  }
}

}  // namespace

Seams find_seams(std::span<const double> u, std::span<const double> y,
                 std::span<const double> sp) {
  Seams seams;
  seams.length = u.size();
  if (u.size() < kFewest) {
    return seams;
  }
  const Signals signals{u, y, sp};
  const bool found_in_u = find_moves(signals, seams);
  measure_parts(u.size(), seams);
  if (seams.count == 0) {
    return seams;
  }
  const auto part = [&](std::span<const double> x) {
    return x.empty() ? x : x.subspan(seams.first, seams.length);
  };
  const auto law = controller_action<double>(part(u), part(y), part(sp));
  if (law.sign != 0) {
    check_law(signals, law, found_in_u, seams);
  } else if (!found_in_u) {
    seams.count = 0;
  }
  measure_parts(u.size(), seams);
  return seams;
}

}  // namespace ident
