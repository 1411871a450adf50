// Whether a window that is due is worth its identification: not while the loop goes on as
// it did.
//
// A loop whose verdict has stood and whose signals move as they did before gets the same
// verdict again, at a tenth of a second of a core each time. So such windows wait until
// as many samples are new as `steady_pct` of the window that was judged last. Each block
// of new samples is compared with that before the last evaluation: mean, deviation and
// travel of u and y. Any change (20 %, or a third of a deviation in the mean), an
// oscillation that starts or ends, an interruption of the input: the window is judged
// when it is due.
//
// Life: new → push with each sample; while a window is due, begins() until it is true,
// then the evaluation. One thread; no heap or clock. Cost: constant.
#pragma once

#include <cstddef>
#include <cstdint>

namespace firmware {

class EvaluationPace {
 public:
  /// The state of the loop when a window is due.
  struct Standing {
    bool settled = false;             ///< verdict and alarm stand
    bool oscillating = false;         ///< u or y does, now
    std::uint64_t interruptions = 0;  ///< faults and restarts of the window, so far
    std::size_t judged = 0;           ///< samples of the window that was judged last
  };

  /// `every`: new samples of a full window until it is due, ≥ 1. `steady_pct`: 1 … 100.
  EvaluationPace(std::size_t every, int steady_pct)
      : every_(every), steady_pct_(static_cast<std::size_t>(steady_pct)) {}

  /// A sample that the window has taken.
  void push(double u, double y);
  /// The next decision is not due yet: begins() would be false.
  [[nodiscard]] bool waits() const { return fresh_ < decide_at_; }
  /// True: judge the window that is due now. The next block of samples begins.
  [[nodiscard]] bool begins(const Standing& now);
  /// It is judged although nobody asked begins(): by request.
  void forced(const Standing& now);

 private:
  /// How a signal moved in a block of samples.
  class Movement {
   public:
    void push(double value);
    [[nodiscard]] bool resembles(const Movement& other) const;

   private:
    [[nodiscard]] double deviation() const;
    [[nodiscard]] double travel() const;

    std::size_t count_ = 0;
    double newest_ = 0;
    double mean_ = 0;
    double squares_ = 0;  // about the mean
    double travel_ = 0;
  };
  struct Block {
    Movement u;
    Movement y;
  };

  std::size_t every_;
  std::size_t steady_pct_;
  Block block_;      // of new samples
  Block reference_;  // before the last evaluation
  Standing last_;    // at the last evaluation
  bool judged_ = false;
  std::size_t fresh_ = 0;      // samples since the last evaluation
  std::size_t decide_at_ = 0;  // of them, next
};

}  // namespace firmware
