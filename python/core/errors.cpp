#include "python/core/errors.hpp"

#include "config/gateway.hpp"
#include "python/core/arrays.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/recording/input_error.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

template <class... Arguments>
void raise(const char* name, const std::exception& error, Arguments&&... arguments) {
  const py::object type = py::module_::import("stickband.errors").attr(name);
  const py::object made =
      type(readable(error.what()), std::forward<Arguments>(arguments)...);
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
      raise("BadInput", error, readable(error.file), error.line, error.column,
            readable(error.expected), readable(error.found), readable(error.advice));
    } catch (const config::ConfigError& error) {
      raise("BadInput", error);
    } catch (const CannotAnswer& error) {
      raise("DataCannotAnswer", error);
    } catch (const workbench::cli::OutputError& error) {
      PyErr_SetObject(PyExc_OSError, readable(error.what()).ptr());
    } catch (const std::invalid_argument& error) {
      raise("WrongUsage", error);
    } catch (const workbench::OutOfTime&) {
      PyErr_SetString(PyExc_TimeoutError,
                      "the time was up before there was any answer; allow more");
    }
  });
}

}  // namespace stickband_python
