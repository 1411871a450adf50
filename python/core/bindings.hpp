// The parts of the module stickband._core, one file each. They speak in JSON, texts and
// arrays; the Python files beside make dataclasses of them.
#pragma once

#include <pybind11/pybind11.h>

namespace stickband_python {

void bind_recording(pybind11::module_& module);
void bind_valve(pybind11::module_& module);  ///< identify, oscillation
void bind_model(pybind11::module_& module);
void bind_monitor(pybind11::module_& module);
void bind_simulate(pybind11::module_& module);

}  // namespace stickband_python
