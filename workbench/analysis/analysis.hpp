// From a recording of any length to one answer, in bounded memory and time.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ident/identifier.hpp"
#include "workbench/analysis/votes.hpp"
#include "workbench/analysis/window_finding.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/recording_view.hpp"

namespace workbench {

using Identifier = ident::Identifier<double, 4096>;
using Identification = ident::Identification<double>;

/// False where the window was refused before a process could be fitted.
[[nodiscard]] bool has_model(const Identification& result);

/// Called every few milliseconds of work: window 1 … windows.
using Progress = std::function<void(int window, int windows)>;

/// How much of an answer is wanted. The verdict, its numbers and their evidence are the
/// same in both.
enum class Depth {
  kModels,   ///< all of it
  kVerdict,  ///< no two-path model but where u turns too seldom for a verdict without it,
             ///< and no model gap: about a quarter less time
};

/// One analysed window at the rate of the analysis, with what the models make of it.
struct Simulation {
  double period_s = 0;     ///< of these samples, s
  std::vector<double> t;   ///< s
  std::vector<double> u;   ///< controller output
  std::vector<double> y;   ///< process output
  std::vector<double> sp;  ///< setpoint; empty where not recorded
  std::vector<double> x;   ///< recorded valve position; empty where not recorded
  std::vector<double>
      y_two_path;  ///< free simulation of the two-path model; empty without one
  std::vector<double> y_valve;  ///< of the physical valve; empty where none was found
  std::vector<double> stem;     ///< its stem, units of u; empty where none was found
};

/// Identifies a recording, or several of one loop.
///
/// Up to kCapacity samples are one window. A longer recording is thinned out to means
/// of `decimation` samples where a window would hold fewer than kCyclesOfAWindow cycles
/// of its fastest oscillation, as means blur the instant of a slip, and u leaps nowhere
/// within such a mean; up to kMostWindows windows spread over it are identified. Those
/// that cannot tell abstain, those in which nothing moves have no say; a fault
/// (stiction or backlash) or its absence stands if more of the time they cover says so
/// than the opposite, and at least a quarter of it (votes.hpp). Numbers are medians.
/// Besides, the windows' closed-loop evidence is added up for each stick band: one valve
/// has to serve them all. A sum that is beyond doubt makes a fault of windows that are
/// not sure; a fault of which the sum knows nothing is undecided, and so is "no
/// stiction" of which it knows something. Each window's search starts from the valve of
/// the one before; one that found another is looked at again from the one after it. A
/// recording with long gaps is judged by its pieces (judged_pieces.hpp) as if they were
/// several. One that was joined from several is cut there, and its longest part is
/// judged; a start-up before a limit cycle is left out. Recordings that contradict each
/// other are told so (contradiction.hpp), one that is given twice counts once. `notes`
/// says what was done.
class Analysis {
 public:
  static constexpr int kMostWindows = 8;
  static constexpr double kCyclesOfAWindow = 12;

  /// The samples are read here and not kept. What `progress` throws ends the analysis.
  /// Fewer windows give a first answer early; one lies in the middle.
  explicit Analysis(const RecordingView& recording, const Progress& progress = {},
                    int most_windows = kMostWindows);
  /// At least one recording; all of one loop, in the same units.
  explicit Analysis(const std::vector<RecordingView>& recordings,
                    const Progress& progress = {}, Depth depth = Depth::kModels);
  explicit Analysis(const std::vector<Recording>& recordings,
                    const Progress& progress = {}, Depth depth = Depth::kModels);

  /// Of the whole recording; samples are `period_s()` apart, those of the window that
  /// stands for it.
  [[nodiscard]] const Identification& result() const { return result_; }
  [[nodiscard]] double period_s() const {
    return signals_[windows_.empty() ? 0 : windows_[shown_].recording].period_s;
  }
  [[nodiscard]] int decimation() const { return decimation_; }
  /// Of all recordings, those that are given twice once.
  [[nodiscard]] std::size_t samples() const { return samples_; }
  [[nodiscard]] int windows() const { return static_cast<int>(windows_.size()); }
  [[nodiscard]] const std::vector<WindowFinding>& findings() const { return findings_; }
  /// Closed-loop evidence of all windows together; its band in units of u.
  [[nodiscard]] const ident::LadderFinding<double>& pooled() const { return pooled_; }
  /// What percentages refer to, units of u: the range of u over all recordings, unless
  /// refer_to() was told another.
  [[nodiscard]] double span() const { return referred_ > 0 ? referred_ : span_; }
  [[nodiscard]] bool span_is_told() const { return referred_ > 0; }
  void refer_to(double span) { referred_ = span; }
  /// One sentence each, for people; empty for a recording that fits one window.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] double runtime_ms() const { return runtime_ms_; }

  /// The window that stands for the recording. Identifies it again if others came after.
  [[nodiscard]] Simulation simulate();

 private:
  struct Window {
    std::size_t recording;  // of signals_
    std::size_t first;
    std::size_t length;
    ident::EarlierValve earlier;  // that its search starts from
  };

  void run(const Progress& progress, int most_windows);
  [[nodiscard]] static int decimation_of(const RecordingView& recording);
  void thin_out(const RecordingView& recording, int decimation);
  void lay_windows(int most);
  [[nodiscard]] float new_share(std::size_t window) const;
  void identify(std::size_t window, ident::EvidencePool* pool, const Progress& progress);
  void identify_windows(std::vector<Identification>& results, ident::EvidencePool& pool,
                        const Progress& progress);
  [[nodiscard]] ident::EarlierValve handed_on(std::size_t from, std::size_t to,
                                              ident::EarlierValve valve) const;
  [[nodiscard]] WindowFinding finding_of(const Window& window) const;
  void leave_open(ident::Reason reason);
  void vote(const std::vector<Identification>& results);
  void note_votes();
  void mind_detectable();
  void mind_one_signal();
  void judge_together(const std::vector<Identification>& results, float counted);
  void mind_contradictions();
  void take(const RecordingView& recording);
  // Of the samples of `piece`, `before` samples after the start of a recording of
  // `whole`.
  [[nodiscard]] RecordingView longest_of(const RecordingView& piece, std::size_t before,
                                         std::size_t whole);
  [[nodiscard]] RecordingView without_start_up(const RecordingView& recording);
  void take_health(const std::vector<Identification>& results);

  Depth depth_ = Depth::kModels;
  // Where signals come from.
  struct Source {
    std::size_t recording;
    double share;  // of its samples, 0 … 1
  };

  std::vector<Recording> signals_;  // of each piece, at the rate of the analysis
  std::vector<Source> sources_;     // of signals_
  std::size_t recordings_ = 0;
  std::size_t samples_ = 0;
  std::vector<Window> windows_;
  std::size_t shown_ = 0;
  std::size_t identified_ = 0;
  int decimation_ = 1;
  std::size_t seam_at_ = 0;  // sample of the recording where it was cut
  double span_ = 0;
  double referred_ = 0;
  std::unique_ptr<Identifier> identifier_;
  Identification result_;
  std::vector<WindowFinding> findings_;
  ident::LadderFinding<double> pooled_;
  std::vector<std::string> notes_;
  double runtime_ms_ = 0;
};

}  // namespace workbench
