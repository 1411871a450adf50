#include "workbench/serve/session.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "workbench/effects/catalogue.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

void check_effects(const std::vector<std::string>& effects, const Model* model) {
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const std::string& code = effects[i];
    if (standard_catalogue().find(code) == nullptr) {
      throw std::invalid_argument(standard_catalogue().no_effect(code));
    }
    const auto here = effects.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(effects.begin(), here, code) != here) {
      throw std::invalid_argument(code + " is named twice");
    }
    if (model != nullptr && model->has(code)) {
      throw std::invalid_argument("the model already has " + code);
    }
  }
}

}  // namespace

const Recording& SessionView::opened() const {
  if (recording == nullptr) throw NotNow("no recording is open; open one first");
  return *recording;
}

Column usual_output(const Recording& recording) {
  return recording.has(Column::y) || !recording.has(Column::x) ? Column::y : Column::x;
}

Column SessionView::output() const {
  return steps.empty() ? usual_output(opened()) : last().model.output;
}

const ModelStep& SessionView::last() const {
  static_cast<void>(opened());
  if (steps.empty()) throw NotNow("there is no model yet; wait until it is fitted");
  return *steps.back();
}

Session::Session()
    : begun_(static_cast<std::uint64_t>(
          std::chrono::duration_cast<std::chrono::microseconds>(
              std::chrono::system_clock::now().time_since_epoch())
              .count())) {
  view_.opening = begun_;
}

SessionView Session::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

void Session::replace(SessionView next) {
  worker_.cancel();
  valve_worker_.cancel();
  install(std::move(next));
}

void Session::await(std::uint64_t turn) {
  if (turn == 0) return;
  const std::lock_guard lock(mutex_);
  if (turn < turn_) throw NotNow("another file was opened meanwhile");
  turn_ = turn;
}

void Session::show_new(SessionView next, std::uint64_t turn) {
  await(turn);
  next.opening = view().opening + 1;
  replace(std::move(next));
}

void Session::install(SessionView next) {
  std::shared_ptr<const Recording> recording = next.recording;
  const bool known = next.valve != nullptr;
  {
    const std::lock_guard lock(mutex_);
    next.revision = view_.revision + 1;
    next.drawn = view_.drawn + 1;
    next.opened_count = view_.opened_count + 1;
    if (next.opening == view_.opening) next.opens = view_.opens;
    view_ = std::move(next);
  }
  if (!known) identify(std::move(recording));
}

void Session::push(std::shared_ptr<const ModelStep> step, bool replaces_last) {
  const std::lock_guard lock(mutex_);
  ++view_.revision;
  ++view_.drawn;
  if (replaces_last) view_.steps.pop_back();
  view_.steps.push_back(std::move(step));
  view_.undone.clear();
  view_.preview.reset();
}

void Session::begin(std::string task, Worker::Task work, Asked asked) {
  const std::lock_guard beginning(beginning_);
  if (asked == Asked::no && view().is_stopped()) {
    throw NotNow("the search was stopped; it begins again where somebody asks for it");
  }
  if (!worker_.start(std::move(task), std::move(work))) {
    throw NotNow("work is under way; wait until it is done, or cancel it");
  }
  const std::lock_guard lock(mutex_);
  view_.stopped_at = 0;
}

void Session::begin_step(std::string task, MakeStep make) {
  begin(std::move(task), [this, make = std::move(make)](const Worker::Report& report,
                                                        const std::stop_token& stop) {
    auto step = make(report, Work({.threads = Work::cores(), .stop = stop}));
    report("", 0, 0);
    push(std::move(step));
  });
}

void Session::cancel() {
  const std::lock_guard beginning(beginning_);
  worker_.cancel();
  const std::lock_guard lock(mutex_);
  view_.stopped_at = view_.revision;
}

void Session::fit(std::shared_ptr<const Recording> recording, Column output,
                  std::vector<std::string> with) {
  begin_step("model", [recording = std::move(recording), output, with = std::move(with)](
                          const Worker::Report&, const Work& search) {
    return shared_step(
        *recording,
        start_model(*recording, output, with, standard_catalogue(), search).model);
  });
}

