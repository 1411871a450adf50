// Session: which samples of which recordings are fitted, judged and left out.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "workbench/analysis/longest_part.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/serve/session.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

SampleRange samples_at(const Recording& recording, std::pair<double, double> range) {
  const auto at = [&recording](double t) {
    return static_cast<std::size_t>(std::ranges::lower_bound(recording.t, t) -
                                    recording.t.begin());
  };
  return {at(range.first), at(range.second)};
}

Recording samples_between(const Recording& whole, std::pair<double, double> range) {
  const auto [first, last] = samples_at(whole, range);
  if (last < first + Blocks::kFewestSamples) {
    throw InputError(
        whole.name, 0, 0,
        "a range of at least " + std::to_string(Blocks::kFewestSamples) + " samples",
        std::to_string(last > first ? last - first : 0), "choose a longer one");
  }
  Recording out = cut_out(whole, {first, last - first, 0});
  out.name += ", " + instant(out.t.front(), out.period_s) + " to " +
              instant(out.t.back(), out.period_s) + " s";
  out.start.clear();
  return out;
}

void leave_out_of(Recording& recording, SampleRange range) {
  if (range.first < range.last) {
    recording.left_out = united(std::move(recording.left_out), {range});
  }
}

// A view with the recordings of `before`, each changed.
template <class Change>
SessionView changed(const SessionView& before, Change change) {
  const auto copy = [&](const std::shared_ptr<const Recording>& recording) {
    if (recording == nullptr) return recording;
    Recording out = *recording;
    change(out);
    return std::make_shared<const Recording>(std::move(out));
  };
  static_cast<void>(before.opened());
  SessionView next;
  next.recording = copy(before.recording);
  next.whole = copy(before.whole);
  next.own = copy(before.own);
  return next;
}

}  // namespace

void Session::take_up(SessionView next, Purpose purpose) {
  const SessionView before = view();
  next.source = before.source;
  next.opening = before.opening;
  next.reading = before.reading;
  next.maker = before.maker;
  next.beside = before.beside;
  if (!before.steps.empty()) {
    next.chosen_from = std::make_shared<const SessionView>(before);
  }
  const std::shared_ptr<const Recording> shared = next.recording;
  if (purpose == Purpose::kJudge) {
    next.steps.push_back(shared_step(*shared, before.last().model));
    return replace(std::move(next));
  }
  const Column output = before.output();
  check(*shared, output);
  replace(std::move(next));
  fit(shared, output, {});
}

namespace {

constexpr const char* kTogether = "together";

// A range is one of a single recording.
void refuse_several(const SessionView& view) {
  if (view.own != nullptr) {
    throw NotNow(
        "several recordings are fitted together; fit the one that is open alone first");
  }
}

}  // namespace

void Session::choose(std::optional<std::pair<double, double>> range, Purpose purpose) {
  const SessionView before = view();
  static_cast<void>(before.opened());
  refuse_several(before);
  SessionView next;
  next.recording = before.whole != nullptr ? before.whole : before.recording;
  if (range) {
    next.whole = next.recording;
    next.recording =
        std::make_shared<const Recording>(samples_between(*next.whole, *range));
  }
  take_up(std::move(next), purpose);
}

void Session::leave_out(std::optional<std::pair<double, double>> range) {
  const SessionView before = view();
  refuse_several(before);
  take_up(changed(before,
                  [&range](Recording& recording) {
                    if (range) {
                      leave_out_of(recording, samples_at(recording, *range));
                    } else {
                      recording.left_out.clear();
                    }
                  }),
          Purpose::kFit);
}

void Session::leave_out_manual() {
  const SessionView before = view();
  refuse_several(before);
  if (before.opened().manual.empty()) {
    throw NotNow("no stretch of this recording is said to be in manual");
  }
  take_up(changed(before,
                  [](Recording& recording) {
                    for (const SampleRange& range : recording.manual) {
                      leave_out_of(recording, range);
                    }
                  }),
          Purpose::kFit);
}

void Session::share_out(Split split) {
  if (!(split.estimation_share >= 0.2 && split.estimation_share <= 0.9)) {
    throw std::invalid_argument("expected a share of 0.2 to 0.9 that is fitted");
  }
  if (!(split.pair_samples >= 0)) {
    throw std::invalid_argument("expected a length of the blocks of 0 or more");
  }
  const SessionView before = view();
  SessionView next =
      changed(before, [&split](Recording& recording) { recording.split = split; });
  next.valve = before.valve;  // it looks at all samples, whatever their share
  take_up(std::move(next), Purpose::kFit);
}

void Session::accompany(Recording recording, std::string source) {
  refuse_while_together();
  const SessionView before = view();
  check(recording, before.output());
  const std::lock_guard lock(mutex_);
  static_cast<void>(view_.opened());
  if (view_.beside.size() >= kMostBeside) {
    throw NotNow("there are " + std::to_string(kMostBeside) +
                 " recordings beside this one already; close one first");
  }
  ++view_.revision;
  view_.beside.push_back({std::make_shared<const Recording>(std::move(recording)), false,
                          std::move(source)});
}

// That work ends with the recordings that it began with.
void Session::refuse_while_together() const {
  const auto now = worker_.progress();
  if (now && now->task == kTogether) {
    throw NotNow("recordings are being fitted together; wait until it is done");
  }
}

void Session::regroup(std::vector<BesideRecording> beside) {
  worker_.cancel();
  SessionView next = view();
  const Model model = next.last().model;
  const auto own = next.own != nullptr ? next.own : next.recording;
  next.recording = together(own, beside);
  next.own = next.recording != own ? own : nullptr;
  next.beside = std::move(beside);
  next.valve.reset();
  next.valve_so_far.reset();
  next.preview.reset();
  next.undone.clear();
  check(*next.recording, model.output);
  begin(kTogether, [this, next = std::move(next), model](const Worker::Report& report,
                                                         const std::stop_token& stop) {
    const Work search({.threads = Work::cores(), .stop = stop});
    SessionView done = next;
    for (auto& step : done.steps) step = shared_step(*done.recording, step->model);
    done.steps.push_back(
        shared_step(*done.recording, fitted_anew(*done.recording, model, search)));
    report("", 0, 0);
    valve_worker_.cancel();
    install(std::move(done));
  });
}

void Session::fit_together(std::size_t which, bool fitted) {
  std::vector<BesideRecording> beside = view().beside;
  if (which >= beside.size()) {
    throw NotNow("no recording " + std::to_string(which) + " lies beside this one");
  }
  if (beside[which].fitted == fitted) return;
  beside[which].fitted = fitted;
  regroup(std::move(beside));
}

void Session::dismiss(std::size_t which) {
  refuse_while_together();
  std::vector<BesideRecording> beside = view().beside;
  if (which < beside.size() && beside[which].fitted) {
    beside.erase(beside.begin() + static_cast<std::ptrdiff_t>(which));
    return regroup(std::move(beside));
  }
  const std::lock_guard lock(mutex_);
  if (which >= view_.beside.size()) {
    throw NotNow("no recording " + std::to_string(which) + " lies beside this one");
  }
  ++view_.revision;
  view_.beside.erase(view_.beside.begin() + static_cast<std::ptrdiff_t>(which));
}

}  // namespace workbench
