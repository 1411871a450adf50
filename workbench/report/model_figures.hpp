// The pictures of the report on a model: where it fails, and how its error fell.
#pragma once

#include <string>
#include <string_view>

#include "workbench/model/base/model.hpp"
#include "workbench/model/judge/compare.hpp"
#include "workbench/model/search/explain.hpp"

namespace workbench {

/// What the page on a model is drawn from; all of the same recording and model.
struct ModelReport {
  const Recording& recording;
  const Model& model;
  Comparison comparison;
  ExplainResult explanation;
  bool lacks_stem = false;  ///< reconciled.hpp, of the verdict on the same recording
};

/// "stiction" for an effect's code; the code itself where the catalogue lacks it.
[[nodiscard]] std::string title_of(std::string_view effect);

/// Those of several codes: "a", "a and b", "a, b and c" where `last_word` is " and ".
[[nodiscard]] std::string titled(const std::vector<std::string>& effects,
                                 std::string_view last_word);

/// The output's unit as the file names it, or "units of y".
[[nodiscard]] std::string output_unit(const ModelReport& report);

/// The validation error after a refit to this recording, on which what is missing was
/// judged; 0 where the model was not refitted, or that changes less than a thousandth.
[[nodiscard]] double refitted_error(const ModelReport& report);

/// Size of the error that no model could explain, as the residual tells it. 0 where it is
/// not known: before explain(), or where this model or the next one explains more than
/// the estimate allows, which then took for noise what was not.
[[nodiscard]] double noise_floor(const ModelReport& report);

// Each returns one or more <figure> elements, or nothing without data for it.

/// Measured and simulated output, residual and u, and the stretch where the model fails
/// most.
[[nodiscard]] std::string overlay_figures(const ModelReport& report);
/// The validation error after each step of the model's history, with the noise floor; a
/// dashed end where explain() names what to add next.
[[nodiscard]] std::string ladder_figure(const ModelReport& report);
/// One panel for each view of the residual, largest share of the error first.
[[nodiscard]] std::string residual_panels(const ModelReport& report);

}  // namespace workbench
