#include "python/core/errors.hpp"

#include <pybind11/pybind11.h>

#include "config/gateway.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/recording/input_error.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

template <class... Arguments>
void raise(const char* name, const std::exception& error, Arguments&&... arguments) {
  const py::object type = py::module_::import("stickband.errors").attr(name);
  const py::object made = type(error.what(), std::forward<Arguments>(arguments)...);
  PyErr_SetObject(type.ptr(), made.ptr());
}

}  // namespace

void translate_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const workbench::CannotAnswer& error) {
      raise("DataCannotAnswer", error);
    } catch (const workbench::InputError& error) {
      raise("BadInput", error, error.file, error.line, error.column, error.expected,
            error.found, error.advice);
    } catch (const config::ConfigError& error) {
      raise("BadInput", error);
    } catch (const CannotAnswer& error) {
      raise("DataCannotAnswer", error);
    } catch (const workbench::cli::OutputError& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    } catch (const std::invalid_argument& error) {
      raise("WrongUsage", error);
    }
  });
}

}  // namespace stickband_python
