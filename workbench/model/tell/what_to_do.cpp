#include "workbench/model/tell/what_to_do.hpp"

#include "workbench/effects/catalogue.hpp"
#include "workbench/recording/filled.hpp"

namespace workbench {
namespace {

std::string how_to_tell(const Candidate& best) {
  std::string out;
  if (best.would_split) {
    const bool asks = best.would_split->ends_with('?');
    out = filled(asks ? "First find out which it is: {0}"
                      : "First find out which it is: {0}.",
                 {*best.would_split}) +
          ' ';
  }
  const Effect* effect = standard_catalogue().find(best.effect);
  // Of several together the rival is one of some member only.
  if (!best.with.empty() || effect == nullptr) {
    return out + "The following is for the effects that are named first.";
  }
  return out +
         filled("The following is for {0}.", {std::string(effect->description().title)});
}

}  // namespace

std::vector<std::string> what_to_do(const Candidate& best, bool valve_in_doubt) {
  std::vector<std::string> out;
  if (!best.indistinguishable_from.empty()) {
    out.push_back(how_to_tell(best));
  } else if (best.harmless && !valve_in_doubt) {
    out.emplace_back("Nothing is broken.");
  }
  for (const std::string& cure : best.cures) out.push_back(cure);
  return out;
}

}  // namespace workbench
