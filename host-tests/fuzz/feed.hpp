// What the fuzzers and the mutation runner do with one input: read it, and hold the
// readers to their promise: a recording that keeps its invariants, or InputError;
// the diagnostic server to its own.
// Anything else (another exception, a broken invariant) ends the process.
#pragma once

#include <string_view>

#include "workbench/recording/recording.hpp"

namespace fuzz {

enum class Outcome { kAccepted, kRefused };

/// What else is done with a recording that was read.
using Examine = void (*)(const workbench::Recording&);
/// Identifies one of sixteen, chosen by its content; links the whole workbench.
void survive_identification(const workbench::Recording& recording);

/// A CSV file. Read five times: with a time column, with a given period, with one
/// required column each, and with all loads.
Outcome feed_csv(std::string_view text, Examine examine = nullptr);

/// A DBC file followed by a candump log, which starts at the first line with '('.
Outcome feed_candump(std::string_view text, Examine examine = nullptr);

/// Frames off a bus: eight bytes lay out a signal, the rest are lines of candump or
/// slcan. Every frame that can be read is written and read again, and its signal
/// extracted.
Outcome feed_frames(std::string_view bytes);

/// Requests to the UDS server: first byte the settings, then for each request a control
/// byte (pause, functional, unwilling daemon, right key, little room), its length and its
/// bytes. Nothing may be written without the key, and silence ends everything.
Outcome feed_uds(std::string_view bytes);

/// Frames to the diagnostic connection: first byte the settings, then for each frame a
/// control byte (pause, identifier, without polling, bus lost), its shape and its data.
Outcome feed_isotp(std::string_view bytes);

/// A DBC file alone: every signal that can be found is inserted and extracted.
Outcome feed_dbc(std::string_view text);

/// A configuration of the gateway.
Outcome feed_toml(std::string_view text);

}  // namespace fuzz