void Session::identify(std::shared_ptr<const Recording> recording) {
  // A recording of x alone says nothing about the way from u to y.
  if (!recording->has(Column::y)) return;
  static_cast<void>(valve_worker_.start(
      "identify", [this, recording = std::move(recording)](const Worker::Report& report,
                                                           const std::stop_token&) {
        const auto tell = [&report](int window, int of) { report("", window, of); };
        if (takes_long(*recording)) {
          auto first =
              std::make_shared<const ValveAnswer>(first_answer(*recording, tell));
          report("", 0, 0);
          const std::lock_guard lock(mutex_);
          view_.valve_so_far = std::move(first);
        }
        auto answer = std::make_shared<const ValveAnswer>(valve_answer(*recording, tell));
        report("", 0, 0);
        const std::lock_guard lock(mutex_);
        view_.valve = std::move(answer);
        view_.valve_so_far.reset();
      }));
}

void Session::open(Recording recording, Column output, std::string source,
                   std::shared_ptr<const CsvOptions> reading, std::uint64_t turn) {
  const auto shared = std::make_shared<const Recording>(std::move(recording));
  check(*shared, output);
  SessionView next;
  next.recording = shared;
  next.source = std::move(source);
  next.reading = std::move(reading);
  const std::lock_guard opening(opening_);
  show_new(std::move(next), turn);
  fit(shared, output, {});
}

void Session::judge(Recording recording, std::string source,
                    std::shared_ptr<const CsvOptions> reading, std::uint64_t turn) {
  const auto shared = std::make_shared<const Recording>(std::move(recording));
  SessionView next;
  next.steps.push_back(shared_step(*shared, view().last().model));
  next.recording = shared;
  next.source = std::move(source);
  next.reading = std::move(reading);
  const std::lock_guard opening(opening_);
  show_new(std::move(next), turn);
}

void Session::restore(Recording recording, std::string source, std::vector<Model> steps,
                      std::vector<Model> undone, std::vector<BesideRecording> beside,
                      std::uint64_t turn) {
  SessionView next;
  const auto own = std::make_shared<const Recording>(std::move(recording));
  next.recording = together(own, beside);
  if (next.recording != own) next.own = own;
  next.source = std::move(source);
  const auto judged = [&next](Model& model) {
    return shared_step(*next.recording, std::move(model));
  };
  for (Model& model : steps) next.steps.push_back(judged(model));
  for (Model& model : undone) next.undone.push_back(judged(model));
  next.beside = std::move(beside);
  const std::lock_guard opening(opening_);
  show_new(std::move(next), turn);
}

void Session::say_maker(std::string command) {
  const std::lock_guard lock(mutex_);
  static_cast<void>(view_.opened());
  view_.maker = std::move(command);
}

void Session::say_opens(Opens opens) {
  const std::lock_guard lock(mutex_);
  static_cast<void>(view_.opened());
  const bool stopped = view_.is_stopped();
  view_.opens = opens;
  ++view_.revision;
  ++view_.drawn;
  if (stopped) view_.stopped_at = view_.revision;
}

void Session::take(Model model) {
  const SessionView before = view();
  auto step = shared_step(before.opened(), std::move(model));
  worker_.cancel();
  push(std::move(step));
}

void Session::start(Column output, std::vector<std::string> with) {
  check_effects(with, nullptr);
  const SessionView before = view();
  check(before.opened(), output);
  fit(before.recording, output, std::move(with));
}

void Session::explain(Asked asked) {
  const SessionView before = view();
  static_cast<void>(before.last());
  begin(
      "explain",
      [this, before](const Worker::Report& report, const std::stop_token& stop) {
        const Work search({.threads = Work::cores(), .stop = stop});
        ModelStep step = before.last();
        step.explanation = workbench::explain(*before.recording, step.model, report,
                                              standard_catalogue(), search);
        report("", 0, 0);
        const std::lock_guard lock(mutex_);
        ++view_.revision;
        view_.steps.back() = std::make_shared<const ModelStep>(std::move(step));
      },
      asked);
}

