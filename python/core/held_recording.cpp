#include "python/core/held_recording.hpp"

#include <algorithm>
#include <cmath>

#include "python/core/long_work.hpp"
#include "workbench/analysis/longest_part.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/own_readings.hpp"
#include "workbench/recording/resample.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

using workbench::Column;
using workbench::InputError;
using workbench::Recording;

Column known_column(const std::string& name) {
  const std::optional<Column> column = workbench::column_named(name);
  if (!column) throw std::invalid_argument("no column '" + name + "'");
  return *column;
}

std::span<const double>& slot_of(workbench::RecordingView& view, Column column) {
  switch (column) {
    case Column::u:
      return view.u;
    case Column::y:
      return view.y;
    case Column::sp:
      return view.sp;
    case Column::x:
      return view.x;
    case Column::t:
      break;
  }
  return view.t;
}

void refuse_times_that_do_not_rise(std::span<const double> t) {
  const auto bad =
      std::ranges::adjacent_find(t, [](double a, double b) { return !(a < b); });
  if (bad == t.end()) return;
  throw InputError("array t", 0, 0, "times in seconds that rise",
                   workbench::number(bad[1], 9) + " after " +
                       workbench::number(bad[0], 9) + " at index " +
                       std::to_string(bad - t.begin() + 1),
                   "sort the samples by time and drop repeated ones");
}

// True where every sample has an instant of its own on the grid as it is.
bool equally_spaced(std::span<const double> t, const workbench::Spacing& spacing) {
  if (spacing.irregular > 0 || spacing.on_time_share < 1) return false;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (std::round((t[i] - t[i - 1]) / spacing.period_s) > 1) return false;
  }
  return true;
}

const workbench::Load* load_named(const std::vector<workbench::Load>& loads,
                                  const std::string& name) {
  const auto found = std::ranges::find(loads, name, &workbench::Load::name);
  return found == loads.end() ? nullptr : &*found;
}

