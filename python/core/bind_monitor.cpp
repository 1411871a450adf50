#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <memory>

#include "python/core/arrays.hpp"
#include "python/core/bindings.hpp"
#include "python/core/long_work.hpp"
#include "workbench/analysis/device_monitor.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/recording/stopped.hpp"

namespace py = pybind11;

namespace stickband_python {
namespace {

using workbench::DeviceMonitor;

const char* name_of(ident::PushResult result) {
  switch (result) {
    case ident::PushResult::kAccepted:
      return "accepted";
    case ident::PushResult::kGap:
      return "gap";
    case ident::PushResult::kRepeat:
      return "repeat";
    case ident::PushResult::kNonFinite:
      return "non_finite";
    case ident::PushResult::kTimeBack:
      return "time_back";
  }
  return "accepted";
}

// Times beyond what the monitor takes are refused by it as not finite.
std::int64_t microseconds(double t_s) {
  constexpr double kBeyond = 4e18;
  return std::llround(
      std::clamp(std::isnan(t_s) ? kBeyond : t_s * 1e6, -kBeyond, kBeyond));
}

ident::Sample<float> sample_of(double t_s, double u, double y, std::optional<double> sp) {
  return {microseconds(t_s), static_cast<float>(u), static_cast<float>(y),
          static_cast<float>(sp.value_or(0)), sp.has_value()};
}

// The device's monitor; one thread of Python at a time.
class Monitor {
 public:
  Monitor(double period_s, std::pair<float, float> span, int gain_sign, int longest_hold,
          int evaluate_every_pct, int memory_pct, int first_cycles)
      : period_s_(period_s) {
    ident::MonitorSettings<float> settings;
    settings.sample_period_us = std::llround(period_s * 1e6);
    settings.span_low = span.first;
    settings.span_high = span.second;
    settings.gain_sign = gain_sign;
    settings.longest_hold = longest_hold;
    settings.evaluate_every_pct = evaluate_every_pct;
    settings.memory_pct = memory_pct;
    settings.first_cycles = first_cycles;
    device_ = std::make_unique<DeviceMonitor>(settings);
  }

  std::string push(double t_s, double u, double y, std::optional<double> sp) {
    const InUse in_use(*this);
    ++samples_;
    return name_of(device_->push(sample_of(t_s, u, y, sp)));
  }
  bool step(int budget) {
    const InUse in_use(*this);
    const py::gil_scoped_release released;
    return workbench::timed_step(*device_, budget, worst_step_us_);
  }
  // Every sample with all the work that it makes due, as `stickband monitor`.
  void feed(const Doubles& t, const Doubles& u, const Doubles& y,
            const std::optional<Doubles>& sp) {
    const InUse in_use(*this);
    const auto times = samples_of(t, "t");
    const auto us = samples_of(u, "u");
    const auto ys = samples_of(y, "y");
    const auto sps = sp ? samples_of(*sp, "sp") : std::span<const double>();
    for (const auto values : {us, ys, sp ? sps : us}) {
      if (values.size() == times.size()) continue;
      throw std::invalid_argument("t, u, y and sp must have as many samples");
    }
    run_long([&](const std::stop_token& stop) {
      for (std::size_t i = 0; i < times.size(); ++i) {
        const auto setpoint = sp ? std::optional(sps[i]) : std::nullopt;
        ++samples_;
        device_->push(sample_of(times[i], us[i], ys[i], setpoint));
        finish(stop);
      }
    });
  }
  void end_recording() {
    const InUse in_use(*this);
    run_long([&](const std::stop_token& stop) {
      device_->end_recording();
      finish(stop);
    });
  }
  std::vector<std::string> events() {
    const InUse in_use(*this);
    collect();
    return std::exchange(events_, {});
  }
  std::string summary() {
    const InUse in_use(*this);
    return workbench::json_line(
        workbench::summary_json(samples_, device_->report(), worst_step_us_));
  }
  bool busy() {
    const InUse in_use(*this);
    return device_->busy();
  }

 private:
  class InUse {
   public:
    explicit InUse(Monitor& monitor) : monitor_(monitor) {
      if (monitor_.in_use_.exchange(true)) {
        throw std::runtime_error("the monitor is at work in another thread");
      }
    }
    ~InUse() { monitor_.in_use_ = false; }
    InUse(const InUse&) = delete;
    InUse& operator=(const InUse&) = delete;

   private:
    Monitor& monitor_;
  };

  void finish(const std::stop_token& stop) {
    while (workbench::timed_step(*device_, workbench::kDeviceSlice, worst_step_us_)) {
      workbench::check_stop(stop);
    }
    collect();
  }
  void collect() {
    while (const auto event = device_->poll()) {
      events_.push_back(workbench::json_line(workbench::event_json(*event, period_s_)));
    }
  }

  double period_s_;
  std::unique_ptr<DeviceMonitor> device_;
  std::size_t samples_ = 0;
  double worst_step_us_ = 0;
  std::vector<std::string> events_;  // told and not yet read
  std::atomic<bool> in_use_ = false;
};

}  // namespace

void bind_monitor(py::module_& module) {
  const ident::MonitorSettings<float> usual;
  py::class_<Monitor>(module, "Monitor")
      .def(py::init<double, std::pair<float, float>, int, int, int, int, int>(),
           py::arg("period_s"), py::arg("span"), py::arg("gain_sign") = usual.gain_sign,
           py::arg("longest_hold") = usual.longest_hold,
           py::arg("evaluate_every_pct") = usual.evaluate_every_pct,
           py::arg("memory_pct") = usual.memory_pct,
           py::arg("first_cycles") = usual.first_cycles)
      .def("push", &Monitor::push, py::arg("t"), py::arg("u"), py::arg("y"),
           py::arg("sp"))
      .def("step", &Monitor::step, py::arg("budget"))
      .def("feed", &Monitor::feed, py::arg("t").noconvert(), py::arg("u").noconvert(),
           py::arg("y").noconvert(), py::arg("sp"))
      .def("end_recording", &Monitor::end_recording)
      .def("events", &Monitor::events)
      .def("summary", &Monitor::summary)
      .def_property_readonly("busy", &Monitor::busy)
      .def_property_readonly_static(
          "ram_bytes", [](const py::object&) { return DeviceMonitor::ram_bytes(); });
}

}  // namespace stickband_python