void Session::refit(Model model, HeldNames held) {
  const SessionView before = view();
  static_cast<void>(before.last());
  begin_step("refit", [before, model = std::move(model), held = std::move(held)](
                          const Worker::Report&, const Work& search) {
    const Recording& recording = *before.recording;
    return shared_step(recording,
                       by_hand(recording, before.last().model,
                               refitted(recording, model, held, search), kFittedByHand));
  });
}

void Session::preview(std::vector<std::string> effects) {
  const SessionView before = view();
  check_effects(effects, &before.last().model);
  begin("preview", [this, before, effects = std::move(effects)](
                       const Worker::Report& report, const std::stop_token& stop) {
    const Work search({.threads = Work::cores(), .stop = stop});
    auto step = shared_step(
        *before.recording,
        with_effects(*before.recording, before.last().model, effects, report, search));
    report("", 0, 0);
    const std::lock_guard lock(mutex_);
    ++view_.revision;
    view_.preview = std::make_shared<const Preview>(Preview{effects, step});
  });
}

void Session::add(std::vector<std::string> effects) {
  const SessionView before = view();
  check_effects(effects, &before.last().model);
  if (before.preview != nullptr && before.preview->effects == effects) {
    if (worker_.progress()) throw NotNow("work is under way; wait until it is done");
    return push(before.preview->step);
  }
  begin_step("add", [before, effects = std::move(effects)](const Worker::Report& report,
                                                           const Work& search) {
    return shared_step(
        *before.recording,
        with_effects(*before.recording, before.last().model, effects, report, search));
  });
}

void Session::remove(std::string effect) {
  const SessionView before = view();
  if (!before.last().model.has(effect)) {
    throw std::invalid_argument("the model has no " + effect);
  }
  begin_step("remove", [before, effect = std::move(effect)](const Worker::Report& report,
                                                            const Work& search) {
    report(effect, 0, 0);
    const Recording& recording = *before.recording;
    return shared_step(recording, remove_effect(recording, before.last().model, effect,
                                                standard_catalogue(), search)
                                      .model);
  });
}

void Session::climb() {
  const SessionView before = view();
  const Column output = before.last().model.output;
  begin("ladder", [this, before, output](const Worker::Report& report,
                                         const std::stop_token& stop) {
    const Work search({.threads = Work::cores(), .stop = stop});
    LadderOptions options;
    options.output = output;
    options.progress = report;
    options.work = &search;
    std::optional<ModelStep> last;
    options.stepped = [&](const Model& model, const ExplainResult& found) {
      ModelStep step = step_of(*before.recording, model);
      report("", 0, 0);
      if (last) {
        last->explanation = found;
        push(std::make_shared<const ModelStep>(std::move(*last)), true);
      }
      push(std::make_shared<const ModelStep>(step));
      last = std::move(step);
    };
    LadderResult result = run_ladder(*before.recording, options);
    ModelStep step = step_of(*before.recording, result.model);
    if (speaks_of(result.last, step.model)) step.explanation = result.last;
    step.ladder = std::move(result);
    report("", 0, 0);
    const bool there = last && last->model.effect_codes() == step.model.effect_codes();
    push(std::make_shared<const ModelStep>(std::move(step)), there);
  });
}

void Session::undo() {
  worker_.cancel();
  const SessionView before = view();
  if (before.steps.size() < 2 && before.chosen_from != nullptr) {
    SessionView back = *before.chosen_from;
    back.preview.reset();
    return replace(std::move(back));
  }
  const std::lock_guard lock(mutex_);
  if (view_.steps.size() < 2) throw NotNow("there is no model before this one");
  ++view_.revision;
  ++view_.drawn;
  view_.preview.reset();
  view_.undone.push_back(view_.steps.back());
  view_.steps.pop_back();
}

void Session::redo() {
  if (worker_.progress()) throw NotNow("work is under way; wait until it is done");
  const std::lock_guard lock(mutex_);
  if (view_.undone.empty()) throw NotNow("nothing was undone that could come back");
  ++view_.revision;
  ++view_.drawn;
  view_.preview.reset();
  view_.steps.push_back(view_.undone.back());
  view_.undone.pop_back();
}

}  // namespace workbench
