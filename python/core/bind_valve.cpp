#include <pybind11/stl.h>

#include <mutex>

#include "python/core/bindings.hpp"
#include "python/core/held_recording.hpp"
#include "python/core/long_work.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/oscillation_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/identification_text.hpp"
#include "workbench/model/base/one_loop.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/stopped.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

// A finished identification, with the recording that it is told with.
class Identified {
 public:
  explicit Identified(const std::vector<std::shared_ptr<HeldRecording>>& recordings) {
    if (recordings.empty()) throw std::invalid_argument("no recording was given");
    std::vector<workbench::RecordingView> views;
    std::vector<workbench::Recording> named;  // without samples
    for (const auto& recording : recordings) {
      views.push_back(recording->view());
      named.emplace_back().name = views.back().name;
      named.back().units = views.back().units;
      named.back().loop = views.back().loop;
      named.back().tags = views.back().tags;
      for (const workbench::Column column :
           {workbench::Column::u, workbench::Column::y}) {
        if (views.back().has(column)) continue;
        const std::string name(name_of(column));
        throw workbench::InputError(views.back().name, 0, 0, "the columns u and y",
                                    "no " + name, "choose a recording that has them");
      }
    }
    workbench::check_one_loop(named);
    run_long([&](const std::stop_token& stop) {
      analysis_ = std::make_unique<workbench::Analysis>(
          views, [&stop](int, int) { workbench::check_stop(stop); });
      json_ = workbench::json_line(identification_json(views.front(), *analysis_));
      text_ = workbench::cli::identification_text(views.front(), *analysis_);
    });
  }

  [[nodiscard]] const std::string& json() const { return json_; }
  [[nodiscard]] py::str text() const { return readable(text_); }
  [[nodiscard]] std::string headline() const {
    return std::string(workbench::headline_of(analysis_->result()));
  }
  [[nodiscard]] std::string advice() const {
    return std::string(workbench::advice_of(analysis_->result()));
  }
  [[nodiscard]] double span() const { return analysis_->span(); }
  [[nodiscard]] py::dict simulate() {
    workbench::Simulation s;
    run_long([&](const std::stop_token&) {
      const std::lock_guard lock(simulating_);
      s = analysis_->simulate();
    });
    return arrays_of({{"t", &s.t},
                      {"u", &s.u},
                      {"y", &s.y},
                      {"sp", &s.sp},
                      {"x", &s.x},
                      {"y_two_path", &s.y_two_path},
                      {"y_valve", &s.y_valve},
                      {"stem", &s.stem}});
  }

 private:
  std::unique_ptr<workbench::Analysis> analysis_;
  std::mutex simulating_;  // may identify a window again; held without Python's lock
  std::string json_;
  std::string text_;
};

std::string oscillation(const Doubles& values, double period_s) {
  const std::span<const double> samples = samples_of(values, "values");
  refuse_what_is_not_finite(samples, "values");
  std::string json;
  run_long([&](const std::stop_token&) {
    ident::OscillationDetector<double> detector;
    for (const double value : samples) detector.push(value);
    json = workbench::json_line(workbench::oscillation_json(detector.report(), period_s));
  });
  return json;
}

// An estimate rounded to what its interval supports: value, interval.
std::pair<std::string, std::string> estimate_text(double value, double low, double high) {
  const workbench::EstimateText text = workbench::text_of({true, value, low, high});
  return {text.value, text.interval};
}

}  // namespace

void bind_valve(py::module_& module) {
  py::class_<Identified>(module, "Identified")
      .def(py::init<const std::vector<std::shared_ptr<HeldRecording>>&>(),
           py::arg("recordings"))
      .def_property_readonly("json", &Identified::json)
      .def_property_readonly("text", &Identified::text)
      .def_property_readonly("headline", &Identified::headline)
      .def_property_readonly("advice", &Identified::advice)
      .def_property_readonly("span", &Identified::span)
      .def("simulate", &Identified::simulate);
  module.def("oscillation", &oscillation, py::arg("values").noconvert(),
             py::arg("period_s"));
  module.def("estimate_text", &estimate_text, py::arg("value"), py::arg("low"),
             py::arg("high"));
}

}  // namespace stickband_python
