// A session as a file: the recording, its models so far, what was undone.
#pragma once

#include <string>
#include <vector>

#include "workbench/model/base/model.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/serve/session.hpp"

namespace workbench {

/// What a session file holds.
struct SavedSession {
  Recording recording;
  std::string source;         ///< words of a command line
  std::vector<Model> steps;   ///< at least one; the last is the present one
  std::vector<Model> undone;  ///< as SessionView
  std::vector<BesideRecording> beside;
  Opens opens = Opens::unknown;
};

/// JSON: {"schema","kind":"stickband-session","recording","source","opens","steps",
/// "undone","beside"}, models as in a model file; a recording of "beside" has its
/// "source", one that is fitted "fitted": true. Throws NotNow without a recording or
/// model.
[[nodiscard]] std::string session_text(const SessionView& view);

/// Reads it. Throws InputError naming `name`, what was expected, what was found and what
/// to do, for text that is no session, another version, signals of different lengths or
/// with times that do not rise, numbers that are none, and as parse_model().
[[nodiscard]] SavedSession parse_session(const std::string& text,
                                         const std::string& name);

}  // namespace workbench
