#include <algorithm>
#include <cmath>
#include <vector>

#include "ident/signal/differences.hpp"
#include "ident/signal/storage.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/effects/holds.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

// Samples that do not lie on the line between their neighbours, and both ends.
std::vector<std::size_t> stored_points(std::span<const double> y) {
  std::vector<std::size_t> out = {0};
  if (y.size() < 3) return out;
  const double straight = ident::measure_differences(y).straight;
  for (std::size_t k = 1; k + 1 < y.size(); ++k) {
    if (std::abs(y[k + 1] - 2 * y[k] + y[k - 1]) > straight) out.push_back(k);
  }
  out.push_back(y.size() - 1);
  return out;
}

// What an exception deadband leaves: a value is stored where it differs by more than the
// band from the stored one, and the value before it as well. 0 where the points are of
// another kind.
double exception_band(std::span<const double> y, std::span<const std::size_t> points) {
  constexpr std::size_t kFewest = 8;  // exceptions that tell the rule from chance
  constexpr double kMost = 0.9;       // of the pauses, that end in two points in a row
  constexpr double kRule = 0.05;      // of the exceptions may be for other reasons
  std::vector<double> before;
  std::vector<double> at;
  double pauses = 0;
  for (std::size_t i = 0; i + 2 < points.size(); ++i) {
    const std::size_t last = points[i];
    if (points[i + 1] - last < 2) continue;
    ++pauses;
    if (points[i + 2] != points[i + 1] + 1) continue;
    before.push_back(std::abs(y[points[i + 1]] - y[last]));
    at.push_back(std::abs(y[points[i + 2]] - y[last]));
  }
  if (at.size() < kFewest || static_cast<double>(at.size()) < kMost * pauses) return 0;
  const double low = quantile(before, 1 - kRule);
  const double high = quantile(at, kRule);
  return low < high ? (low + high) / 2 : 0;
}

// A point is stored because the line between its neighbours would miss what was measured:
// a quarter of the points lie nearer to that line than this.
double tolerance_of(std::span<const double> y, std::span<const std::size_t> points) {
  constexpr double kNear = 0.25;
  constexpr std::size_t kLong = 4;  // samples; shorter pieces were kept for other reasons
  std::vector<double> off;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const std::size_t a = points[i - 1];
    const std::size_t c = points[i + 1];
    if (c - a < kLong) continue;
    const double share = static_cast<double>(points[i] - a) / static_cast<double>(c - a);
    off.push_back(std::abs(y[points[i]] - (y[a] + share * (y[c] - y[a]))));
  }
  return off.empty() ? 0 : quantile(off, kNear);
}

// (W38) Whether a coarse resolution makes the straight pieces: a slow signal then moves
// by the same few steps for a while, and bends by one or two of them.
bool bends_by_steps(std::span<const double> y) {
  constexpr double kFew = 10;    // steps a move, to be counted
  constexpr double kOff = 0.15;  // of a step, by rounding
  constexpr double kMost = 0.9;  // of the moves
  constexpr double kBend = 2.5;  // steps
  const double straight = ident::measure_differences(y).straight;
  std::vector<double> moves;
  std::vector<double> bends;
  for (std::size_t k = 1; k < y.size(); ++k) {
    const double move = y[k] - y[k - 1];
    if (std::abs(move) > straight) moves.push_back(std::abs(move));
    if (k < 2) continue;
    const double bend = std::abs(move - (y[k - 1] - y[k - 2]));
    if (bend > straight) bends.push_back(bend);
  }
  if (moves.empty() || bends.empty()) return false;
  const double step = quantile(moves, 0.05);
  double few = 0;
  double whole = 0;
  for (const double move : moves) {
    if (move > (kFew + kOff) * step) continue;
    ++few;
    whole += std::abs(move / step - std::round(move / step)) < kOff;
  }
  return whole > kMost * few && 2 * few > static_cast<double>(moves.size()) &&
         quantile(bends, 0.5) < kBend * step;
}

// Straight pieces of y; or shorter ones, where u consists of them, too.
bool is_interpolated(const Situation& s) {
  constexpr double kMuch = 0.3;  // of the samples, not stored
  if (bends_by_steps(s.y)) return false;
  if (ident::find_storage(s.y).storage == ident::Storage::kInterpolated) {
    return true;
  }
  const auto stored = static_cast<double>(stored_points(s.y).size());
  return ident::find_storage(s.u).storage == ident::Storage::kInterpolated &&
         ident::find_storage(s.y).held < kMuch &&
         stored < (1 - kMuch) * static_cast<double>(s.samples());
}

