// A physical effect: all that the workbench knows about it, behind one interface.
//
// Everything else (fit, tests, catalogue, texts, files) is derived from what an effect
// says here; docs/adding-an-effect.md walks through a new one. Effects are stateless: one
// object serves all recordings and threads.
//
// The chain they act in:
//   u → positioner lag → rate limit → friction → saturation → characteristic → v
//   (a stem slower than its signal stops at its limit: the signal is cut off there, too)
//   v → dead time, lags or integrator → z → bend → gain·z + offset + loads
//     → overflow → sensor lag → recorded output
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/effects/process_shape.hpp"
#include "workbench/effects/situation.hpp"

namespace workbench {

/// Place in the chain, in the order of the signal.
enum class Place {
  kPositioner,
  kRate,
  kFriction,
  kLimit,
  kCharacteristic,
  kProcess,
  kLoad,
  kOverflow,
  kSensor,
  kRecord,
};

/// The coordinates in which a residual is looked at (compare.hpp).
enum class View { kTime, kPhase, kLevel, kDirection, kSpeed, kTravel, kFrequency, kLag };

/// A parameter the search moves, within bounds that depend on the recording.
struct SearchedParameter {
  std::string_view name;
  std::string_view unit;
  double low = 0;  ///< physical bounds; finite, low ≤ high
  double high = 0;
  bool logarithmic = false;  ///< searched by its logarithm; low > 0
  bool jumpy = false;        ///< the error is not smooth in it: pattern search
  bool constant = false;     ///< given by the start, not searched
  bool instant = false;      ///< a time since the first sample
  bool sudden = false;       ///< an instant that only the samples around it tell
  double within_factor = 1;  ///< a constant may be off by this factor, either way
  /// Searched only where this constant of the same effect is above 0.5.
  std::string_view only_with = {};
  bool initial = false;     ///< belongs to the recording, not to the plant
  bool open_floor = false;  ///< below `low` nothing changes: resting there is no edge
  bool open_ends = false;   ///< nor above `high`
  std::optional<double> off = std::nullopt;  ///< where the effect would be absent
  bool optional = false;  ///< counts as a parameter only where it is not off
  double resolution = 0;  ///< the interval is no narrower than plus or minus this
};

using SearchedParameters = std::vector<SearchedParameter>;

/// A parameter that enters linearly: the factor of one column, solved by least squares.
struct SolvedParameter {
  std::string_view name;
  std::string_view unit;
  bool strength = true;  ///< zero means that the effect is absent
  bool each = false;     ///< has another value in each piece of a recording
  std::string_view integrated_unit = {};  ///< where the process integrates what it adds
};

/// A number that people ask for and the search does not know: the sum of two searched
/// ones of the same unit, told beside them with an interval of its own.
struct DerivedParameter {
  std::string_view name;
  std::string_view unit;
  std::array<std::string_view, 2> sum_of;
};

/// Values of the searched parameters, in the order of `searched`.
using Values = std::vector<double>;

/// Values of parameters that an effect reads: `p` the searched ones, `c` the solved ones.
using Reals = std::span<const double>;

/// The valve's signal on its way from u to v: the mean over each sampling interval, with
/// the weight of the lag that follows.
struct ValveSignal {
  double period_s = 0;
  std::span<double> v;       ///< units of u, changed in place
  std::size_t at_rest = 0;   ///< samples until a stem of unknown position first moves
  double process_lag_s = 0;  ///< first lag behind the valve; 0: an integrator
  double settling_s = 0;     ///< lag of a stem that need not be at rest at first
  bool weighed = false;      ///< the lag behind the valve had a part in v

