// What the page works on: a recording, the models of it so far, the work under way.
//
//   open → (fit) → explain → (explanation) → add → (fit) → … → undo → redo
//        → (verdict on the valve)
//
// What stands in brackets is long work and runs on a thread of its own, the verdict
// beside the models; view(), progress() and verdict_progress() tell how things stand at
// any time. Every member may be called from any thread. Deterministic but for progress.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "workbench/model/base/model.hpp"
#include "workbench/model/judge/compare.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/serve/valve_answer.hpp"
#include "workbench/serve/worker.hpp"

namespace workbench {

struct CsvOptions;

/// What cannot be done as things stand: without a recording, or while work goes on.
class NotNow : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether a higher controller output opens the valve.
enum class Opens { unknown, yes, no };

/// A model with what is known about it.
struct ModelStep {
  Model model;
  Comparison comparison;                     ///< with the recording that is open
  std::optional<ExplainResult> explanation;  ///< once asked for
  std::optional<LadderResult> ladder;        ///< where the ladder made it
  bool fitted_here = true;  ///< false: to another recording than the one that is open
};

/// What effects would do for the last model, fitted but not added.
struct Preview {
  std::vector<std::string> effects;
  std::shared_ptr<const ModelStep> step;
};

/// A recording beside the one that is open.
struct BesideRecording {
  std::shared_ptr<const Recording> recording;
  bool fitted = false;  ///< together with the one that is open; else judged
  std::string source;   ///< as SessionView::source
};

/// Parameters that a fit leaves as they are: group ("process" or an effect's code), name.
using HeldNames = std::vector<std::pair<std::string, std::string>>;

/// How things stand. A copy is cheap and does not change any more.
struct SessionView {
  std::uint64_t revision = 0;      ///< grows with every change of recording or models
  std::uint64_t drawn = 0;         ///< grows where recording or last model change
  std::uint64_t opened_count = 0;  ///< grows with every recording opened, or chosen from
  /// Of the recording that is open, whatever is chosen from it: another number for every
  /// one opened, in other runs of the program too. Before the first Session::begun().
  std::uint64_t opening = 0;
  /// What models are fitted to; null before the first. Joined (model/joined.hpp) where
  /// others are fitted, too.
  std::shared_ptr<const Recording> recording;
  std::shared_ptr<const Recording> own;    ///< then the one that is open; else null
  std::shared_ptr<const Recording> whole;  ///< of which a range is open; else null
  std::uint64_t stopped_at = 0;  ///< revision in which work was stopped; 0: since begun
  std::string source;  ///< the recording as words of a command line; "": unknown
  Opens opens = Opens::unknown;  ///< said of this recording
  std::string maker;             ///< the command that writes its file; "": it is there
  /// How its file was read, for others like it; may be null.
  std::shared_ptr<const CsvOptions> reading;
  std::shared_ptr<const ValveAnswer> valve;         ///< null until it is identified
  std::shared_ptr<const ValveAnswer> valve_so_far;  ///< of one window, before that
  std::shared_ptr<const Preview> preview;           ///< of the last model; may be null
  std::vector<BesideRecording> beside;
  std::vector<std::shared_ptr<const ModelStep>> steps;   ///< undo goes back through them
  std::vector<std::shared_ptr<const ModelStep>> undone;  ///< redo takes the last
  /// How things stood before the samples were chosen anew; undo goes back to it from the
  /// first model. Null where they were not.
  std::shared_ptr<const SessionView> chosen_from;

  [[nodiscard]] bool can_undo() const {
    return steps.size() > 1 || chosen_from != nullptr;
  }

  /// Somebody stopped the work on these models: no page begins it by itself.
  [[nodiscard]] bool is_stopped() const {
    return stopped_at > 0 && stopped_at == revision;
  }
  /// The recording. Throws NotNow where there is none.
  [[nodiscard]] const Recording& opened() const;
  /// The model as it is. Throws NotNow where there is none (yet).
  [[nodiscard]] const ModelStep& last() const;
  /// What is modelled: the model's output; before the first y, or x where there is no y.
  [[nodiscard]] Column output() const;
};

/// What of it is modelled unless told otherwise: y, or x where there is no y.
[[nodiscard]] Column usual_output(const Recording& recording);

/// By somebody, or by a page that does so by itself.
enum class Asked { yes, no };

class Session {
 public:
  Session();
  /// A file is on its way that was asked for at `turn`, a number that grows from file to
  /// file (ms since 1970): what was asked for before is not opened any more. 0: always.
  /// Throws NotNow where that is said of this one. open(), judge() and restore() throw
  /// it, too, and leave everything as it was.
  void await(std::uint64_t turn);
  /// Drops what was there, stops its work and starts the fit of a textbook model. Throws
  /// InputError, and leaves everything as it was, where no model of `output` can be
  /// fitted: u or the output is missing or constant, or there are too few samples.
  /// `source` names the recording on a command line, with its options.
  void open(Recording recording, Column output, std::string source = {},
            std::shared_ptr<const CsvOptions> reading = {}, std::uint64_t turn = 0);
  /// Opens another recording and judges the present model on it; only the initial state
  /// is estimated. Throws as open(), and NotNow without a model.
  void judge(Recording recording, std::string source = {},
             std::shared_ptr<const CsvOptions> reading = {}, std::uint64_t turn = 0);
  /// Opens the samples between two times of the whole recording, s, or all of it where
  /// there is no range: to fit a new model to them, or to judge the present one. Throws
  /// as open() and judge(), and NotNow where several recordings are fitted together.
  enum class Purpose { kFit, kJudge };
  void choose(std::optional<std::pair<double, double>> range, Purpose purpose);
  /// Neither fits, judges nor identifies from the samples between two times, s, besides
  /// those left out before; or takes all of them in again, where there is no range. Then
  /// fits a new model. Throws as choose().
  void leave_out(std::optional<std::pair<double, double>> range);
  /// The same with every stretch in manual (Recording::manual). Throws NotNow where there
  /// is none.
  void leave_out_manual();
  /// Shares the samples out anew and fits a new model. Throws as open(), and
  /// std::invalid_argument for a share outside 0.2 … 0.9 or a negative length.
  void share_out(Split split);
  /// Judges every model on this recording, too, and fits nothing to it. Throws InputError
  /// where it has no u or lacks the output, NotNow beside no recording or beside
  /// kMostBeside others.
  void accompany(Recording recording, std::string source = {});
  inline static constexpr std::size_t kMostBeside = 6;
  /// From now on fits models to the recording `which` of SessionView::beside as well, or
  /// no more: fits the present model anew, as a step whose history says so
  /// (kRefitted). Throws InputError, and leaves everything as it was, where units or
  /// sample periods differ, NotNow without that recording or without a model.
  void fit_together(std::size_t which, bool fitted);
  /// No more of the recording `which` of SessionView::beside; where it was fitted, as
  /// fit_together() without it. Throws NotNow without it.
  void dismiss(std::size_t which);
  /// Brings back a recording with its models, the last of `steps` being the present one;
  /// at least one. Throws InputError, and leaves everything as it was, where a model
  /// cannot be judged on the recording.
  void restore(Recording recording, std::string source, std::vector<Model> steps,
               std::vector<Model> undone, std::vector<BesideRecording> beside = {},
               std::uint64_t turn = 0);
  /// Says of the recording that is open what only changes words. Throws NotNow without
  /// one.
  void say_opens(Opens opens);
  /// Says which command writes the file of the recording that is open. Throws NotNow
  /// without one.
  void say_maker(std::string command);
  /// Takes a model as it is, in place of the present one; ends work that goes on. Throws
  /// NotNow without a recording, InputError where the recording lacks its output.
  void take(Model model);

