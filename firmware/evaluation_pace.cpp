#include "firmware/evaluation_pace.hpp"

#include <algorithm>
#include <cmath>

namespace firmware {
namespace {

constexpr double kAlike = 0.2;      // of the larger one
constexpr double kSameMean = 0.33;  // deviations

bool alike(double a, double b) {
  return std::abs(a - b) <= kAlike * std::max(a, b);
}

}  // namespace

void EvaluationPace::Movement::push(double value) {
  if (count_ > 0) travel_ += std::abs(value - newest_);
  newest_ = value;
  ++count_;
  const double off = value - mean_;
  mean_ += off / static_cast<double>(count_);
  squares_ += off * (value - mean_);
}

double EvaluationPace::Movement::deviation() const {
  return std::sqrt(squares_ / static_cast<double>(std::max<std::size_t>(count_, 1)));
}

double EvaluationPace::Movement::travel() const {
  return travel_ / static_cast<double>(std::max<std::size_t>(count_, 1));
}

bool EvaluationPace::Movement::resembles(const Movement& other) const {
  return alike(deviation(), other.deviation()) && alike(travel(), other.travel()) &&
         std::abs(mean_ - other.mean_) <=
             kSameMean * std::max(deviation(), other.deviation());
}

void EvaluationPace::push(double u, double y) {
  block_.u.push(u);
  block_.y.push(y);
  ++fresh_;
}

bool EvaluationPace::begins(const Standing& now) {
  if (waits()) return false;
  const std::size_t renewed = now.judged * steady_pct_ / 100;
  const bool goes_on = judged_ && now.settled && now.oscillating == last_.oscillating &&
                       now.interruptions == last_.interruptions &&
                       block_.u.resembles(reference_.u) &&
                       block_.y.resembles(reference_.y);
  if (goes_on && fresh_ < renewed) {
    block_ = {};
    decide_at_ = std::min(fresh_ + every_, renewed);
    return false;
  }
  reference_ = block_;
  forced(now);
  return true;
}

void EvaluationPace::forced(const Standing& now) {
  block_ = {};
  last_ = now;
  judged_ = true;
  fresh_ = decide_at_ = 0;
}

}  // namespace firmware
