#include "python/core/arrays.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"

namespace py = pybind11;

namespace stickband_python {

std::span<const double> samples_of(const Doubles& array, const std::string& name) {
  if (array.ndim() != 1) {
    throw workbench::InputError("array " + name, 0, 0, "one axis",
                                std::to_string(array.ndim()) + " axes",
                                "pass one column of samples, as in values[:, 0]");
  }
  return {array.data(), static_cast<std::size_t>(array.size())};
}

void refuse_what_is_not_finite(std::span<const double> values, const std::string& name) {
  const auto bad =
      std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
  if (bad == values.end()) return;
  throw workbench::InputError(
      "array " + name, 0, 0, "finite numbers",
      workbench::number(*bad) + " at index " + std::to_string(bad - values.begin()),
      "hold the value before it, as pandas' ffill() does, or cut there");
}

Doubles array_of(std::vector<double>&& values) {
  auto kept = std::make_unique<std::vector<double>>(std::move(values));
  double* const data = kept->data();
  const auto size = static_cast<py::ssize_t>(kept->size());
  const py::capsule owner(
      kept.get(), [](void* memory) { delete static_cast<std::vector<double>*>(memory); });
  (void)kept.release();  // the capsule has it now
  return Doubles(size, data, owner);
}

py::array view_of(std::span<const double> values, const py::handle& owner) {
  Doubles array(static_cast<py::ssize_t>(values.size()), values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::str readable(const std::string& text) {
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(
      text.data(), static_cast<py::ssize_t>(text.size()), "replace"));
}

py::dict arrays_of(std::vector<std::pair<const char*, std::vector<double>*>> columns) {
  py::dict out;
  for (auto& [name, values] : columns) {
    if (!values->empty()) out[name] = array_of(std::move(*values));
  }
  return out;
}

}  // namespace stickband_python
