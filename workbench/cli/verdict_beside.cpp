#include "workbench/cli/verdict_beside.hpp"

#include <utility>

#include "workbench/cli/console.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/model/tell/reconciled.hpp"
#include "workbench/recording/resample.hpp"

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
  return beside_model(identified_->result(work), model, missing);
}

ValveVerdict beside_model(const ident::Identification<double>& found, const Model& model,
                          const Candidate* missing) {
  ValveVerdict out{found.verdict, reconciled(found, model, missing),
                   lacks_stem(found.verdict, model, missing)};
  for (const auto& stroke : {found.stick_band.ascending, found.stick_band.descending}) {
    if (stroke.value > out.stick_band) out.stick_band = stroke.value;
  }
  return out;
}

std::string noise_is_left(const std::string& said,
                          const std::optional<ValveVerdict>& verdict) {
  if (!verdict || !verdict->lacks_stem) return said + ": what is left looks like noise.";
  const std::string seen =
      verdict->stick_band > 0
          ? "a stick band of " + number(verdict->stick_band, 3) + " in u"
          : "a stem that does not follow u";
  return wrapped("Open: what is left looks like noise, but stickband identify finds " +
                     seen + ", and the model has none.",
                 0);
}

nlohmann::ordered_json verdict_json(const std::optional<ValveVerdict>& verdict) {
  if (!verdict) return nullptr;
  return {
      {"verdict", ident::name(verdict->verdict)},
      {"differs", verdict->differs.empty() ? nlohmann::ordered_json(nullptr)
                                           : nlohmann::ordered_json(verdict->differs)},
      {"lacks_stem", verdict->lacks_stem}};
}

std::string verdict_text(const std::optional<ValveVerdict>& verdict) {
  if (!verdict || verdict->differs.empty()) return {};
  return wrapped("stickband identify says " + std::string(ident::name(verdict->verdict)) +
                     ". " + verdict->differs,
                 0) +
         "\n\n";
}

}  // namespace workbench::cli
