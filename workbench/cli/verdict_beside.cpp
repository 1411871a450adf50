#include "workbench/cli/verdict_beside.hpp"

#include <utility>

#include "workbench/cli/console.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/model/tell/reconciled.hpp"

namespace workbench::cli {

VerdictBeside::VerdictBeside(const ModelOptions& options,
                             std::vector<Recording> recordings, Column output,
                             ProgressLine& line) {
  if (output != Column::y) return;
  identified_.emplace(std::move(recordings), [&line](int window, int windows) {
    line.show(identifying(window, windows));
  });
  if (limits_of(options).threads > 1) identified_->begin();
}

std::optional<ValveVerdict> VerdictBeside::of(const Work& work, const Model& model,
                                              const Candidate* missing) {
  if (!identified_ || work.out_of_time()) return std::nullopt;
  const Identification& found = identified_->result(work);
  return ValveVerdict{found.verdict, reconciled(found, model, missing)};
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
