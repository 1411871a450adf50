#include "python/core/bindings.hpp"
#include "python/core/errors.hpp"

PYBIND11_MODULE(_core, module) {
  module.attr("__version__") = STICKBAND_VERSION;
  stickband_python::translate_errors();
  stickband_python::bind_recording(module);
  stickband_python::bind_valve(module);
  stickband_python::bind_model(module);
  stickband_python::bind_monitor(module);
  stickband_python::bind_simulate(module);
}