std::vector<double> copy_of(std::span<const double> values) {
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<workbench::Load> taken_aside(Recording& recording) {
  std::vector<workbench::Load> out = recording.loads;
  workbench::leave_out_own_readings(recording);
  std::erase_if(out, [&recording](const workbench::Load& load) {
    return load_named(recording.loads, load.name) != nullptr;
  });
  return out;
}

HeldRecording::HeldRecording(Recording recording,
                             std::vector<workbench::Load> own_readings)
    : own_readings_(std::move(own_readings)) {
  take(std::move(recording));
}

HeldRecording::HeldRecording(Columns columns, Columns loads, ArrayNotes notes)
    : columns_(std::move(columns)), loads_(std::move(loads)), lent_(true) {
  view_.name = std::move(notes.name);
  view_.start = std::move(notes.start);
  std::optional<std::size_t> length;
  const auto checked = [&length](const std::string& name, const Doubles& array) {
    const std::span<const double> values = samples_of(array, name);
    if (!length) length = values.size();
    if (*length != values.size()) {
      throw InputError("array " + name, 0, 0, std::to_string(*length) + " samples",
                       std::to_string(values.size()),
                       "pass arrays of one length, a sample each at the same times");
    }
    refuse_what_is_not_finite(values, name);
    return values;
  };
  for (const auto& [name, array] : columns_) {
    slot_of(view_, known_column(name)) = checked(name, array);
  }
  for (const auto& [name, array] : loads_) (void)checked(name, array);
  for (auto& [name, unit] : notes.units) {
    view_.units[static_cast<std::size_t>(known_column(name))] = std::move(unit);
  }
  if (length.value_or(0) < 2) {
    throw InputError("arrays", 0, 0, "at least 2 samples",
                     std::to_string(length.value_or(0)), "record for longer");
  }
  lay_in_time(notes.ts, *length);
  take_own_readings_aside();
}

void HeldRecording::lay_in_time(std::optional<double> ts, std::size_t length) {
  if (ts) {
    view_.period_s = *ts;
    t_.resize(length);
    for (std::size_t i = 0; i < t_.size(); ++i) t_[i] = static_cast<double>(i) * *ts;
    view_.t = t_;
    return;
  }
  refuse_times_that_do_not_rise(view_.t);
  const workbench::Spacing spacing = workbench::spacing_of(view_.t);
  if (equally_spaced(view_.t, spacing)) {
    view_.period_s = spacing.period_s;
    return;
  }
  workbench::TimedRows rows;
  rows.place = "sample";
  rows.t = copy_of(view_.t);
  for (std::size_t i = 0; i < rows.t.size(); ++i) {
    rows.line.push_back(static_cast<std::uint32_t>(i));
  }
  for (const Column column : workbench::kLoopColumns) {
    rows.values[static_cast<std::size_t>(column)] = copy_of(view_.values(column));
  }
  Recording out;
  out.name = view_.name;
  out.units = view_.units;
  out.start = view_.start;
  for (const auto& [name, array] : loads_) {
    out.loads.push_back({name, "", {}});
    rows.loads.push_back(copy_of(samples_of(array, name)));
  }
  workbench::resample(std::move(rows), "arrays", out);
  take(std::move(out));
}

void HeldRecording::take_own_readings_aside() {
  if (loads_.empty() && (!whole_ || whole_->loads.empty())) return;
  Recording judged = *whole();
  run_long([&](const std::stop_token&) { own_readings_ = taken_aside(judged); });
  if (own_readings_.empty()) return;
  if (!lent_) {
    take(std::move(judged));
    return;
  }
  view_.notes = judged.resampling.notes;
  whole_ = std::make_shared<const Recording>(std::move(judged));
  std::erase_if(loads_, [this](const auto& load) {
    return load_named(own_readings_, load.first) != nullptr;
  });
}

void HeldRecording::take(Recording recording) {
  lent_ = false;
  whole_ = std::make_shared<const Recording>(std::move(recording));
  view_ = workbench::RecordingView(*whole_);
  columns_.clear();
  loads_.clear();
}

const std::shared_ptr<const Recording>& HeldRecording::whole() const {
  if (whole_) return whole_;
  auto copy = std::make_shared<Recording>();
  copy->name = view_.name;
  copy->period_s = view_.period_s;
  copy->units = view_.units;
  copy->start = view_.start;
  for (const Column column : workbench::kAllColumns)
    copy->values(column) = copy_of(view_.values(column));
  for (const auto& [name, array] : loads_) {
    copy->loads.push_back({name, "", copy_of(samples_of(array, name))});
  }
  whole_ = std::move(copy);
  return whole_;
}

std::shared_ptr<const Recording> HeldRecording::whole_with(
    std::span<const std::string> own_readings) const {
  std::shared_ptr<Recording> out;
  for (const std::string& name : own_readings) {
    const workbench::Load* const load = load_named(own_readings_, name);
    if (load == nullptr) continue;
    if (!out) out = std::make_shared<Recording>(*whole());
    out->loads.push_back(*load);
  }
  return out ? out : whole();
}

std::shared_ptr<HeldRecording> HeldRecording::part(std::size_t first, std::size_t count,
                                                   std::string name) const {
  if (lent_) return nullptr;
  Recording out = workbench::cut_out(*whole_, {first, count, 0});
  out.name = std::move(name);
  out.start.clear();
  std::vector<workbench::Load> own_readings = own_readings_;
  for (workbench::Load& load : own_readings) {
    const auto begin = load.values.begin() + static_cast<std::ptrdiff_t>(first);
    load.values = {begin, begin + static_cast<std::ptrdiff_t>(count)};
  }
  return std::make_shared<HeldRecording>(std::move(out), std::move(own_readings));
}

py::object HeldRecording::array(Column column) const {
  const std::span<const double> values = view_.values(column);
  if (values.empty()) return py::none();
  if (lent_) {
    for (const auto& [name, array] : columns_) {
      if (name == workbench::name_of(column)) return array;
    }
  }
  return view_of(values, py::cast(this));
}

py::dict HeldRecording::loads() const {
  py::dict out;
  if (lent_) {
    for (const auto& [name, array] : loads_) out[py::str(name)] = array;
    return out;
  }
  for (const workbench::Load& load : whole_->loads) {
    out[py::str(load.name)] = view_of(load.values, py::cast(this));
  }
  return out;
}

py::dict HeldRecording::own_readings() const {
  py::dict out;
  for (const workbench::Load& load : own_readings_) {
    out[py::str(load.name)] = view_of(load.values, py::cast(this));
  }
  return out;
}

}  // namespace stickband_python
