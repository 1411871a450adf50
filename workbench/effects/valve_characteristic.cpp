#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/effects/held_levels.hpp"
#include "workbench/effects/two_pieces.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "valve.characteristic",
    .title = "a nonlinear valve characteristic",
    .place = Place::kCharacteristic,
    .view = View::kLevel,
    .signature = "bends with the level of u, rising and falling alike",
    .cure =
        "Choose another trim, let split ranges meet, or linearise the "
        "signal in the controller.",
    .harmless = true,
    .split =
        "hold u at several levels long enough for y to settle, and log the stem "
        "position",
};

class Characteristic final : public ShownByMoves {
 public:
  Characteristic() : ShownByMoves(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    SearchedParameters out = curve_parameters(s);
    // What passes e⁻⁸ of the usual flow passes none. Of the curvature alone objection()
    // says how much is too much.
    out[0].low = -kMostBend;
    out[0].high = kMostBend;
    out[0].open_ends = true;
    out.push_back(
        {.name = "free_shape", .unit = "1", .high = 1, .constant = true, .off = 0.0});
    for (const std::string_view name : kBends) {
      out.push_back({.name = name,
                     .unit = "1",
                     .low = -kMostBend,
                     .high = kMostBend,
                     .only_with = "free_shape",
                     .open_ends = true});
    }
    out.push_back(
        {.name = "two_pieces", .unit = "1", .high = 1, .constant = true, .off = 0.0});
    out.push_back({.name = "parted_at",
                   .unit = "u",
                   .low = s.u_low,
                   .high = s.u_high,
                   .only_with = "two_pieces"});
    out.push_back({.name = "dead_width",
                   .unit = "u",
                   .high = s.u_span(),
                   .only_with = "two_pieces",
                   .open_floor = true});
    return out;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    const auto add = [&](double curvature, double free, std::array<double, 5> bends) {
      Values values = {curvature, s.u_low, s.u_high, free};
      values.insert(values.end(), bends.begin(), bends.end());
      values.insert(values.end(), {0, std::midpoint(s.u_low, s.u_high), 0});
      out.push_back(std::move(values));
    };
    for (const Values& start : curve_starts(s)) add(start[0], 0, {});
    // As many moves of u as a free shape has parameters fit anything.
    const int moves = std::max(moves_of_u(s).events, levels_held(s.u));
    if (moves >= kMovesOfPieces) {
      const auto add_pieces = [&](double slope, double at, double dead) {
        add(slope, 0, {});
        std::copy_n(std::array{1.0, at, dead * s.u_span()}.begin(), 3,
                    out.back().begin() + kPieces);
      };
      for (const double share : {0.25, 0.5, 0.75}) {
        const double at = std::lerp(s.u_low, s.u_high, share);
        add_pieces(0, at, 0.15);
        add_pieces(-1, at, 0);
        add_pieces(1, at, 0);
      }
      // A drive that turns both ways.
      if (s.u_low < 0 && s.u_high > 0) add_pieces(0, 0, 0.1);
    }
    if (moves < kMovesOfShape) return out;
    if (const auto seen = seen_in(s)) add(seen->curvature, 1, seen->bends);
    add(0, 1, {-0.5, -1, -1, -1, -0.5});  // steep at both ends
    add(0, 1, {0.5, 1, 1, 1, 0.5});       // S-shaped
    add(1, 1, {-2, -1, 0, 0, 0});         // dead at the seat
    add(-1, 1, {0, 0, 0, -1, -2});        // full before it is open
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    return takes_two_values(s) ? none_between() : ShownByMoves::excitation(s, p);
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return words(p);
  }
  [[nodiscard]] std::string objection(const Situation&, Reals p, Reals) const override {
    constexpr double kEnd = 0.1;  // of the range of u
    if (is_parted(p)) {
      const TwoPieces curve = pieces(p);
      const bool at_end =
          std::min(curve.below() - p[1], p[2] - curve.above()) < kEnd * (p[2] - p[1]);
      return at_end ? "one of its two pieces is next to none: that is a limit, or a seat"
                    : "";
    }
    return p[3] > 0.5 || std::abs(p[0]) < kMostCurvature
               ? ""
               : "no trim changes its gain so much from end to end";
  }
  [[nodiscard]] OptionalForm optional_form() const override {
    return {.constant = "two_pieces", .parameters = kOfPieces};
  }
  [[nodiscard]] std::optional<NamedCurve> named_curve(Reals p) const override {
    constexpr std::size_t kShown = 21;
    if (p.size() < kPieces) return std::nullopt;
    Values values(p.begin(), p.begin() + kPieces);
    if (p[3] <= 0.5) std::fill(values.begin() + 4, values.end(), 0.0);
    const ShapedCurve shaped(values);
    const bool parted = is_parted(p);
    NamedCurve out;
    out.kind = parted ? kOther.code : kind_of(shaped).code;
    out.words = words(p);
    out.inside = parted ? kInsideParted : p[3] > 0.5 ? kInsideFree : kInsideBent;
    for (std::size_t i = 0; i < kShown; ++i) {
      const double at = static_cast<double>(i) / (kShown - 1);
      const double share = parted ? pieces(p).share(at) : shaped.share(at);
      out.points.push_back({std::lerp(p[1], p[2], at), std::lerp(p[1], p[2], share)});
    }
    return out;
  }
  void move(Reals p, ValveSignal& signal) const override {
    if (is_parted(p)) {
      pieces(p).bend(signal.v);
    } else if (p[3] > 0.5) {
      ShapedCurve(p).bend(signal.v);
    } else {
      Curve{p[0], p[1], p[2]}.bend(signal.v);
    }
  }

