#include <pybind11/stl.h>

#include <map>

#include "python/core/bindings.hpp"
#include "python/core/held_recording.hpp"
#include "python/core/long_work.hpp"
#include "workbench/recording/source.hpp"
#include "workbench/recording/stopped.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

using workbench::Column;

Column signal_named(const std::string& name) {
  const std::optional<Column> column = workbench::column_named(name);
  if (!column || *column == Column::t) {
    throw std::invalid_argument("no column '" + name + "'");
  }
  return *column;
}

std::optional<char> decimal_of(const std::string& name) {
  if (name == "point") return '.';
  if (name == "comma") return ',';
  throw std::invalid_argument("no decimal mark '" + name + "': point or comma");
}

using Names = std::vector<std::pair<std::string, std::string>>;

void set(workbench::RecordingSource& source, const std::string& key,
         const std::string& value) {
  const std::map<std::string, std::string*> texts = {
      {"u", &source.names.u},   {"y", &source.names.y},       {"sp", &source.names.sp},
      {"x", &source.names.x},   {"time", &source.names.time}, {"dbc", &source.dbc},
      {"sheet", &source.sheet}, {"config", &source.config}};
  if (const auto text = texts.find(key); text != texts.end()) {
    *text->second = value;
  } else if (key == "date_order") {
    source.date_order = workbench::date_order_named(value);
    if (source.date_order) return;
    throw std::invalid_argument("no order of dates '" + value + "': dmy, mdy or ymd");
  } else if (key == "decimal") {
    source.decimal = decimal_of(value);
  } else {
    throw std::invalid_argument("no option '" + key + "'");
  }
}

std::shared_ptr<HeldRecording> read(const std::string& path, const Names& options,
                                    std::optional<double> ts, std::optional<int> loop,
                                    std::vector<std::string> loads,
                                    std::optional<double> u_before,
                                    const std::vector<std::string>& required) {
  workbench::RecordingSource source;
  source.path = path;
  source.ts = ts;
  source.loop = loop;
  source.names.loads = std::move(loads);
  source.u_before = u_before;
  source.required.clear();
  for (const std::string& name : required) source.required.push_back(signal_named(name));
  for (const auto& [key, value] : options) set(source, key, value);
  workbench::Recording recording;
  std::vector<workbench::Load> own_readings;
  run_long([&](const std::stop_token& stop) {
    source.stop = stop;
    recording = workbench::read_recording(source);
    workbench::check_stop(stop);
    own_readings = taken_aside(recording);
  });
  return std::make_shared<HeldRecording>(std::move(recording), std::move(own_readings));
}

py::dict units_of(const HeldRecording& recording) {
  py::dict out;
  for (const Column column : workbench::kLoopColumns) {
    const std::string& unit = recording.view().unit(column);
    if (!unit.empty()) out[py::str(std::string(workbench::name_of(column)))] = unit;
  }
  return out;
}

}  // namespace

void bind_recording(py::module_& module) {
  const auto column = [](Column which) {
    return [which](const HeldRecording& recording) { return recording.array(which); };
  };
  py::class_<HeldRecording, std::shared_ptr<HeldRecording>>(module, "Recording")
      .def(py::init([](HeldRecording::Columns columns, HeldRecording::Columns loads,
                       std::string name, std::optional<double> ts, Names units,
                       std::string start) {
             return std::make_shared<HeldRecording>(
                 std::move(columns), std::move(loads),
                 ArrayNotes{std::move(name), ts, std::move(units), std::move(start)});
           }),
           py::arg("columns"), py::arg("loads"), py::arg("name"), py::arg("ts"),
           py::arg("units"), py::arg("start"))
      .def_property_readonly("t", column(Column::t))
      .def_property_readonly("u", column(Column::u))
      .def_property_readonly("y", column(Column::y))
      .def_property_readonly("sp", column(Column::sp))
      .def_property_readonly("x", column(Column::x))
      .def_property_readonly("loads", &HeldRecording::loads)
      .def_property_readonly("own_readings", &HeldRecording::own_readings)
      .def_property_readonly("units", &units_of)
      .def_property_readonly(
          "name", [](const HeldRecording& r) { return readable(r.view().name); })
      .def_property_readonly("start",
                             [](const HeldRecording& r) { return r.view().start; })
      .def_property_readonly("notes",
                             [](const HeldRecording& r) {
                               py::list out;
                               for (const std::string& note : r.view().notes) {
                                 out.append(readable(note));
                               }
                               return out;
                             })
      .def_property_readonly("period_s",
                             [](const HeldRecording& r) { return r.view().period_s; })
      .def("part", &HeldRecording::part, py::arg("first"), py::arg("count"),
           py::arg("name"))
      .def("__len__", [](const HeldRecording& r) { return r.view().size(); });
  module.def("read", &read, py::arg("path"), py::arg("options"), py::arg("ts"),
             py::arg("loop"), py::arg("loads"), py::arg("u_before"), py::arg("required"));
}

}  // namespace stickband_python
