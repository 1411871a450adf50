#include "workbench/recording/rest_before.hpp"

#include <stdexcept>
#include <string>

#include "workbench/recording/resample.hpp"

namespace workbench {

void put_rest_before(Recording& recording, double u_before) {
  if (recording.u.empty() || recording.u.front() == u_before) {
    throw std::invalid_argument(
        "--u-before " + number(u_before) + ": u " +
        (recording.u.empty() ? "is not in the recording"
                             : "begins with that value, so that nothing moves there"));
  }
  const auto rest = [](std::vector<double>& values) {
    if (!values.empty()) values.insert(values.begin(), kRestSamples, values.front());
  };
  for (const Column column : kAllColumns) {
    rest(recording.values(column));
  }
  for (Load& load : recording.loads) rest(load.values);
  const double first = recording.t.front();
  for (std::size_t k = 0; k < kRestSamples; ++k) {
    recording.t[k] = first - recording.period_s * static_cast<double>(kRestSamples - k);
    recording.u[k] = u_before;
  }
  for (auto* ranges :
       {&recording.manual, &recording.left_out, &recording.resampling.gaps}) {
    for (SampleRange& range : *ranges) {
      range.first += kRestSamples;
      range.last += kRestSamples;
    }
  }
  recording.begins_at_rest = true;
  recording.start.clear();
  recording.resampling.notes.push_back(
      "u rested at " + number(u_before) + " before the first row, as was said: " +
      std::to_string(kRestSamples) + " samples like the first are put in front");
}

}  // namespace workbench
