// What the identification of the valve says, for whoever asks, found once.
#pragma once

#include <atomic>
#include <future>
#include <mutex>
#include <optional>
#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/model/base/work.hpp"

namespace workbench {

/// One identification of recordings of one loop, without two-path models, made when first
/// asked for or, after begin(), by a thread of its own. Both say the same. Life:
/// construct → begin(), where wanted → result(), from any thread.
class Identified {
 public:
  /// At least one recording. `progress` is told of an identification without begin().
  explicit Identified(std::vector<Recording> recordings, Progress progress = {});
  /// Ends what began within some milliseconds.
  ~Identified() { given_up_ = true; }
  Identified(const Identified&) = delete;
  Identified& operator=(const Identified&) = delete;

  /// Once, and before result().
  void begin();

  /// Waits. Throws what the identification throws, and as Work::check().
  [[nodiscard]] const Identification& result(const Work& work);

 private:
  const std::vector<Recording> recordings_;
  const Progress progress_;
  std::mutex mutex_;
  std::optional<Identification> result_;
  std::atomic<bool> given_up_ = false;
  std::future<Identification> begun_;
};

}  // namespace workbench
