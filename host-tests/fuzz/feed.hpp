// What the fuzzers and the mutation runner do with one input: read it, and hold the
// readers to their promise: a recording that keeps its invariants, or InputError.
// Anything else (another exception, a broken invariant) ends the process.
#pragma once

#include <string_view>

namespace fuzz {

enum class Outcome { kRecording, kRefused };

/// A CSV file. Read four times: with a time column, with a given period, and with one
/// required column each.
Outcome feed_csv(std::string_view text);

/// A DBC file followed by a candump log, which starts at the first line with '('.
Outcome feed_candump(std::string_view text);

/// A DBC file alone: every signal that can be found is inserted and extracted.
Outcome feed_dbc(std::string_view text);

}  // namespace fuzz
