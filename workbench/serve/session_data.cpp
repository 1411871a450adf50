// Session: which samples of which recordings are fitted, judged and left out.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "workbench/analysis/longest_part.hpp"
#include "workbench/model/fit.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/serve/session.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

SampleRange samples_at(const Recording& recording, std::pair<double, double> range) {
  const auto at = [&recording](double t) {
    return static_cast<std::size_t>(
        std::lower_bound(recording.t.begin(), recording.t.end(), t) -
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
  out.name += ", " + number(out.t.front(), 4) + " to " + number(out.t.back(), 4) + " s";
  out.start.clear();
  return out;
}

// With the samples between two times added to those left out.
std::shared_ptr<const Recording> without(const Recording& recording,
                                         std::pair<double, double> range) {
  Recording out = recording;
  SampleRange added = samples_at(recording, range);
  std::vector<SampleRange> apart;
  for (const SampleRange& known : recording.left_out) {
    if (known.last < added.first || known.first > added.last) {
      apart.push_back(known);
    } else {
      added = {std::min(known.first, added.first), std::max(known.last, added.last)};
    }
  }
  if (added.first < added.last) apart.push_back(added);
  std::sort(apart.begin(), apart.end(),
            [](const SampleRange& a, const SampleRange& b) { return a.first < b.first; });
  out.left_out = std::move(apart);
  return std::make_shared<const Recording>(std::move(out));
}

}  // namespace

void Session::take_up(SessionView next, Purpose purpose) {
  const SessionView before = view();
  next.source = before.source;
  next.beside = before.beside;
  const std::shared_ptr<const Recording> shared = next.recording;
  if (purpose == Purpose::kJudge) {
    next.steps.push_back(shared_step(*shared, before.last().model));
    return replace(std::move(next));
  }
  const Column output = before.steps.empty() ? Column::y : before.last().model.output;
  check(*shared, output);
  replace(std::move(next));
  fit(shared, output, {});
}

void Session::choose(std::optional<std::pair<double, double>> range, Purpose purpose) {
  const SessionView before = view();
  static_cast<void>(before.opened());
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
  const auto changed = [&range](const Recording& recording) {
    if (range) return without(recording, *range);
    Recording out = recording;
    out.left_out.clear();
    return std::make_shared<const Recording>(std::move(out));
  };
  SessionView next;
  next.recording = changed(before.opened());
  if (before.whole != nullptr) next.whole = changed(*before.whole);
  take_up(std::move(next), Purpose::kFit);
}

void Session::share_out(Split split) {
  if (!(split.estimation_share >= 0.2 && split.estimation_share <= 0.9)) {
    throw std::invalid_argument("expected a share of 0.2 to 0.9 that is fitted");
  }
  if (!(split.pair_samples >= 0)) {
    throw std::invalid_argument("expected a length of the blocks of 0 or more");
  }
  const SessionView before = view();
  const auto changed = [&split](const Recording& recording) {
    Recording out = recording;
    out.split = split;
    return std::make_shared<const Recording>(std::move(out));
  };
  SessionView next;
  next.recording = changed(before.opened());
  if (before.whole != nullptr) next.whole = changed(*before.whole);
  next.valve = before.valve;  // it looks at all samples, whatever their share
  take_up(std::move(next), Purpose::kFit);
}

void Session::accompany(Recording recording) {
  const SessionView before = view();
  check(recording, before.steps.empty() ? Column::y : before.last().model.output);
  const std::lock_guard lock(mutex_);
  static_cast<void>(view_.opened());
  if (view_.beside.size() >= kMostBeside) {
    throw NotNow("there are " + std::to_string(kMostBeside) +
                 " recordings beside this one already; close one first");
  }
  ++view_.revision;
  view_.beside.push_back(std::make_shared<const Recording>(std::move(recording)));
}

void Session::dismiss(std::size_t which) {
  const std::lock_guard lock(mutex_);
  if (which >= view_.beside.size()) {
    throw NotNow("no recording " + std::to_string(which) + " lies beside this one");
  }
  ++view_.revision;
  view_.beside.erase(view_.beside.begin() + static_cast<std::ptrdiff_t>(which));
}

}  // namespace workbench