// Whether most of the repeats are instants that no row was read for, and the rows are
// not those that left a band: a loop that asks when it can, not a historian.
bool is_own_doing(const Situation& s, const Held& held) {
  constexpr double kSmallest = 0.2;  // of a usual move: none is below a band
  return are_filled_in(s, held.share) && held.least_jump < kSmallest * held.usual_jump;
}

// Whether what holds them does so in the same rows.
bool are_read_together(std::span<const double> u, std::span<const double> y) {
  constexpr double kApart = 0.1;  // of the rows in which either changes
  double either = 0;
  double one = 0;
  for (std::size_t k = 1; k < y.size(); ++k) {
    const bool of_u = u[k] != u[k - 1];
    const bool of_y = y[k] != y[k - 1];
    either += of_u || of_y;
    one += of_u != of_y;
  }
  return one < kApart * either;
}

void draw_lines(std::span<const std::size_t> points, std::span<double> y) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::size_t a = points[i - 1];
    const std::size_t b = points[i];
    const double slope = (y[b] - y[a]) / static_cast<double>(b - a);
    for (std::size_t k = a + 1; k < b; ++k) {
      y[k] = y[a] + slope * static_cast<double>(k - a);
    }
  }
}

constexpr Description kDescription{
    .code = "record.compression",
    .title = "a record that was compressed",
    .place = Place::kRecord,
    .view = View::kTime,
    .signature = "moves in straight pieces or stairs between the points that were stored",
    .cure =
        "Switch off compression and exception deadband for both tags in the "
        "historian, or record at the controller.",
    .split =
        "record at the transmitter, with exception reporting switched off, or "
        "compare with a second sensor",
    .needs_u = false,
    .least_share = -0.005,
    .adds_up = true,
};

class Compression final : public Effect {
 public:
  Compression() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {
        {.name = "tolerance",
         .unit = "y",
         .high = std::max(s.y_span(), 1e-12),
         .constant = true,
         .within_factor = 2,
         .off = 0.0},
        {.name = "stored_share", .unit = "1", .high = 1, .constant = true, .off = 1.0},
        {.name = "held", .unit = "1", .high = 1, .constant = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    if (is_interpolated(s)) {
      const std::vector<std::size_t> points = stored_points(s.y);
      const double share =
          static_cast<double>(points.size()) / static_cast<double>(s.samples());
      const double band = exception_band(s.y, points);
      return {{band > 0 ? band : tolerance_of(s.y, points), share, 0}};
    }
    const Holder holder = who_holds(s.u, s.y);
    if (holder != Holder::kHistorian && holder != Holder::kEither) return {};
    const Held held = held_in(s.y, same_reading(s.y_low, s.y_high));
    if (is_own_doing(s, held)) return {};
    return {{held.least_jump, 1 - held.share, 1}};
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    return {static_cast<int>(p[1] * static_cast<double>(s.samples())), "stored points"};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    const double apart = 1 / std::max(p[1], 1e-6);
    const bool held = p[2] > 0.5;
    const bool by_exception = !held && exception_band(s.y, stored_points(s.y)) > 0;
    return filled(held ? "Only {0} % of the samples were stored, {1} samples apart on "
                         "average; the last value is held between them."
                  : by_exception
                      ? "Only {0} % of the samples were stored, {1} samples apart on "
                        "average: those that leave an exception deadband, each with the "
                        "one before it; straight lines lie between them."
                      : "Only {0} % of the samples were stored, {1} samples apart on "
                        "average; straight lines lie between them.",
                  {number(100 * p[1], 3), number(apart, 3)}) +
           (held && are_read_together(s.u, s.y)
                ? std::string(
                      " u and y change in the same rows: both were asked for together, "
                      "less often than there are rows. Then no compression is to be "
                      "switched off: export the rows that were read.")
                : std::string()) +
           filled(
               " What moves y by less than about {0} y or is over sooner, as noise, "
               "small jumps and dead time to within a few samples, was lost.",
               {number(p[0], 2)});
  }
  // Lines and holds are in the data, whatever the model.
  [[nodiscard]] std::optional<double> own_test(const Situation&, Reals) const override {
    return 1e-12;
  }
  void record(Reals p, const Situation& s, std::span<double> y) const override {
    if (p[2] > 0.5) {
      hold_like(s.y, same_reading(s.y_low, s.y_high), y);
    } else {
      draw_lines(stored_points(s.y), y);
    }
  }
};

}  // namespace

const Effect& record_compression() {
  static const Compression effect;
  return effect;
}

}  // namespace workbench::effects
