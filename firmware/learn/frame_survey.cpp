#include "firmware/learn/frame_survey.hpp"

#include <algorithm>

namespace firmware {
namespace {

template <class T>
void drop_every_second(std::vector<T>& values) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < values.size(); k += 2) values[kept++] = values[k];
  values.resize(kept);
}

}  // namespace

double SurveyedFrame::rate_hz() const {
  if (count < 2 || last_us <= first_us) return 0;
  return static_cast<double>(count - 1) /
         (static_cast<double>(last_us - first_us) * 1e-6);
}

void FrameSurvey::take(const std::string& bus, std::int64_t t_us,
                       const wire::CanFrame& frame) {
  if (frame.remote || frame.error) return;
  if (frames_++ == 0) first_us_ = last_us_ = t_us;
  last_us_ = std::max(last_us_, t_us);
  const Key key(bus, frame.extended, frame.id);
  auto at = known_.find(key);
  if (at == known_.end()) {
    if (known_.size() == kMostIds) {
      ++passed_over_;
      return;
    }
    at = known_.emplace(key, SurveyedFrame{}).first;
    SurveyedFrame& fresh = at->second;
    fresh.bus = bus;
    fresh.id = frame.id;
    fresh.extended = frame.extended;
    fresh.shortest = fresh.longest = frame.dlc;
    fresh.first_us = t_us;
    fresh.newest = frame;
  }
  SurveyedFrame& known = at->second;
  for (std::size_t k = 0; k < known.changes.size(); ++k) {
    known.changes[k] += frame.data[k] != known.newest.data[k] ? 1 : 0;
  }
  if (known.count++ % known.stride == 0) {
    if (known.frames.size() == kMostKept) {
      drop_every_second(known.frames);
      drop_every_second(known.time_us);
      known.stride *= 2;
    }
    known.frames.push_back(frame);
    known.time_us.push_back(t_us);
  }
  known.fd |= frame.fd;
  known.shortest = std::min(known.shortest, frame.dlc);
  known.longest = std::max(known.longest, frame.dlc);
  known.last_us = t_us;
  known.newest = frame;
}

double FrameSurvey::duration_s() const {
  return static_cast<double>(last_us_ - first_us_) * 1e-6;
}

std::vector<const SurveyedFrame*> FrameSurvey::all() const {
  std::vector<const SurveyedFrame*> out;
  for (const auto& [key, frame] : known_) out.push_back(&frame);
  return out;
}

}  // namespace firmware
