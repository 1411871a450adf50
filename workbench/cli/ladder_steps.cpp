#include "workbench/cli/ladder_steps.hpp"

#include <set>

#include "workbench/cli/console.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

// A step, or an exchange with all its steps.
struct Row {
  std::vector<std::string> came;
  std::vector<std::string> gone;
  std::vector<std::string> rivals;  // whose it is stands before each where several came
  std::string begun_with;           // of the first row
  const LadderStep* last = nullptr;

  void take(const LadderStep& step) {
    (step.removed ? gone : came).push_back(step.effect);
    for (const std::string& other : step.indistinguishable_from) {
      rivals.push_back(step.effect + " or " + other);
    }
    last = &step;
  }
  [[nodiscard]] std::string name() const {
    if (came.empty()) return "without " + listed(gone);
    return listed(came) + (gone.empty() ? "" : " instead of " + listed(gone)) +
           (begun_with.empty() ? "" : " with " + begun_with);
  }
};

std::string row_text(const Row& row, double before) {
  constexpr std::size_t kNames = 32;
  const std::string name = row.name();
  std::string text = "  " +
                     (name.size() < kNames ? padded(name, kNames)
                                           : name + '\n' + std::string(2 + kNames, ' ')) +
                     padded(number(row.last->rmse, 4), 10) +
                     without_end_blanks(padded(number(row.last->rmse_validation, 4), 12) +
                                        fall(before, row.last->rmse_validation)) +
                     '\n';
  if (row.last->ahead) {
    text += "      the load hides it; one sample ahead " +
            number(row.last->ahead->before, 4) + " to " +
            number(row.last->ahead->after, 4) + ", " +
            fall(row.last->ahead->before, row.last->ahead->after) + '\n';
  }
  if (row.came.empty() && row.last->rmse_validation > before) {
    text += "      the simpler model: what it loses may be chance\n";
  }
  for (const std::string& rival : row.rivals) {
    const std::size_t own = row.came.size() == 1 ? row.came[0].size() + 1 : 0;
    text += "      " + rival.substr(own) + ": this recording cannot tell\n";
  }
  return text;
}

}  // namespace

std::string steps_text(const std::vector<LadderStep>& steps,
                       const std::vector<std::string>& begun_with) {
  std::string text;
  double before = 0;
  Row row;
  row.begun_with = listed(begun_with);
  std::set<std::string> seen;  // what came and went
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i + 1 < steps.size() && takes_back(steps[i + 1], steps[i])) {
      if (seen.insert(steps[i].effect).second) {
        text += "      " + steps[i].effect + " is seen, but takes no error away\n";
      }
      before = steps[++i].rmse_validation;
      continue;
    }
    row.take(steps[i]);
    if (steps[i].on_the_way) continue;
    text += row_text(row, before);
    before = steps[i].rmse_validation;
    row = {};
  }
  return text;
}

}  // namespace workbench::cli
