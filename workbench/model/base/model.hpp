// A model as data: the process, the physical effects in it, and how it came to be.
//
// A model simulates the output (y, or the valve position x) from u alone. Everything
// that the simulation needs is a named number with unit, interval and physical bounds,
// so that a model survives being written to a file and read back (model_json.hpp).
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// One number of a model. Plain values.
struct Parameter {
  std::string name;    ///< as in the JSON, with its unit in words: "first_lag"
  std::string unit{};  ///< "s", "u", "y", "y/u", "1"
  double value = 0;
  double low = 0;  ///< 95 % interval of the fit
  double high = 0;
  double bound_low = 0;  ///< physical bounds; low ≤ value ≤ high is not implied by them
  double bound_high = 0;
  bool derived = false;  ///< follows from the others: told, never set
};

/// One physical effect of a model, by its code in the catalogue (effects/catalogue.hpp).
struct EffectTerm {
  std::string effect;  ///< "valve.stiction"
  std::vector<Parameter> parameters{};
  bool phenomenological = false;  ///< helps only at the edge of its physical bounds
  bool untold = false;            ///< its intervals reach to where it would be absent
};

/// Root mean square errors one sample ahead, given the past of what is left, on samples
/// that were not fitted. Units of the output.
struct AheadErrors {
  double before = 0;
  double after = 0;

  [[nodiscard]] double share() const {  ///< of the squared error that went away
    return 1 - after * after / (before * before);
  }
};

/// One step of the history. Errors are free-run root mean square errors, units of the
/// output; "before" is null-like (NaN) for the start.
struct HistoryStep {
  std::string effect;     ///< code, or "process" for the start
  std::string recording;  ///< name of the recording it was fitted to
  double rmse_before = 0;
  double rmse_after = 0;
  double rmse_validation_before = 0;
  double rmse_validation_after = 0;
  std::optional<AheadErrors> ahead{};  ///< where only these tell the effect (W44)
};

/// The recording a model was fitted to, or several: their samples one after the other.
struct FittedRecording {
  std::string name;  ///< "a.csv", "a.csv, b.csv"
  std::size_t samples = 0;
  double period_s = 0;
  double first_u = 0;  ///< tells it from another recording of the same name
  double last_u = 0;
  /// fingerprint_of() the fitted samples of u and of the output. "": not known, of a file
  /// that an older version wrote.
  std::string fingerprint{};
};

/// 16 hexadecimal digits that tell samples from others, what beyond the seventh digit of
/// a value depends on the computer aside. O(samples).
[[nodiscard]] std::string fingerprint_of(
    std::initializer_list<std::span<const double>> signals);

/// Name of an initial state in a model of several pieces of recordings: the name itself
/// for the first, with its number for the others.
[[nodiscard]] std::string state_name(std::string_view name, std::size_t piece);

struct Model {
  Column output = Column::y;             ///< y or x
  std::vector<Parameter> process;        ///< gain, first_lag, offset …
  std::vector<EffectTerm> effects;       ///< in the order in which they were added
  std::vector<Parameter> initial_state;  ///< belongs to the recording, not to the plant
  FittedRecording fitted;
  std::vector<HistoryStep> history;
  /// The noise colour under which it was fitted (FreeRun::weigh_by); often empty.
  std::vector<double> noise{};

  [[nodiscard]] bool has(std::string_view effect) const;
  /// Codes of `effects`, in their order.
  [[nodiscard]] std::vector<std::string> effect_codes() const;
};

/// The parameter of that name; null where there is none.
[[nodiscard]] const Parameter* find(const std::vector<Parameter>& parameters,
                                    std::string_view name);

}  // namespace workbench
