#include "workbench/cli/verdict_beside.hpp"

#include <utility>
#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/model/tell/reconciled.hpp"

namespace workbench::cli {

VerdictBeside::VerdictBeside(const ModelOptions& options, Column output) {
  if (output != Column::y) return;
  const bool at_once = limits_of(options).threads > 1;
  auto identify = [this, at_once,
                   recordings = recordings_for(options, Column::y)]() mutable {
    if (!at_once) return identify_with_progress(std::move(recordings)).result().verdict;
    const auto go_on = [this](int, int) {
      if (given_up_) throw Stopped{};
    };
    return Analysis(recordings, go_on, Depth::kVerdict).result().verdict;
  };
  verdict_ = std::async(at_once ? std::launch::async : std::launch::deferred,
                        std::move(identify));
}

std::optional<ValveVerdict> VerdictBeside::of(const Work& work, const Model& model,
                                              const Candidate* missing) {
  if (!verdict_.valid() || work.out_of_time()) return std::nullopt;
  const ident::Verdict verdict = verdict_.get();
  return ValveVerdict{verdict, reconciled(verdict, model, missing)};
}

nlohmann::ordered_json verdict_json(const std::optional<ValveVerdict>& verdict) {
  if (!verdict) return nullptr;
  return {
      {"verdict", ident::name(verdict->verdict)},
      {"differs", verdict->differs.empty() ? nlohmann::ordered_json(nullptr)
                                           : nlohmann::ordered_json(verdict->differs)}};
}

std::string verdict_text(const std::optional<ValveVerdict>& verdict) {
  if (!verdict || verdict->differs.empty()) return {};
  return wrapped("stickband identify says " + std::string(ident::name(verdict->verdict)) +
                     ". " + verdict->differs,
                 0) +
         "\n\n";
}

}  // namespace workbench::cli