  [[nodiscard]] IntervalWeight weight() {
    weighed = true;
    return {period_s, process_lag_s};
  }
};

/// What a load is added to, and with what dynamics it may arrive.
struct LoadSetting {
  double period_s = 0;
  std::span<const double> z;  ///< process response of unit gain, units of u
  const ProcessShape& shape;
  std::span<const Load> loads;  ///< recorded ones, less their first value
  double start_s = 0;           ///< time of the first sample of these, see Situation
};

/// Columns for the solved parameters, each as long as the piece of the recording.
using Columns = std::span<std::span<double>>;

/// Where the output is cut off.
struct Ceiling {
  double level = 0;            ///< units of the output
  bool spills = false;         ///< a storage is full, not only a reading at its end
  bool before_second = false;  ///< the second lag follows the full storage
};

/// How often the recording exercised an effect.
struct Excitation {
  int events = 0;         ///< independent ones
  std::string_view what;  ///< plural, "reversals of u wider than the stick band"
  int least = 5;          ///< with fewer it has to show beyond doubt (W15)
  bool acted = true;      ///< false: not even that counts
};
/// Of moves, reversals and stays at a limit: what happened once may be chance, and is not
/// on both sides of the split into fitted samples and judging ones.
inline constexpr int kLeastMoves = 2;

/// What an effect is called and what to do about it. Static text.
struct Description {
  std::string_view code;   ///< "valve.stiction", as in files and on the command line
  std::string_view title;  ///< "stiction", within a sentence
  Place place;
  View view;                   ///< where its signature shows
  std::string_view signature;  ///< what is seen there, after "the residual "
  std::string_view cure;       ///< what a technician does about it
  bool harmless = false;       ///< of a sound plant: nothing is broken
  std::string_view split;      ///< the measurement that tells it from look-alikes
  bool needs_u = true;         ///< invisible where u does not move y
  /// Of the squared error, to be taken away where the effect's own test speaks for it.
  double least_share = 0.05;
  bool sticks = false;    ///< starts from Situation::stems, too
  bool bends = false;     ///< a process that no linear one imitates
  bool recorded = false;  ///< a load that the recording holds
  bool limits = false;    ///< acts only beyond a level, which may lie out of reach
  bool adds_up = false;   ///< the record of a sum is the sum of the records

  [[nodiscard]] constexpr bool is_load() const { return place == Place::kLoad; }
  [[nodiscard]] constexpr bool is_unmeasured_load() const {
    return is_load() && !recorded;
  }
  /// The order in which effects of one model are told: that of the signal, but what lies
  /// in the loop and can be mended before a load that nobody measured.
  [[nodiscard]] constexpr bool is_told_before(const Description& other) const {
    return is_unmeasured_load() == other.is_unmeasured_load()
               ? place < other.place
               : other.is_unmeasured_load();
  }
  /// A stem that does not follow every move of its signal, by stiction or play.
  [[nodiscard]] constexpr bool is_stem() const { return place == Place::kFriction; }
};

/// A monotone curve that an effect bends the signal of the valve along.
struct NamedCurve {
  /// "equal_percentage", "quick_opening", "s_shaped", "dead_at_seat" or "other".
  std::string_view kind;
  std::vector<std::array<double, 2>> points;  ///< signal before and after, units of u
  std::string words;                          ///< the same as a sentence
  std::span<const std::string_view> inside;   ///< parameters that the curve tells better
};

/// A form that an effect may take, and the parameters that mean nothing where it has not.
struct OptionalForm {
  std::string_view constant;  ///< above 0.5 where it is taken; empty: no such form
  std::span<const std::string_view> parameters = {};
};

class Effect {
 public:
  /// The description must outlive the effect.
  explicit Effect(const Description& description) : description_(description) {}
  virtual ~Effect() = default;

  [[nodiscard]] const Description& description() const { return description_; }
  [[nodiscard]] std::string_view code() const { return description().code; }

