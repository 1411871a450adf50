#include "workbench/cli/candidates_text.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/cli/console.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/parameter_table.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/model/tell/curve_of.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/named_signal.hpp"
#include "workbench/recording/option_words.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

constexpr std::size_t kIndent = 13;
constexpr double kHardlyAnyPercent = 0.1;  // of the squared error

std::string name_of_set(const Candidate& c) {
  std::string name = c.effect;
  for (const std::string& other : c.with) name += " with " + other;
  return name;
}

std::string told_of(const Candidate& c) {
  std::string told = c.evidence;
  if (c.status == CandidateStatus::kAccepted && !c.ahead) {
    told += " Validation error " + number(c.rmse_validation_before, 4) + " to " +
            number(c.rmse_validation_after, 4) +
            (c.error_reduction_percent >= kHardlyAnyPercent
                 ? ", which takes away " + number(c.error_reduction_percent, 3) +
                       " % of the squared error."
                 : ": the readings show it, not the error.");
  }
  if (c.indistinguishable_from.empty()) return told;
  told += c.with.empty()
              ? " This recording cannot tell it from " +
                    listed(c.indistinguishable_from) + "."
              : " One of them may as well be " + listed(c.indistinguishable_from) +
                    ": this recording cannot tell.";
  if (c.would_split) {
    told += " What would: " + *c.would_split + (c.would_split->ends_with('?') ? "" : ".");
  }
  return told;
}

std::string table_of(const EffectTerm& term) {
  return parameter_table(told_parameters(term), kIndent) + notes_on(term, kIndent);
}

// The other names of what is accepted: the same errors by the same first value.
bool is_same_thing(const Candidate& other, const Candidate& c) {
  constexpr double kSame = 1e-3;
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= kSame * std::abs(b);
  };
  return c.status == CandidateStatus::kAccepted && other.status == c.status &&
         c.with.empty() && other.with.empty() && !c.parameters.empty() &&
         c.parameters.size() == other.parameters.size() &&
         std::ranges::find(c.indistinguishable_from, other.effect) !=
             c.indistinguishable_from.end() &&
         same(other.rmse_validation_after, c.rmse_validation_after) &&
         same(other.parameters[0].value, c.parameters[0].value) &&
         other.parameters[0].unit == c.parameters[0].unit;
}

bool turned_down(const Candidate& c) {
  return c.status == CandidateStatus::kRejected ||
         c.status == CandidateStatus::kNotExcited;
}

}  // namespace

std::string titles_of(const Candidate& candidate) {
  return listed(members_of(candidate), ", and with it ", [](const std::string& code) {
    return standard_catalogue().find(code)->description().title;
  });
}

std::string missing_in_words(const Candidate& best) {
  constexpr std::size_t kFew = 3;
  const std::string what = "What is missing: " + titles_of(best);
  const std::vector<std::string>& rivals = best.indistinguishable_from;
  if (rivals.empty()) return what + '.';
  if (rivals.size() > kFew) {
    return what + ", or one of " + std::to_string(rivals.size()) +
           " other effects that this recording cannot tell from it; they are named "
           "below.";
  }
  return what + (best.with.empty() ? ", or in its place " : ", or in place of one ") +
         listed(rivals, " or ",
                [](const std::string& code) {
                  return standard_catalogue().find(code)->description().title;
                }) +
         ": this recording cannot tell.";
}

std::string search_on(const SearchSoFar& so_far, const std::vector<std::string>& more) {
  std::vector<std::string> all = so_far.in_model;
  for (const std::string& code : more) {
    if (std::ranges::find(all, code) == all.end()) all.push_back(code);
  }
  const std::vector<std::string>& before = so_far.begun_with;
  const bool is_new = std::ranges::any_of(all, [&before](const std::string& code) {
    return std::ranges::find(before, code) == before.end();
  });
  if (!is_new) return {};
  return so_far.ladder + " --with " + shell_word(listed(all, ",")) +
         (so_far.keep.empty() ? "" : " -o " + file_word(so_far.keep));
}

std::string what_comes_closest(const std::string& before, const ExplainResult& result,
                               const SearchSoFar& so_far) {
  const Candidate* doubt = result.closest();
  if (doubt == nullptr) {
    const char* const columns = so_far.has_further_columns
                                    ? " Further columns of the recording can be tried as "
                                      "loads: --load COLUMN, or "
                                      "--load all."
                                    : "";
    return wrapped(
        before +
            " No effect comes close: what is left is slow noise, a load that was not "
            "recorded, or what the catalogue lacks." +
            columns,
        0);
  }
  const std::string closest =
      before + " Closest comes " + titles_of(*doubt) + ", not beyond doubt";
  const std::string command = search_on(so_far, members_of(*doubt));
  if (command.empty()) return wrapped(closest + "; this search began with it.", 0);
  return wrapped(closest + ". To see what it does:", 0) + "\n  " + command;
}

std::string candidates_text(std::span<const Candidate> candidates) {
  std::vector<bool> said(candidates.size(), false);
  std::string text;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (said[i]) continue;
    const Candidate& c = candidates[i];
    const std::string told = told_of(c);
    std::string names = name_of_set(c);
    for (std::size_t k = i + 1; k < candidates.size(); ++k) {
      const Candidate& other = candidates[k];
      const bool also = turned_down(c) && other.status == c.status && !said[k] &&
                        told_of(other) == told;
      const bool same = is_same_thing(other, c);
      if (!also && !same) continue;
      names += (same ? " or " : ", ") + name_of_set(other);
      said[k] = true;
    }
    text += padded(std::string(name_of(c.status)), kIndent) + wrapped(names, kIndent) +
            '\n' + std::string(kIndent, ' ') + wrapped(told, kIndent) + '\n';
    if (c.status == CandidateStatus::kAccepted) {
      text += table_of({c.effect, c.parameters, c.phenomenological, c.untold});
      for (const EffectTerm& partner : c.partners) {
        text += std::string(kIndent, ' ') + partner.effect + '\n' + table_of(partner);
      }
    }
  }
  return text;
}

}  // namespace workbench::cli
