#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.second_lag",
    .title = "a second process lag",
    .place = Place::kProcess,
    .view = View::kLag,
    .signature = kLagSignature,
    .cure =
        "Nothing is broken: the process has two storages. Tune for both lags, or use "
        "derivative action.",
    .split = "log the stem position: what lies between it and y is the process",
};

class SecondLag final : public LagEffect {
 public:
  SecondLag() : LagEffect(kDescription, "second_lag") {}
  // As long as the first one may be: of two storages neither need settle within a
  // recording.
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& situation) const override {
    std::vector<SearchedParameter> out = LagEffect::searched(situation);
    out.front().high = situation.duration_s();
    return out;
  }
  [[nodiscard]] std::string evidence(const Situation&, std::span<const double> p,
                                     std::span<const double>) const override {
    return filled("The output starts to move gently, as behind a second lag of {0} s.",
                  {number(p[0], 3)});
  }
  void form(std::span<const double> p, ProcessShape& shape) const override {
    shape.second_lag_s = p[0];
  }
};

}  // namespace

const Effect& process_second_lag() {
  static const SecondLag effect;
  return effect;
}

}  // namespace workbench::effects
