// What passes between Python and C++: NumPy arrays that share their memory, and text.
#pragma once

#include <pybind11/numpy.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace stickband_python {

/// What the package passes: one axis of doubles without gaps. Not converted: an array of
/// another type or form is refused.
using Doubles = pybind11::array_t<double, pybind11::array::c_style>;

/// The array's own memory. Throws InputError naming the array where it has more axes than
/// one.
[[nodiscard]] std::span<const double> samples_of(const Doubles& array,
                                                 const std::string& name);

/// Throws InputError naming the array, the first value that is not finite and its place.
void refuse_what_is_not_finite(std::span<const double> values, const std::string& name);

/// An array over `values`, which it keeps.
[[nodiscard]] Doubles array_of(std::vector<double>&& values);

/// A read-only array over `values`, which `owner` keeps.
[[nodiscard]] pybind11::array view_of(std::span<const double> values,
                                      const pybind11::handle& owner);

/// Text that may hold the name of a file in another encoding than UTF-8: what cannot be
/// read is replaced, as in the JSON.
[[nodiscard]] pybind11::str readable(const std::string& text);

/// {"t": …, "u": …} of what is not empty.
[[nodiscard]] pybind11::dict arrays_of(
    std::vector<std::pair<const char*, std::vector<double>*>> columns);

}  // namespace stickband_python