  /// Parameters to search on this recording; may be empty.
  [[nodiscard]] virtual SearchedParameters searched(const Situation&) const { return {}; }
  /// Parameters that are solved; may be empty. Their names do not depend on data.
  [[nodiscard]] virtual std::span<const SolvedParameter> solved() const { return {}; }
  /// What follows from the searched parameters; empty for most effects.
  [[nodiscard]] virtual std::span<const DerivedParameter> derived() const { return {}; }
  /// Points to start the search from, read from recording and residual; at least one
  /// where anything is searched. Tens of them are cheap.
  [[nodiscard]] virtual std::vector<Values> starts(const Situation&) const {
    return {Values{}};
  }
  /// Events that the effect with these parameters acted in.
  [[nodiscard]] virtual Excitation excitation(const Situation& situation,
                                              Reals p) const = 0;
  /// One sentence: what in the data speaks for it. `p` searched, `c` solved.
  [[nodiscard]] virtual std::string evidence(const Situation& situation, Reals p,
                                             Reals c) const = 0;
  /// What to do about it with these values: another cure where that of the description
  /// does not fit them or the length of the recording.
  [[nodiscard]] virtual std::string cure(const Situation&, Reals /*p*/) const {
    return std::string(description().cure);
  }
  /// Why these values cannot be this effect although they are within their bounds, as the
  /// end of a sentence that begins "but "; empty where nothing speaks against them.
  [[nodiscard]] virtual std::string objection(const Situation&, Reals /*p*/,
                                              Reals /*c*/) const {
    return {};
  }
  /// The same where each of its derived parameters may be as low as `lows` say.
  [[nodiscard]] virtual std::string doubt(const Situation&, Reals /*p*/,
                                          Reals /*lows*/) const {
    return {};
  }
  /// Whether a bound at which one of these values rests is where the physics ends, too,
  /// as that of a tank that runs empty: a value beyond could mean nothing else.
  [[nodiscard]] virtual bool ends_there(Reals /*p*/) const { return false; }
  /// The curve that the searched parameters stand for; nothing for most effects.
  [[nodiscard]] virtual std::optional<NamedCurve> named_curve(Reals /*p*/) const {
    return std::nullopt;
  }
  /// The form that it may take or not; none for most effects.
  [[nodiscard]] virtual OptionalForm optional_form() const { return {}; }
  /// Of a limit: why it may never show although it is there, one sentence; empty where
  /// nothing in u says so.
  [[nodiscard]] virtual std::string out_of_reach(const Situation&) const { return {}; }
  /// p-value of a test of the effect's own, for one that the data show without a
  /// simulation; nothing for most effects.
  [[nodiscard]] virtual std::optional<double> own_test(const Situation&,
                                                       Reals /*p*/) const {
    return std::nullopt;
  }

  /// p-value of a test that it has to pass beside those of all effects: of a load, that
  /// slow noise does not look like it. `c` solved; Situation::residual is that of the
  /// model with the effect.
  [[nodiscard]] virtual double noise_test(const Situation&, Reals /*p*/,
                                          Reals /*c*/) const {
    return 0;
  }

  // Simulation: an effect overrides the one hook of its place.
  virtual void move(Reals /*p*/, ValveSignal& /*signal*/) const {}
  virtual void form(Reals /*p*/, ProcessShape& /*shape*/) const {}
  /// Bends the process response `z` (units of u) in place.
  virtual void bend(Reals /*p*/, std::span<double> /*z*/) const {}
  /// Fills one column for each solved parameter.
  virtual void load(Reals /*p*/, const LoadSetting& /*setting*/,
                    Columns /*columns*/) const {}
  /// Level above which the output is cut off; nothing for most effects.
  [[nodiscard]] virtual std::optional<Ceiling> ceiling(Reals /*p*/) const {
    return std::nullopt;
  }
  /// From the output to what is recorded, in place. When a sensor let go of its reading
  /// and which points a historian kept is read off the recorded output.
  virtual void record(Reals /*p*/, const Situation&, std::span<double> /*y*/) const {}
  /// The same for one of the signals that the output is a sum of, in place. False where
  /// that cannot be said: the record is rounded, say.
  virtual bool record_part(Reals p, const Situation& situation,
                           std::span<double> part) const {
    if (description().adds_up) record(p, situation, part);
    return description().adds_up;
  }

 private:
  const Description& description_;
};

}  // namespace workbench