  // Each starts work. Throws NotNow where that cannot be; what else goes wrong is in
  // failure().

  /// A textbook model of `output` with the effects of `with`. Throws
  /// std::invalid_argument for an effect that is unknown or named twice, InputError as
  /// open().
  void start(Column output, std::vector<std::string> with);
  /// What the last model lacks. Not asked for, as by a page that begins it by itself, it
  /// throws NotNow where SessionView::is_stopped().
  void explain(Asked asked = Asked::yes);
  /// Fits all parameters of `model` again but those that are held, from where they are,
  /// as one step.
  void refit(Model model, HeldNames held = {});
  /// Fits what add() would, and keeps it as SessionView::preview. Throws as add().
  void preview(std::vector<std::string> effects);
  /// Adds effects one after the other, as one step; at once where they were previewed.
  /// Throws std::invalid_argument for one
  /// that is unknown, named twice or already in the model.
  void add(std::vector<std::string> effects);
  /// Takes an effect out again, as one step. Throws std::invalid_argument for one that
  /// the model lacks.
  void remove(std::string effect);
  /// From the textbook model up, as `stickband ladder`: each of its steps is one here as
  /// soon as it is done.
  void climb();

  /// Back to the model before or, at the first, to the samples chosen before. Stops work
  /// that goes on. Throws NotNow where there is neither.
  void undo();
  /// Takes back the last undo(). Throws NotNow where nothing was undone since the last
  /// new model, or while work goes on.
  void redo();
  /// Stops work on models, if any goes on, and waits for it; things stand as before it
  /// began, but for the steps of climb() that were done.
  /// Until other work begins, or the models change, SessionView::is_stopped() says so.
  void cancel();

  [[nodiscard]] SessionView view() const;
  /// When the session began, µs since 1970.
  [[nodiscard]] std::uint64_t begun() const { return begun_; }
  [[nodiscard]] std::optional<WorkProgress> progress() const {
    return worker_.progress();
  }
  /// Why the last work failed; null where it did not.
  [[nodiscard]] std::exception_ptr failure() const { return worker_.failure(); }
  /// Of the verdict on the valve.
  [[nodiscard]] std::optional<WorkProgress> verdict_progress() const {
    return valve_worker_.progress();
  }
  /// Why there is no verdict; null where there is, or work goes on.
  [[nodiscard]] std::exception_ptr verdict_failure() const {
    return valve_worker_.failure();
  }

 private:
  void begin(std::string task, Worker::Task work, Asked asked = Asked::yes);
  // Begins work that makes one step, and pushes that.
  using MakeStep =
      std::function<std::shared_ptr<const ModelStep>(const Worker::Report&, const Work&)>;
  void begin_step(std::string task, MakeStep make);
  void fit(std::shared_ptr<const Recording> recording, Column output,
           std::vector<std::string> with);
  void replace(SessionView next);
  void show_new(SessionView next, std::uint64_t turn);
  void push(std::shared_ptr<const ModelStep> step, bool replaces_last = false);
  void take_up(SessionView next, Purpose purpose);
  void regroup(std::vector<BesideRecording> beside);
  void refuse_while_together() const;
  void install(SessionView next);
  void identify(std::shared_ptr<const Recording> recording);

  const std::uint64_t begun_;
  std::mutex opening_;        // taken before all others; one recording after the other
  std::mutex beginning_;      // taken before mutex_; between a stop and the next work
  mutable std::mutex mutex_;  // of view_ and turn_
  SessionView view_;
  std::uint64_t turn_ = 0;  // of the last file that was asked for
  Worker valve_worker_;
  Worker worker_;  // last, with the one before: their threads use the others
};

}  // namespace workbench
