#include <pybind11/stl.h>

#include "python/core/bindings.hpp"
#include "python/core/errors.hpp"
#include "python/core/held_recording.hpp"
#include "python/core/long_work.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/cli/verdict_beside.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/judge/compare.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/stopped.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

using workbench::Column;
using workbench::Model;
using workbench::Work;
using Held = std::shared_ptr<HeldRecording>;
using HeldOnes = std::vector<Held>;

constexpr const char* kGivenModel = "the model";  // in messages

Column output_named(const std::string& name) {
  if (name == "y") return Column::y;
  if (name == "x") return Column::x;
  throw std::invalid_argument("no output '" + name + "': y, or x");
}

void require_known(const std::vector<std::string>& effects) {
  const workbench::Catalogue& catalogue = workbench::standard_catalogue();
  for (const std::string& effect : effects) {
    if (catalogue.find(effect) == nullptr) {
      throw std::invalid_argument(catalogue.no_effect(effect));
    }
  }
}

Work::Limits limits(unsigned threads, std::optional<double> within,
                    const std::stop_token& stop) {
  if (within && !(*within > 0)) throw std::invalid_argument("within must be above 0 s");
  return {
      .threads = threads > 0 ? threads : Work::cores(), .seconds = within, .stop = stop};
}

// The columns that a model with these effects takes for loads, whatever they are.
std::vector<std::string> loads_in(const std::vector<std::string>& effects) {
  std::vector<std::string> out;
  for (const std::string& effect : effects) {
    if (!effect.starts_with(workbench::effects::kMeasuredLoad)) continue;
    out.push_back(effect.substr(workbench::effects::kMeasuredLoad.size()));
  }
  return out;
}

std::vector<workbench::Recording> copies_of(const HeldOnes& recordings, Column output,
                                            const std::vector<std::string>& in_model) {
  std::vector<workbench::Recording> out;
  for (const Held& held : recordings) {
    const auto whole = held->whole_with(in_model);
    for (const Column column : {Column::u, output}) {
      if (whole->has(column)) continue;
      const std::string name(name_of(column));
      throw workbench::InputError(whole->name, 0, 0, "the column " + name, "no " + name,
                                  "choose a recording that has it");
    }
    out.push_back(*whole);
  }
  return out;
}

// Several recordings as the one that models with these effects are fitted to; a single
// one without pauses is it.
Held joined(const HeldOnes& fitted, const HeldOnes& judging, const std::string& output,
            const std::vector<std::string>& effects) {
  if (fitted.empty()) throw std::invalid_argument("no recording was given");
  const std::vector<std::string> in_model = loads_in(effects);
  if (fitted.size() == 1 && judging.empty()) {
    const auto whole = fitted[0]->whole_with(in_model);
    if (whole->resampling.gaps.empty()) {
      return whole == fitted[0]->whole() ? fitted[0]
                                         : std::make_shared<HeldRecording>(*whole);
    }
  }
  const Column column = output_named(output);
  return std::make_shared<HeldRecording>(workbench::joined(
      copies_of(fitted, column, in_model), copies_of(judging, column, in_model)));
}

// The verdict on the valve beside a model, as the program tells it; of no recordings, and
// where the stem is modelled or the time is up: nothing.
nlohmann::ordered_json verdict_beside(
    const std::vector<workbench::RecordingView>& recordings, const Work& work,
    const Model& model, const workbench::Candidate* missing,
    const std::stop_token& stop) {
  if (recordings.empty() || model.output != Column::y || work.out_of_time()) {
    return nullptr;
  }
  const workbench::Analysis analysis(
      recordings, [&stop](int, int) { workbench::check_stop(stop); },
      workbench::Depth::kVerdict);
  return workbench::cli::verdict_json(
      workbench::cli::beside_model(analysis.result(), model, missing));
}

std::vector<workbench::RecordingView> views_of(const HeldOnes& recordings) {
  std::vector<workbench::RecordingView> out;
  for (const Held& held : recordings) out.push_back(held->view());
  return out;
}

std::string text_of(const Model& model) {
  return workbench::json_line(workbench::model_json(model));
}

std::string fit(const Held& recording, const std::string& output,
                const std::vector<std::string>& effects, unsigned threads) {
  require_known(effects);
  const Column column = output_named(output);
  const auto whole = recording->whole();
  std::string out;
  run_long([&](const std::stop_token& stop) {
    const Work work(limits(threads, {}, stop));
    out = text_of(workbench::start_model(*whole, column, effects,
                                         workbench::standard_catalogue(), work)
                      .model);
  });
  return out;
}

py::dict view_dict(workbench::ViewCurve& view) {
  py::dict out = arrays_of({{"position", &view.position},
                            {"mean", &view.mean},
                            {"error_share", &view.error_share},
                            {"sample_share", &view.sample_share}});
  out["view"] = std::string(workbench::name_of(view.view));
  out["coordinate"] = view.coordinate;
  return out;
}

py::tuple compare(const Held& recording, const std::string& model) {
  const auto whole = recording->whole();
  workbench::Comparison comparison;
  std::string json;
  run_long([&](const std::stop_token& stop) {
    const Work work({.stop = stop});
    comparison = workbench::compare(*whole, workbench::parse_model(model, kGivenModel),
                                    workbench::standard_catalogue(), work);
    json = workbench::json_line(workbench::comparison_json(comparison));
  });
  py::list views;
  for (workbench::ViewCurve& view : comparison.views) views.append(view_dict(view));
  return py::make_tuple(json,
                        arrays_of({{"simulated", &comparison.simulated},
                                   {"residual", &comparison.residual}}),
                        views);
}

