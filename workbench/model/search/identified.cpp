#include "workbench/model/search/identified.hpp"

#include <chrono>
#include <utility>

namespace workbench {

Identified::Identified(std::vector<Recording> recordings, Progress progress)
    : recordings_(std::move(recordings)), progress_(std::move(progress)) {}

void Identified::begin() {
  begun_ = std::async(std::launch::async, [this] {
    const auto go_on = [this](int, int) {
      if (given_up_) throw Stopped{};
    };
    return Analysis(recordings_, go_on, Depth::kVerdict).result();
  });
}

const Identification& Identified::result(const Work& work) {
  using namespace std::chrono_literals;
  const std::lock_guard lock(mutex_);
  if (result_) return *result_;
  if (begun_.valid()) {
    while (begun_.wait_for(10ms) != std::future_status::ready) work.check();
    result_ = begun_.get();
  } else {
    const auto go_on = [&](int window, int windows) {
      work.check();
      if (progress_) progress_(window, windows);
    };
    result_ = Analysis(recordings_, go_on, Depth::kVerdict).result();
  }
  return *result_;
}

}  // namespace workbench
