#include "workbench/serve/session.hpp"

#include <algorithm>
#include <utility>

#include "workbench/analysis/longest_part.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit.hpp"
#include "workbench/model/intervals.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

// Throws where no model of `output` can be fitted to the recording.
void check(const Recording& recording, Column output) {
  const Fitter fitter(recording, output);
}

void check_effects(const std::vector<std::string>& effects, const Model* model) {
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const std::string& code = effects[i];
    if (standard_catalogue().find(code) == nullptr) {
      throw std::invalid_argument("no effect '" + code +
                                  "'; known effects: " + standard_catalogue().codes());
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

Recording samples_between(const Recording& whole, std::pair<double, double> range) {
  const auto at = [&whole](double t) {
    return static_cast<std::size_t>(std::lower_bound(whole.t.begin(), whole.t.end(), t) -
                                    whole.t.begin());
  };
  const std::size_t first = at(range.first);
  const std::size_t last = at(range.second);
  if (last < first + Blocks::kFewestSamples) {
    throw InputError(
        whole.name, 0, 0,
        "a range of at least " + std::to_string(Blocks::kFewestSamples) + " samples",
        std::to_string(last > first ? last - first : 0), "choose a longer one");
  }
  Recording out = cut_out(whole, {first, last - first, 0});
  out.name += ", " + number(out.t.front(), 4) + " to " + number(out.t.back(), 4) + " s";
  out.start.clear();
  return out;
}

ModelStep step_of(const Recording& recording, Model model) {
  Comparison comparison = compare(recording, model);
  const bool here = Fitter(recording, model.output).fitted_to_this(model);
  return {std::move(model), std::move(comparison), std::nullopt, std::nullopt, here};
}

}  // namespace

const Recording& SessionView::opened() const {
  if (recording == nullptr) throw NotNow("no recording is open; open one first");
  return *recording;
}

const ModelStep& SessionView::last() const {
  static_cast<void>(opened());
  if (steps.empty()) throw NotNow("there is no model yet; wait until it is fitted");
  return *steps.back();
}

SessionView Session::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

void Session::replace(SessionView next) {
  worker_.cancel();
  valve_worker_.cancel();
  std::shared_ptr<const Recording> recording = next.recording;
  {
    const std::lock_guard lock(mutex_);
    next.revision = view_.revision + 1;
    next.drawn = view_.drawn + 1;
    next.opened_count = view_.opened_count + 1;
    view_ = std::move(next);
  }
  identify(std::move(recording));
}

void Session::push(ModelStep step) {
  auto shared = std::make_shared<const ModelStep>(std::move(step));
  const std::lock_guard lock(mutex_);
  ++view_.revision;
  ++view_.drawn;
  view_.steps.push_back(std::move(shared));
  view_.undone.clear();
}

void Session::begin(std::string task, Worker::Task work) {
  if (!worker_.start(std::move(task), std::move(work))) {
    throw NotNow("work is under way; wait until it is done, or cancel it");
  }
}

void Session::fit(std::shared_ptr<const Recording> recording, Column output,
                  std::vector<std::string> with) {
  begin("model", [this, recording = std::move(recording), output, with = std::move(with)](
                     const Worker::Report& report, const std::stop_token& stop) {
    const Work search({.threads = Work::cores(), .stop = stop});
    ModelStep step = step_of(
        *recording,
        start_model(*recording, output, with, standard_catalogue(), search).model);
    report("", 0, 0);
    push(std::move(step));
  });
}

void Session::identify(std::shared_ptr<const Recording> recording) {
  // A recording of x alone says nothing about the way from u to y.
  if (!recording->has(Column::y)) return;
  static_cast<void>(valve_worker_.start(
      "identify", [this, recording = std::move(recording)](const Worker::Report& report,
                                                           const std::stop_token&) {
        auto answer = std::make_shared<const ValveAnswer>(valve_answer(
            *recording, [&report](int window, int of) { report("", window, of); }));
        report("", 0, 0);
        const std::lock_guard lock(mutex_);
        view_.valve = std::move(answer);
      }));
}

void Session::open(Recording recording, Column output, std::string source) {
  const auto shared = std::make_shared<const Recording>(std::move(recording));
  check(*shared, output);
  SessionView next;
  next.recording = shared;
  next.source = std::move(source);
  replace(std::move(next));
  fit(shared, output, {});
}

void Session::judge(Recording recording, std::string source) {
  const auto shared = std::make_shared<const Recording>(std::move(recording));
  SessionView next;
  next.steps.push_back(
      std::make_shared<const ModelStep>(step_of(*shared, view().last().model)));
  next.recording = shared;
  next.source = std::move(source);
  replace(std::move(next));
}

void Session::choose(std::optional<std::pair<double, double>> range, Purpose purpose) {
  const SessionView before = view();
  static_cast<void>(before.opened());
  const auto whole = before.whole != nullptr ? before.whole : before.recording;
  SessionView next;
  next.recording = whole;
  next.source = before.source;
  if (range) {
    next.recording = std::make_shared<const Recording>(samples_between(*whole, *range));
    next.whole = whole;
  }
  if (purpose == Purpose::kJudge) {
    next.steps.push_back(
        std::make_shared<const ModelStep>(step_of(*next.recording, before.last().model)));
    replace(std::move(next));
    return;
  }
  const Column output = before.steps.empty() ? Column::y : before.last().model.output;
  const std::shared_ptr<const Recording> shared = next.recording;
  check(*shared, output);
  replace(std::move(next));
  fit(shared, output, {});
}

void Session::restore(Recording recording, std::string source, std::vector<Model> steps,
                      std::vector<Model> undone) {
  SessionView next;
  next.recording = std::make_shared<const Recording>(std::move(recording));
  next.source = std::move(source);
  const auto judged = [&next](Model& model) {
    return std::make_shared<const ModelStep>(step_of(*next.recording, std::move(model)));
  };
  for (Model& model : steps) next.steps.push_back(judged(model));
  for (Model& model : undone) next.undone.push_back(judged(model));
  replace(std::move(next));
}

void Session::take(Model model) {
  const SessionView before = view();
  ModelStep step = step_of(before.opened(), std::move(model));
  if (worker_.progress()) throw NotNow("work is under way; wait until it is done");
  push(std::move(step));
}

void Session::start(Column output, std::vector<std::string> with) {
  check_effects(with, nullptr);
  const SessionView before = view();
  check(before.opened(), output);
  fit(before.recording, output, std::move(with));
}

void Session::explain() {
  const SessionView before = view();
  static_cast<void>(before.last());
  begin("explain",
        [this, before](const Worker::Report& report, const std::stop_token& stop) {
          const Work search({.threads = Work::cores(), .stop = stop});
          ModelStep step = before.last();
          step.explanation = workbench::explain(*before.recording, step.model, report,
                                                standard_catalogue(), search);
          report("", 0, 0);
          const std::lock_guard lock(mutex_);
          ++view_.revision;
          view_.steps.back() = std::make_shared<const ModelStep>(std::move(step));
        });
}

void Session::refit(Model model) {
  const SessionView before = view();
  static_cast<void>(before.last());
  begin("refit", [this, before, model = std::move(model)](const Worker::Report& report,
                                                          const std::stop_token& stop) {
    const Work search({.threads = Work::cores(), .stop = stop});
    const Fitter fitter(*before.recording, model.output, search);
    const Fit start = fitter.apply(model, standard_catalogue());
    Model fitted = model_of(fitter, fitter.refine(start));
    fitted.history = model.history;
    ModelStep step = step_of(*before.recording, std::move(fitted));
    report("", 0, 0);
    push(std::move(step));
  });
}

void Session::add(std::vector<std::string> effects) {
  const SessionView before = view();
  check_effects(effects, &before.last().model);
  begin("add", [this, before, effects = std::move(effects)](const Worker::Report& report,
                                                            const std::stop_token& stop) {
    const Work search({.threads = Work::cores(), .stop = stop});
    Model model = before.last().model;
    int number = 0;
    for (const std::string& effect : effects) {
      report(effect, ++number, static_cast<int>(effects.size()));
      model = add_effect(*before.recording, model, effect, standard_catalogue(), search)
                  .model;
    }
    ModelStep step = step_of(*before.recording, std::move(model));
    report("", 0, 0);
    push(std::move(step));
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
    LadderResult result = run_ladder(*before.recording, options);
    ModelStep step = step_of(*before.recording, result.model);
    step.explanation = result.last;
    step.ladder = std::move(result);
    report("", 0, 0);
    push(std::move(step));
  });
}

void Session::undo() {
  worker_.cancel();
  const std::lock_guard lock(mutex_);
  if (view_.steps.size() < 2) throw NotNow("there is no model before this one");
  ++view_.revision;
  ++view_.drawn;
  view_.undone.push_back(view_.steps.back());
  view_.steps.pop_back();
}

void Session::redo() {
  if (worker_.progress()) throw NotNow("work is under way; wait until it is done");
  const std::lock_guard lock(mutex_);
  if (view_.undone.empty()) throw NotNow("nothing was undone that could come back");
  ++view_.revision;
  ++view_.drawn;
  view_.steps.push_back(view_.undone.back());
  view_.undone.pop_back();
}

}  // namespace workbench
