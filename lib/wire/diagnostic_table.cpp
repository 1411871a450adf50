#include "ident/base/effect_code.hpp"
#include "wire/diagnostics.hpp"

namespace wire {
namespace {

constexpr std::array<Choice, 7> kVerdicts = {{{0, "not_evaluated"},
                                              {1, "no_stiction"},
                                              {2, "oscillation_other"},
                                              {3, "undecided"},
                                              {4, "stiction"},
                                              {5, "backlash"},
                                              {7, "input_invalid"}}};
constexpr std::array<Choice, 5> kHealth = {{{0, "normal"},
                                            {1, "failure"},
                                            {2, "check_function"},
                                            {3, "off_spec"},
                                            {4, "maintenance_required"}}};
constexpr std::array<Choice, 9> kInputs = {{{0, "good"},
                                            {1, "missing"},
                                            {2, "current_low"},
                                            {3, "current_high"},
                                            {4, "frozen"},
                                            {5, "clipped"},
                                            {6, "out_of_range"},
                                            {7, "not_configured"},
                                            {8, "uncertain"}}};
constexpr std::array<Choice, 3> kModes = {
    {{0, "unknown"}, {1, "automatic"}, {2, "manual"}}};
constexpr auto kEffects = [] {
  std::array<Choice, ident::kEffectCodes> out{};
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = {static_cast<std::uint8_t>(k), k == 0 ? "none" : ident::kEffectNames[k]};
  }
  return out;
}();
constexpr std::array<Choice, 2> kSessions = {{{1, "default"}, {3, "extended"}}};

constexpr double kHundredth = 0.01;
constexpr double kTenth = 0.1;
constexpr double kHalf = 0.5;
constexpr double kMilli = 0.001;

template <class Enum>
constexpr double code(Enum value) {
  return static_cast<double>(static_cast<std::uint8_t>(value));
}

template <class Subject>
constexpr Field<Subject> quantity(std::uint16_t object, std::string_view name,
                                  FieldType type, std::string_view unit, double scale,
                                  double (*number)(const Subject&),
                                  std::string_view meaning) {
  return {object, name, type, unit, scale, meaning, number, nullptr, 0, {}, 0};
}
template <class Subject>
constexpr Field<Subject> count(std::uint16_t object, std::string_view name,
                               double (*number)(const Subject&),
                               std::string_view meaning) {
  Field<Subject> field =
      quantity<Subject>(object, name, FieldType::kU32, {}, 1, number, meaning);
  field.grows = true;
  return field;
}
template <class Subject>
constexpr Field<Subject> choice(std::uint16_t object, std::string_view name,
                                std::span<const Choice> choices,
                                double (*number)(const Subject&),
                                std::string_view meaning) {
  return {object, name, FieldType::kU8, {}, 1, meaning, number, nullptr, 0, choices, 0};
}
template <class Subject>
constexpr Field<Subject> words(std::uint16_t object, std::string_view name,
                               std::uint8_t bytes,
                               std::string_view (*text)(const Subject&),
                               std::string_view meaning) {
  return {object, name, FieldType::kText, {}, 1, meaning, nullptr, text, bytes, {}, 0};
}

constexpr LoopField in_frame(std::uint8_t frame, LoopField field) {
  field.frame = frame;
  return field;
}

using Loop = LoopStatus;
using View = GatewayView;

constexpr FieldType kU8 = FieldType::kU8;
constexpr FieldType kU16 = FieldType::kU16;
constexpr FieldType kU32 = FieldType::kU32;
constexpr FieldType kU64 = FieldType::kU64;
constexpr FieldType kI16 = FieldType::kI16;

constexpr std::array kLoopObjects = {
    LoopObject{0, "state", false},     LoopObject{1, "tag", false},
    LoopObject{2, "live", false},      LoopObject{3, "window", false},
    LoopObject{4, "model_gap", false}, LoopObject{5, "parameters", true},
    LoopObject{6, "change", false},    LoopObject{7, "mapping", false},
    LoopObject{8, "counters", false},  LoopObject{9, "paths", false},
    LoopObject{10, "interval", false},
};

constexpr std::array kLoopFields = {
    in_frame(1,
             choice<Loop>(
                 0, "verdict", kVerdicts, [](const Loop& l) { return code(l.verdict); },
                 "what the gateway says about the valve, before classification")),
    in_frame(1, choice<Loop>(
                    0, "ne107", kHealth, [](const Loop& l) { return code(ne107_of(l)); },
                    "the same, classified for the plant")),
    in_frame(1, quantity<Loop>(
                    0, "confidence_pct", kU8, "%", kHalf,
                    [](const Loop& l) { return l.confidence_pct; },
                    "confidence in the verdict")),
    in_frame(1, choice<Loop>(
                    0, "input_status", kInputs,
                    [](const Loop& l) { return code(l.input); }, "state of the inputs")),
    in_frame(1, quantity<Loop>(
                    0, "stick_band_ascending_pct", kU16, "%", kHundredth,
                    [](const Loop& l) { return l.stick_band_pct.ascending; },
                    "stick band before the valve moves with rising u, of span")),
    in_frame(1, quantity<Loop>(
                    0, "stick_band_descending_pct", kU16, "%", kHundredth,
                    [](const Loop& l) { return l.stick_band_pct.descending; },
                    "stick band before the valve moves with falling u, of span")),
    quantity<Loop>(
        0, "slip_jump_ascending_pct", kU16, "%", kHundredth,
        [](const Loop& l) { return l.slip_jump_pct.ascending; },
        "slip jump with rising u, of span"),
    quantity<Loop>(
        0, "slip_jump_descending_pct", kU16, "%", kHundredth,
        [](const Loop& l) { return l.slip_jump_pct.descending; },
        "slip jump with falling u, of span"),
    quantity<Loop>(
        0, "period_s", kU32, "s", kMilli, [](const Loop& l) { return l.period_s; },
        "period of the oscillation"),
    in_frame(3, quantity<Loop>(
                    0, "age_s", kU32, "s", 1, [](const Loop& l) { return l.age_s; },
                    "age of the verdict")),

    words<Loop>(
        1, "tag", 32, [](const Loop& l) { return l.tag.view(); },
        "tag of the loop, ASCII"),

    quantity<Loop>(
        2, "u_pct", kI16, "%", kHundredth, [](const Loop& l) { return l.u_pct; },
        "controller output, of span"),
    quantity<Loop>(
        2, "y_pct", kI16, "%", kHundredth, [](const Loop& l) { return l.y_pct; },
        "controlled variable, of span"),
    quantity<Loop>(
        2, "sp_pct", kI16, "%", kHundredth, [](const Loop& l) { return l.sp_pct; },
        "setpoint, of span"),
    choice<Loop>(
        2, "mode", kModes, [](const Loop& l) { return code(l.mode); },
        "mode of the controller; manual suspends the evaluation"),

    quantity<Loop>(
        3, "window_samples", kU16, "", 1, [](const Loop& l) { return l.window_samples; },
        "samples of the window that was judged"),
    quantity<Loop>(
        3, "window_cycles", kU16, "", 1, [](const Loop& l) { return l.window_cycles; },
        "cycles of the oscillation in it"),
    quantity<Loop>(
        3, "fit_pct", kI16, "%", kHundredth, [](const Loop& l) { return l.fit_percent; },
        "fit of the model with the valve"),
    quantity<Loop>(
        3, "fit_linear_pct", kI16, "%", kHundredth,
        [](const Loop& l) { return l.fit_linear_percent; },
        "fit of the model behind a linear valve"),

    choice<Loop>(
        4, "suspect_effect", kEffects,
        [](const Loop& l) { return static_cast<double>(l.suspect_effect); },
        "effect that the model seems to lack"),
    quantity<Loop>(
        4, "share_of_error_pct", kU8, "%", kHalf,
        [](const Loop& l) { return l.share_of_error_pct; },
        "share of the squared error that points to it"),
    quantity<Loop>(
        4, "residual_share_pct", kU16, "%", kHundredth,
        [](const Loop& l) { return l.residual_share_pct; },
        "root mean square of the residual, of the span of y"),

    quantity<Loop>(
        5, "on_delay_windows", kU16, "", 1,
        [](const Loop& l) { return static_cast<double>(l.parameters.on_delay_windows); },
        "supporting windows in a row that confirm, 1 to 1000"),
    quantity<Loop>(
        5, "off_delay_windows", kU16, "", 1,
        [](const Loop& l) { return static_cast<double>(l.parameters.off_delay_windows); },
        "windows against it that clear, 1 to 1000"),
    quantity<Loop>(
        5, "band_min_pct", kU16, "%", kHundredth,
        [](const Loop& l) { return l.parameters.band_min_pct; },
        "smallest stick band that counts, of span, 0 to 100"),
    choice<Loop>(
        5, "ne107_stiction", kHealth,
        [](const Loop& l) { return code(l.parameters.stiction); },
        "classification of stiction"),
    choice<Loop>(
        5, "ne107_backlash", kHealth,
        [](const Loop& l) { return code(l.parameters.backlash); },
        "classification of backlash"),
    choice<Loop>(
        5, "ne107_oscillation_other", kHealth,
        [](const Loop& l) { return code(l.parameters.oscillation_other); },
        "classification of an oscillation of another cause"),
    choice<Loop>(
        5, "ne107_input_invalid", kHealth,
        [](const Loop& l) { return code(l.parameters.input_invalid); },
        "classification of an invalid input"),

    quantity<Loop>(
        6, "changed_s", kU64, "s", kMilli,
        [](const Loop& l) { return l.changed_ms * kMilli; },
        "last change of the verdict, since the Unix epoch"),

    words<Loop>(
        7, "mapping", 0, [](const Loop& l) { return l.mapping.view(); },
        "where u, y and sp come from"),

    count<Loop>(
        8, "frames", [](const Loop& l) { return l.counters.frames * 1.0; },
        "frames that carried a signal of the loop"),
    count<Loop>(
        8, "gaps", [](const Loop& l) { return l.counters.gaps * 1.0; },
        "sample periods without a new value"),
    count<Loop>(
        8, "stale", [](const Loop& l) { return l.counters.stale * 1.0; },
        "times an input went missing"),
    count<Loop>(
        8, "dropped", [](const Loop& l) { return l.counters.dropped * 1.0; },
        "frames lost before the gateway saw them"),
    count<Loop>(
        8, "ne43_faults", [](const Loop& l) { return l.counters.ne43_faults * 1.0; },
        "currents outside the NE43 limits"),
    count<Loop>(
        8, "refused_fits", [](const Loop& l) { return l.counters.refused_fits * 1.0; },
        "windows that could not be decided"),
    count<Loop>(
        8, "refused_values",
        [](const Loop& l) { return l.counters.refused_values * 1.0; },
        "values out of range, or not a number"),

    LoopField{9,
              "paths",
              FieldType::kPath,
              "%",
              kHundredth,
              "identified valve paths: number of knots u8, then u, x_ascending and "
              "x_descending i16 each, of span",
              nullptr,
              nullptr,
              0,
              {},
              0},

    in_frame(2, quantity<Loop>(
                    10, "stick_band_ascending_low_pct", kU16, "%", kHundredth,
                    [](const Loop& l) { return l.stick_band_low_pct.ascending; },
                    "lower end of its 95 % interval, of span")),
    in_frame(2, quantity<Loop>(
                    10, "stick_band_ascending_high_pct", kU16, "%", kHundredth,
                    [](const Loop& l) { return l.stick_band_high_pct.ascending; },
                    "upper end of it, of span")),
    in_frame(2, quantity<Loop>(
                    10, "stick_band_descending_low_pct", kU16, "%", kHundredth,
                    [](const Loop& l) { return l.stick_band_low_pct.descending; },
                    "lower end of its 95 % interval, of span")),
    in_frame(2, quantity<Loop>(
                    10, "stick_band_descending_high_pct", kU16, "%", kHundredth,
                    [](const Loop& l) { return l.stick_band_high_pct.descending; },
                    "upper end of it, of span")),
    in_frame(3, quantity<Loop>(
                    10, "detectable_band_pct", kU16, "%", kHundredth,
                    [](const Loop& l) { return l.detectable_band_pct; },
                    "smallest stick band that the window would have shown, of span")),
    quantity<Loop>(
        10, "evidence_nats", kI16, "nat", kTenth,
        [](const Loop& l) { return l.evidence_nats; },
        "closed-loop evidence of the window for a valve that sticks"),
    in_frame(3, quantity<Loop>(
                    10, "trend_pct_per_day", kI16, "%", kMilli,
                    [](const Loop& l) { return l.trend_pct_per_day; },
                    "slope of the stick band over weeks, of span a day")),
    quantity<Loop>(
        10, "trend_low_pct_per_day", kI16, "%", kMilli,
        [](const Loop& l) { return l.trend_low_pct_per_day; },
        "lower end of its 95 % interval, of span a day"),
    quantity<Loop>(
        10, "trend_high_pct_per_day", kI16, "%", kMilli,
        [](const Loop& l) { return l.trend_high_pct_per_day; },
        "upper end of it, of span a day"),
    quantity<Loop>(
        10, "days_to_limit", kU16, "d", 1, [](const Loop& l) { return l.days_to_limit; },
        "days until the stick band reaches the loop's limit"),
};

double flagged(const View& v) {
  int count = 0;
  for (const LoopStatus& loop : v.loops) count += loop.flag ? 1 : 0;
  return count;
}

constexpr std::array kGatewayFields = {
    choice<View>(
        0xF186, "session", kSessions,
        [](const View& v) { return static_cast<double>(v.session); },
        "active diagnostic session"),
    words<View>(
        0xF18A, "supplier", 0, [](const View&) { return std::string_view("Stickband"); },
        "supplier"),
    words<View>(
        0xF18C, "gateway_name", 0, [](const View& v) { return v.gateway.name.view(); },
        "name of the gateway"),
    words<View>(
        0xF195, "software_version", 0,
        [](const View& v) { return v.gateway.software_version.view(); },
        "version of the software"),
    words<View>(
        0xF197, "system_name", 0,
        [](const View&) { return std::string_view("Valve stiction monitor"); },
        "name of the system"),
    choice<View>(
        0xFD00, "worst_ne107", kHealth,
        [](const View& v) { return code(worst_ne107(v.loops)); },
        "worst status of all loops, in the order F, C, S, M"),
    quantity<View>(
        0xFD00, "loops", kU8, "", 1,
        [](const View& v) { return static_cast<double>(v.loops.size()); },
        "loops configured"),
    quantity<View>(0xFD00, "flagged", kU8, "", 1, &flagged, "loops whose flag is raised"),
    quantity<View>(
        0xFD00, "uptime_s", kU32, "s", 1,
        [](const View& v) { return v.gateway.uptime_s; }, "time since start"),
    quantity<View>(
        0xFD00, "config_crc32", kU32, "", 1,
        [](const View& v) { return static_cast<double>(v.gateway.config_crc32); },
        "CRC-32 of the configuration file"),
    count<View>(
        0xFD02, "textfile_failures",
        [](const View& v) { return static_cast<double>(v.gateway.textfile_failures); },
        "times the textfile could not be written"),
    count<View>(
        0xFD02, "state_failures",
        [](const View& v) { return static_cast<double>(v.gateway.state_failures); },
        "times the state file could not be written"),
    count<View>(
        0xFD02, "history_failures",
        [](const View& v) { return static_cast<double>(v.gateway.history_failures); },
        "times the history could not be written, and rows lost"),
    count<View>(
        0xFD03, "unlocks", [](const View& v) { return v.gateway.access.unlocks * 1.0; },
        "times a tester unlocked"),
    count<View>(
        0xFD03, "refused_keys",
        [](const View& v) { return v.gateway.access.refused_keys * 1.0; }, "wrong keys"),
    count<View>(
        0xFD03, "writes", [](const View& v) { return v.gateway.access.writes * 1.0; },
        "times parameters were written"),
    count<View>(
        0xFD03, "clears", [](const View& v) { return v.gateway.access.clears * 1.0; },
        "times DTCs were cleared"),
    count<View>(
        0xFD03, "resets", [](const View& v) { return v.gateway.access.resets * 1.0; },
        "times loops were reset"),
    count<View>(
        0xFD03, "simulations",
        [](const View& v) { return v.gateway.access.simulations * 1.0; },
        "times a simulated verdict was begun or ended"),
};

}  // namespace

std::span<const LoopObject> loop_objects() {
  return kLoopObjects;
}
std::span<const LoopField> loop_fields() {
  return kLoopFields;
}
std::span<const GatewayField> gateway_fields() {
  return kGatewayFields;
}

}  // namespace wire
