// What `stickband identify` says of the recordings that a model is fitted to.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ident/verdict/identification.hpp"
#include "ident/verdict/verdict.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/identified.hpp"

namespace workbench::cli {

/// The verdict of `stickband identify` on the same recordings, beside a model of y.
struct ValveVerdict {
  ident::Verdict verdict = ident::Verdict::kUndecided;
  std::string differs;      ///< reconciled.hpp
  bool lacks_stem = false;  ///< the same
  double stick_band = 0;    ///< the wider one of both strokes, units of u; 0: none known
};

/// `verdict` beside `model`. `missing` as in reconciled().
[[nodiscard]] ValveVerdict beside_model(const ident::Identification<double>& found,
                                        const Model& model, const Candidate* missing);

/// Identifies while a search is under way; with --threads 1 when the search asks or after
/// it, with progress on a terminal. Both say the same. Life: construct → search with
/// identified() → of(). Cost: that of Analysis, without two-path models. Given up when
/// destroyed.
class VerdictBeside {
 public:
  /// Of `recordings`, at least one; nothing where another output than y is modelled.
  /// `line` must outlive this.
  VerdictBeside(const ModelOptions& options, std::vector<Recording> recordings,
                Column output, ProgressLine& line);

  /// Null where another output than y is modelled.
  [[nodiscard]] Identified* identified() { return identified_ ? &*identified_ : nullptr; }

  /// Nothing where y is not modelled or the time of `work` is up. `missing` as in
  /// reconciled(). Throws what identifying throws.
  [[nodiscard]] std::optional<ValveVerdict> of(const Work& work, const Model& model,
                                               const Candidate* missing);

 private:
  std::optional<Identified> identified_;
};

/// {"verdict", "differs", "lacks_stem"}, null where there is none.
[[nodiscard]] nlohmann::ordered_json verdict_json(
    const std::optional<ValveVerdict>& verdict);
/// That noise is left, after `said`, "Explained" say; where the verdict names a stem that
/// the model has not, that this leaves it open.
[[nodiscard]] std::string noise_is_left(const std::string& said,
                                        const std::optional<ValveVerdict>& verdict);
/// One paragraph; "" where there is none or both agree.
[[nodiscard]] std::string verdict_text(const std::optional<ValveVerdict>& verdict);

}  // namespace workbench::cli
