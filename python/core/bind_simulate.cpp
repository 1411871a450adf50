#include <pybind11/stl.h>

#include <sstream>

#include "python/core/bindings.hpp"
#include "python/core/held_recording.hpp"
#include "python/core/long_work.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/simulate/recording_csv.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

// A simulated loop: recording, truth, and what only a simulator knows.
class Simulated {
 public:
  Simulated(const std::string& scenario, std::uint64_t seed) {
    std::optional<workbench::SimulatedLoop> loop;
    run_long([&](const std::stop_token&) { loop = workbench::simulate(scenario, seed); });
    if (!loop) {
      throw std::invalid_argument("no scenario is named '" + scenario +
                                  "'; stickband simulate --list names them");
    }
    loop_ = std::move(*loop);
  }

  [[nodiscard]] std::string truth() const {
    return workbench::truth_json(loop_.truth).dump();
  }
  [[nodiscard]] py::array array(const std::vector<double>& values) const {
    return view_of(values, py::cast(this, py::return_value_policy::reference));
  }
  [[nodiscard]] const workbench::SimulatedLoop& loop() const { return loop_; }
  void save(const std::string& path, bool with_position) const {
    std::ostringstream csv;
    workbench::write_csv(loop_, csv, with_position);
    workbench::cli::write_file(path, csv.str());
  }

 private:
  workbench::SimulatedLoop loop_;
};

py::list scenarios() {
  py::list out;
  for (const workbench::ScenarioInfo& s : workbench::scenarios()) {
    out.append(py::make_tuple(std::string(s.name), std::string(s.description)));
  }
  return out;
}

}  // namespace

void bind_simulate(py::module_& module) {
  const auto column = [](std::vector<double> workbench::SimulatedLoop::*which) {
    return [which](const Simulated& s) { return s.array(s.loop().*which); };
  };
  using Loop = workbench::SimulatedLoop;
  py::class_<Simulated>(module, "Simulated")
      .def(py::init<const std::string&, std::uint64_t>(), py::arg("scenario"),
           py::arg("seed"))
      .def_property_readonly("period_s",
                             [](const Simulated& s) { return s.loop().period_s; })
      .def_property_readonly("truth", &Simulated::truth)
      .def_property_readonly("t", column(&Loop::t))
      .def_property_readonly("u", column(&Loop::u))
      .def_property_readonly("y", column(&Loop::y))
      .def_property_readonly("sp", column(&Loop::sp))
      .def_property_readonly("x", column(&Loop::x))
      .def_property_readonly("y_clean", column(&Loop::y_clean))
      .def("save", &Simulated::save, py::arg("path"), py::arg("with_position"));
  module.def("scenarios", &scenarios);
}

}  // namespace stickband_python
