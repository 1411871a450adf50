// What --learn has found, for people (80 columns) and for programs.
#pragma once

#include <string>
#include <vector>

#include "firmware/learn/frame_survey.hpp"
#include "firmware/learn/loop_proposal.hpp"
#include "firmware/learn/seen_signal.hpp"

namespace firmware {

/// All of it; `source`: the bus or log that was listened to.
struct Learned {
  std::string source = {};
  std::string dbc = {};  ///< empty: signals are guesses
  FrameSurvey survey = {};
  std::vector<SeenSignal> signals = {};
  std::vector<LoopProposal> proposals = {};
  std::size_t cut_line = 0;  ///< of the log, its last where it was cut and left out
};

/// Tables, plots and a configuration to paste.
[[nodiscard]] std::string learned_text(const Learned& learned);
/// One object.
[[nodiscard]] std::string learned_json(const Learned& learned);
/// The configuration alone: buses and loops that are proposed; empty: none is.
[[nodiscard]] std::string learned_toml(const Learned& learned);

}  // namespace firmware
