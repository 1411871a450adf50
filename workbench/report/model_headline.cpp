#include "workbench/report/model_headline.hpp"

#include <vector>

#include "workbench/model/tell/cautions.hpp"
#include "workbench/model/tell/harm.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/report/texts.hpp"

namespace workbench {
namespace {

// The codes of the effects of the model, and what their addition speaks for.
struct ToldCodes {
  std::vector<std::string> found;
  std::vector<std::string> doubtful;
  std::vector<std::string> harmful;
};

ToldCodes told_of(const ModelReport& report) {
  ToldCodes out;
  for (const std::string& code : report.comparison.effects) {
    const HistoryStep* harm = harm_of(report.model, code);
    (harm == nullptr      ? out.found
     : is_in_doubt(*harm) ? out.doubtful
                          : out.harmful)
        .push_back(code);
  }
  return out;
}

}  // namespace

std::string model_headline(const ModelReport& report) {
  const Candidate* missing = report.explanation.best();
  if (missing != nullptr && is_beside_the_point(*missing)) {
    return capitalised(
        filled("The readings show {0}, but hardly any of the error is its doing.",
               {title_of(missing->effect)}));
  }
  if (missing != nullptr) {
    const std::string what = titled(members_of(*missing), " and ");
    return filled(missing->indistinguishable_from.empty()
                      ? "The model still lacks {0}."
                      : "The model still lacks {0}, or what this recording cannot tell "
                        "from it.",
                  {what});
  }
  if (report.explanation.left_to_controller) {
    return "Little but the controller moves u: what the process makes of it is not "
           "told.";
  }
  if (says_hardly_anything(report.comparison.quality.fit_percent)) {
    return "From u alone the model says hardly anything about the output.";
  }
  if (tells_nothing(report.model, report.comparison.quality)) {
    return "How far the output follows u, if at all, is not told.";
  }
  const auto [found, doubtful, harmful] = told_of(report);
  const std::string what = titled(found, " and ");
  if (!doubtful.empty() || !harmful.empty()) {
    std::vector<std::string> parts;
    if (!found.empty()) parts.push_back(filled("Found: {0}.", {what}));
    if (!doubtful.empty()) {
      parts.push_back(filled("In doubt: {0}.", {titled(doubtful, " and ")}));
    }
    if (!harmful.empty()) {
      parts.push_back(
          capitalised(filled("{0} made the error larger.", {titled(harmful, " and ")})));
    }
    return listed(parts, " ");
  }
  if (report.lacks_stem) {
    return "The verdict on the valve finds a stem that does not follow u, and the model "
           "has none.";
  }
  if (report.explanation.explained) {
    return found.empty() ? "The model is complete: nothing is missing."
                         : "The model is complete: explained by " + what + ".";
  }
  return found.empty() ? "Something is missing, but the data do not tell what."
                       : "Found: " + what + ". Something is left unexplained.";
}

}  // namespace workbench
