#include <algorithm>

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
        "The process has two storages. Tune for both lags, or use "
        "derivative action.",
    .harmless = true,
    .split = "log the stem position: what lies between it and y is the process",
};

class SecondLag final : public LagEffect {
 public:
  SecondLag() : LagEffect(kDescription, "second_lag") {}
  // As long as the first one may be: of two storages neither need settle within a
  // recording.
  [[nodiscard]] SearchedParameters searched(const Situation& situation) const override {
    SearchedParameters out = LagEffect::searched(situation);
    out.front().high = situation.duration_s();
    return out;
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    return filled("The output starts to move gently, as behind a second lag of {0} s.",
                  {number(p[0], 3)}) +
           (never_settles(s, p)
                ? std::string(
                      " Both lags are about as long as the recording: the process may "
                      "integrate instead, once or twice. Tune by neither before a "
                      "recording in which the output settles.")
                : std::string());
  }
  [[nodiscard]] std::string cure(const Situation& s, Reals p) const override {
    return never_settles(s, p)
               ? "Record until the output settles after a move of u, then look again."
               : Effect::cure(s, p);
  }
  void form(Reals p, ProcessShape& shape) const override { shape.second_lag_s = p[0]; }

 private:
  static bool never_settles(const Situation& s, Reals p) {
    constexpr double kLong = 0.5;  // of the recording
    return std::min(p[0], s.first_lag_s) > kLong * s.duration_s();
  }
};

}  // namespace

const Effect& process_second_lag() {
  static const SecondLag effect;
  return effect;
}

}  // namespace workbench::effects