 private:
  // A seat that is dead has next to no slope.
  static constexpr double kMostBend = 8;
  static constexpr double kMostCurvature = 5;
  static constexpr int kMovesOfShape = 10;
  static constexpr int kMovesOfPieces = 6;
  static constexpr std::array<std::string_view, 5> kBends = {"bend_1", "bend_2", "bend_3",
                                                             "bend_4", "bend_5"};

  // Behind from, to and the free shape.
  static constexpr std::ptrdiff_t kPieces = 4 + kBends.size();
  static constexpr std::array<std::string_view, 10> kInside = {
      "curvature", "free_shape", "bend_1",     "bend_2",    "bend_3",
      "bend_4",    "bend_5",     "two_pieces", "parted_at", "dead_width"};
  // Of a free shape the curvature from end to end says nothing by itself, of two pieces
  // neither.
  static constexpr std::span<const std::string_view> kInsideFree = kInside;
  static constexpr std::span<const std::string_view> kInsideBent =
      std::span(kInside).subspan(1);
  static constexpr std::span<const std::string_view> kInsideParted =
      std::span(kInside).first(8);

  static constexpr std::array<std::string_view, 2> kOfPieces = {"parted_at",
                                                                "dead_width"};

  static bool is_parted(Reals p) { return p.size() > kPieces && p[kPieces] > 0.5; }
  static TwoPieces pieces(Reals p) {
    return {p[1], p[2], p[kPieces + 1], p[kPieces + 2], std::exp(p[0])};
  }

  // A monotone curve over from … to with both ends fixed. The logarithm of its slope is
  // made of straight pieces: `curvature` from end to end, and a bend at each sixth.
  class ShapedCurve {
   public:
    explicit ShapedCurve(Reals p) : from_(p[1]), span_(p[2] - p[1]) {
      constexpr double kPieces = 6;
      double sum = 0;
      for (std::size_t i = 0; i < kPoints; ++i) {
        const double share = (static_cast<double>(i) - 0.5) / (kPoints - 1);
        const double place = std::clamp(share, 0.0, 1.0) * kPieces;
        const auto piece = std::min<std::size_t>(static_cast<std::size_t>(place), 5);
        const double left = piece > 0 ? p[3 + piece] : 0;
        const double right = piece < 5 ? p[4 + piece] : 0;
        const double bend = std::lerp(left, right, place - static_cast<double>(piece));
        if (i > 0) sum += std::exp(p[0] * std::clamp(share, 0.0, 1.0) + bend);
        way_[i] = sum;
      }
      for (double& way : way_) way /= sum;
    }

    // Of the way from one end to the other at a share of the range.
    [[nodiscard]] double share(double at) const {
      const double inside = at > 0 ? std::min(at, 1.0) : 0;  // NaN: 0
      const double place = inside * static_cast<double>(kPoints - 1) * (1 - 1e-12);
      const auto i = static_cast<std::size_t>(place);
      return std::lerp(way_[i], way_[i + 1], place - static_cast<double>(i));
    }
    // Slope over a tenth of the range, relative to that of the whole.
    [[nodiscard]] double slope(double at) const {
      return (share(at + 0.05) - share(at - 0.05)) /
             (std::min(at + 0.05, 1.0) - std::max(at - 0.05, 0.0));
    }
    void bend(std::span<double> signal) const {
      if (!(span_ > 0)) return;
      for (double& value : signal) value = from_ + span_ * share((value - from_) / span_);
    }

   private:
    static constexpr std::size_t kPoints = 241;

    double from_;
    double span_;
    std::array<double, kPoints> way_{};
  };

