#include "workbench/cli/left_behind.hpp"

#include <algorithm>
#include <vector>

#include "workbench/cli/console.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit/free_run.hpp"
#include "workbench/recording/listed.hpp"

namespace workbench::cli {

std::string note_on_left_behind(const Model& model, const Recording& recording) {
  std::vector<std::string> judging;
  for (const Piece& piece : recording.pieces) {
    const bool is_known = std::ranges::count(judging, piece.recording) > 0;
    if (piece.judges && !is_known) judging.push_back(piece.recording);
  }
  const Catalogue catalogue = standard_catalogue().with(recording.loads);
  std::vector<std::string> left;
  for (const std::string& code : model.effect_codes()) {
    const Effect* effect = catalogue.find(code);
    if (effect != nullptr && stays_behind(*effect)) left.push_back(code);
  }
  if (judging.empty() || left.empty()) return {};
  return listed(left) + (left.size() == 1 ? " belongs" : " belong") +
         " to what was fitted: " + listed(judging) + " is judged without " +
         (left.size() == 1 ? "it" : "them");
}

void complain_about_left_behind(const Model& model, const Recording& recording) {
  const std::string note = note_on_left_behind(model, recording);
  if (!note.empty()) complain(note);
}

}  // namespace workbench::cli