std::string explain(const Held& recording, const HeldOnes& beside,
                    const std::string& text, unsigned threads,
                    std::optional<double> within) {
  const Model model = workbench::parse_model(text, kGivenModel);
  const auto whole = recording->whole();
  const auto views = views_of(beside);
  std::string out;
  run_long([&](const std::stop_token& stop) {
    const Work work(limits(threads, within, stop));
    const workbench::ExplainResult result =
        workbench::explain(*whole, model, {}, workbench::standard_catalogue(), work);
    nlohmann::ordered_json json = workbench::explanation_json(result);
    json["identify"] = verdict_beside(views, work, model, result.best(), stop);
    out = workbench::json_line(json);
  });
  return out;
}

py::tuple add(const Held& recording, const std::string& text, const std::string& effect,
              unsigned threads) {
  require_known({effect});
  const Model model = workbench::parse_model(text, kGivenModel);
  if (model.has(effect)) {
    throw std::invalid_argument(std::string(kGivenModel) + " already has " + effect);
  }
  const auto whole = recording->whole();
  std::string out;
  std::string told;
  run_long([&](const std::stop_token& stop) {
    const Work work(limits(threads, {}, stop));
    try {
      const workbench::FittedModel next = workbench::add_effect(
          *whole, model, effect, workbench::standard_catalogue(), work);
      nlohmann::ordered_json json = workbench::added_json(next.model);
      json["recordings"] = workbench::recordings_json(next.quality.recordings);
      told = workbench::json_line(json);
      out = text_of(next.model);
    } catch (const std::invalid_argument& error) {
      throw CannotAnswer(std::string("the data cannot answer: ") + error.what());
    }
  });
  return py::make_tuple(out, told);
}

std::string removed(const Held& recording, const std::string& text,
                    const std::string& effect, unsigned threads) {
  const Model model = workbench::parse_model(text, kGivenModel);
  const auto whole = recording->whole();
  std::string out;
  run_long([&](const std::stop_token& stop) {
    const Work work(limits(threads, {}, stop));
    out = text_of(workbench::remove_effect(*whole, model, effect,
                                           workbench::standard_catalogue(), work)
                      .model);
  });
  return out;
}

py::tuple ladder(const Held& recording, const HeldOnes& beside, const std::string& output,
                 const std::vector<std::string>& effects, unsigned threads,
                 std::optional<double> within) {
  require_known(effects);
  workbench::LadderOptions options;
  options.output = output_named(output);
  options.with = effects;
  const auto whole = recording->whole();
  const auto views = views_of(beside);
  std::string told;
  std::string model;
  run_long([&](const std::stop_token& stop) {
    const Work work(limits(threads, within, stop));
    options.work = &work;
    const workbench::LadderResult result = workbench::run_ladder(*whole, options);
    nlohmann::ordered_json json = workbench::ladder_json(result);
    json["identify"] =
        verdict_beside(views, work, result.model, result.last.best(), stop);
    told = workbench::json_line(json);
    model = text_of(result.model);
  });
  return py::make_tuple(told, model);
}

std::string added(const std::string& text) {
  const Model model = workbench::parse_model(text, kGivenModel);
  if (model.history.empty() || model.effects.empty()) return {};
  if (!model.has(model.history.back().effect)) return {};
  return workbench::json_line(workbench::added_json(model));
}

void save(const std::string& text, const std::string& path) {
  const Model model = workbench::parse_model(text, kGivenModel);
  workbench::cli::write_file(path, workbench::model_json(model).dump(2) + '\n');
}

py::list effects() {
  py::list out;
  for (const workbench::Effect* effect : workbench::standard_catalogue().effects()) {
    const workbench::Description& d = effect->description();
    out.append(py::make_tuple(std::string(d.code), std::string(d.title),
                              std::string(d.signature), std::string(d.cure)));
  }
  return out;
}

}  // namespace

void bind_model(py::module_& module) {
  module.def("joined", &joined, py::arg("recordings"), py::arg("judging"),
             py::arg("output"), py::arg("effects"));
  module.def("fit", &fit, py::arg("recording"), py::arg("output"), py::arg("effects"),
             py::arg("threads"));
  module.def("compare", &compare, py::arg("recording"), py::arg("model"));
  module.def("explain", &explain, py::arg("recording"), py::arg("beside"),
             py::arg("model"), py::arg("threads"), py::arg("within"));
  module.def("add", &add, py::arg("recording"), py::arg("model"), py::arg("effect"),
             py::arg("threads"));
  module.def("removed", &removed, py::arg("recording"), py::arg("model"),
             py::arg("effect"), py::arg("threads"));
  module.def("added", &added, py::arg("model"));
  module.def("ladder", &ladder, py::arg("recording"), py::arg("beside"),
             py::arg("output"), py::arg("effects"), py::arg("threads"),
             py::arg("within"));
  module.def(
      "read_model",
      [](const std::string& path) { return text_of(workbench::read_model(path)); },
      py::arg("path"));
  module.def(
      "parse_model",
      [](const std::string& text) {
        return text_of(workbench::parse_model(text, kGivenModel));
      },
      py::arg("text"));
  module.def("save_model", &save, py::arg("model"), py::arg("path"));
  module.def("effects", &effects);
}

}  // namespace stickband_python