  // No curve is told to a tenth of a percent.
  static std::string percent_of_way(double share) {
    return number(std::round(1000 * share) / 10, 3);
  }

  static std::string words(Reals p) {
    if (is_parted(p)) return words_of_pieces(p);
    if (p[3] > 0.5) {
      const ShapedCurve curve(p);
      return filled(
          "Flow follows u along {0}: at a quarter, half and three quarters of the range "
          "of u it has come {1}, {2} and {3} % of its way.",
          {std::string(kind_of(curve).words), percent_of_way(curve.share(0.25)),
           percent_of_way(curve.share(0.5)), percent_of_way(curve.share(0.75))});
    }
    return filled(p[0] > 0
                      ? "The valve passes {0} times as much flow per unit of u at the "
                        "{1} end of the range of u as at the other (equal-percentage)."
                      : "The valve passes {0} times as much flow per unit of u at the "
                        "{1} end of the range of u as at the other (quick-opening).",
                  {number(std::exp(std::abs(p[0])), 3), p[0] > 0 ? "upper" : "lower"});
  }

  static std::string words_of_pieces(Reals p) {
    constexpr double kDead = 0.01;  // of the range of u
    constexpr double kOther = 0.1;  // of a slope
    const TwoPieces curve = pieces(p);
    const bool dead = curve.above() - curve.below() > kDead * (p[2] - p[1]);
    const std::string gap =
        dead ? filled("Between {0} and {1} of u nothing changes.",
                      {number(curve.below(), 3), number(curve.above(), 3)})
             : "";
    if (dead && std::abs(p[0]) < kOther) return gap;
    return filled("Above {0} of u the same move of u changes {1} times as much as below.",
                  {number(curve.above(), 3), number(std::exp(p[0]), 3)}) +
           (dead ? " " + gap : "");
  }

  struct Bent {
    double curvature = 0;
    std::array<double, kBends.size()> bends{};
  };
  // The shape through what y came to at each level of a sweep: a lag that is too slow
  // hides it from a search.
  static std::optional<Bent> seen_in(const Situation& s) {
    constexpr double kPieces = 6;
    constexpr double kShut = 0.01;  // slope that is none
    const std::optional<SettledCurve> settled = SettledCurve::seen_in(s);
    if (!settled) return std::nullopt;
    const auto y_at = [&](double share) {
      return (*settled)(s.u_low + share * s.u_span());
    };
    const double way = y_at(1) - y_at(0);
    if (way == 0) return std::nullopt;
    std::array<double, kBends.size() + 2> steepness{};
    for (std::size_t i = 0; i < steepness.size(); ++i) {
      const double from = std::max(static_cast<double>(i) - 0.5, 0.0) / kPieces;
      const double to = std::min(static_cast<double>(i) + 0.5, kPieces) / kPieces;
      const double slope = (y_at(to) - y_at(from)) / way / (to - from);
      steepness[i] = std::log(std::max(slope, kShut));
    }
    Bent out;
    out.curvature = steepness.back() - steepness.front();
    for (std::size_t i = 0; i < out.bends.size(); ++i) {
      const double along = out.curvature * static_cast<double>(i + 1) / kPieces;
      out.bends[i] = steepness[i + 1] - steepness.front() - along;
    }
    return out;
  }

  struct Kind {
    std::string_view code;
    std::string_view words;
  };
  static constexpr Kind kOther{"other", "a curve of its own"};
  static Kind kind_of(const ShapedCurve& curve) {
    constexpr double kDead = 0.1;
    constexpr double kSteeper = 1.2;
    constexpr double kBreak = 4;
    constexpr double kStillOpen = 0.3;
    const double low = curve.slope(0.05);
    const double middle = curve.slope(0.5);
    const double high = curve.slope(0.95);
    // The slope of an equal-percentage trim, too, is small at the seat, but it grows by
    // the same factor from there to the middle as from the middle on.
    const bool grows_at_once = middle < kDead || middle * middle > kBreak * low * high;
    const bool stays_open = high > kStillOpen * middle;
    if (low < kDead && high > low && grows_at_once && stays_open) {
      return {"dead_at_seat", "a curve that is dead at the seat"};
    }
    if (middle > kSteeper * low && middle > kSteeper * high) {
      return {"s_shaped", "an S-shaped curve"};
    }
    if (high > kSteeper * middle && middle > kSteeper * low) {
      return {"equal_percentage", "an equal-percentage curve"};
    }
    if (low > kSteeper * middle && middle > kSteeper * high) {
      return {"quick_opening", "a quick-opening curve"};
    }
    return kOther;
  }
};

}  // namespace

const Effect& valve_characteristic() {
  static const Characteristic effect;
  return effect;
}

}  // namespace workbench::effects
