#include <optional>
#include <span>
#include <vector>

#include "ident/signal/range_end.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "sensor.saturation",
    .title = "a reading at the end of its range",
    .place = Place::kRecord,
    .view = View::kLevel,
    .signature =
        "is one-sided: the reading repeats its highest or lowest value to the last digit",
    .cure =
        "Widen the range of the transmitter, or look for an overflow or an empty vessel.",
    .split = "compare with a second sensor, or widen the range of this one",
    .needs_u = false,
    .least_share = -0.005,
    .adds_up = true,
};

class Saturation final : public Effect {
 public:
  Saturation() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    const auto level = [&s](std::string_view name) {
      return SearchedParameter{
          .name = name, .unit = "y", .low = s.y_low, .high = s.y_high, .constant = true};
    };
    const auto share = [](std::string_view name) {
      return SearchedParameter{
          .name = name, .unit = "1", .high = 1, .constant = true, .off = 0.0};
    };
    return {level("lower_end"), share("lower_share"), level("upper_end"),
            share("upper_share")};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const ident::RangeEnd lower = ident::find_range_end(s.y, false);
    const ident::RangeEnd upper = ident::find_range_end(s.y, true);
    if (lower.stays + upper.stays == 0) return {};
    return {{s.y_low, lower.share, s.y_high, upper.share}};
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    return {static_cast<int>(cut_off(p, s.y).size()),
            "stays of the reading at the end of its range", 1};
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    const bool upper = p[kUpperShare] > 0;
    if (upper && p[kLowerShare] > 0) {
      return filled(
          "For {0} % of the samples the reading stands at {1}, its highest value, and "
          "for {2} % at {3}, its lowest, to the last digit: it is cut off there. These "
          "samples are left out of the fit.",
          {number(100 * p[kUpperShare], 3), number(p[kUpperEnd], 4),
           number(100 * p[kLowerShare], 3), number(p[kLowerEnd], 4)});
    }
    return filled(
        upper ? "For {0} % of the samples the reading stands at {1}, its highest value, "
                "to the last digit: it is cut off there. These samples are left out of "
                "the fit."
              : "For {0} % of the samples the reading stands at {1}, its lowest value, "
                "to the last digit: it is cut off there. These samples are left out of "
                "the fit.",
        {number(100 * p[upper ? kUpperShare : kLowerShare], 3),
         number(p[upper ? kUpperEnd : kLowerEnd], 4)});
  }
  // Readings that noise moves elsewhere do not repeat by chance.
  [[nodiscard]] std::optional<double> own_test(const Situation&, Reals) const override {
    return 1e-12;
  }
  // What is cut off may be anywhere beyond: nothing is to be explained there.
  void record(Reals p, const Situation& s, std::span<double> y) const override {
    for (const SampleRange& range : cut_off(p, s.y)) {
      for (std::size_t k = range.first; k < range.last; ++k) y[k] = s.y[k];
    }
  }
  bool record_part(Reals p, const Situation& s, std::span<double> part) const override {
    for (const SampleRange& range : cut_off(p, s.y)) {
      for (std::size_t k = range.first; k < range.last; ++k) part[k] = 0;
    }
    return true;
  }

 private:
  enum Parameter : std::size_t { kLowerEnd, kLowerShare, kUpperEnd, kUpperShare };

  // What noise let out for a moment is left out, too: it shows the noise of one sign.
  static std::vector<SampleRange> cut_off(Reals p, std::span<const double> y) {
    constexpr std::size_t kMoment = 8;  // samples
    std::vector<SampleRange> out;
    for (std::size_t k = 0; k < y.size(); ++k) {
      const bool is_cut = (p[kLowerShare] > 0 && y[k] <= p[kLowerEnd]) ||
                          (p[kUpperShare] > 0 && y[k] >= p[kUpperEnd]);
      if (!is_cut) continue;
      if (out.empty() || k - out.back().last >= kMoment) out.push_back({k, k});
      out.back().last = k + 1;
    }
    return out;
  }
};

}  // namespace

const Effect& sensor_saturation() {
  static const Saturation effect;
  return effect;
}

}  // namespace workbench::effects
