#include "workbench/recording/recording_view.hpp"

namespace workbench {

RecordingView::RecordingView(const Recording& recording)
    : name(recording.name),
      period_s(recording.period_s),
      t(recording.t),
      u(recording.u),
      y(recording.y),
      sp(recording.sp),
      x(recording.x),
      units(recording.units),
      tags(recording.tags),
      loop(recording.loop),
      start(recording.start),
      notes(recording.resampling.notes),
      gaps(recording.resampling.gaps) {}

RecordingView RecordingView::part(std::size_t first, std::size_t length) const {
  RecordingView out = *this;
  for (std::span<const double>* values : {&out.t, &out.u, &out.y, &out.sp, &out.x}) {
    if (!values->empty()) *values = values->subspan(first, length);
  }
  out.gaps = clipped(gaps, {first, first + length});
  return out;
}

}  // namespace workbench
