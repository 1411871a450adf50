// Recordings from CAN: a candump log and the DBC file that explains it.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "wire/signal.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Which signals make which column, each as MESSAGE.SIGNAL; empty = column absent.
struct CandumpOptions {
  std::string u;
  std::string y;
  std::string sp;
  std::string x;
  std::optional<double> period_s;  ///< of the result, s; > 0 and finite
  std::stop_token stop = {};       ///< asks for an end: Stopped is thrown
};

/// A column and the signal it comes from.
struct CandumpSignal {
  Column column = Column::u;
  std::string title;  ///< for messages, e.g. MESSAGE.SIGNAL
  wire::FrameSignal signal;
  std::string interface = {};  ///< empty: any; else its lines, where the log has some
};

/// Reads the log `path` (`candump -l` or `-L`) with the DBC file `dbc_path`.
///
/// Signals arrive in different frames at different rates, so every column is sampled
/// by zero-order hold at common instants. Their period is `period_s`; else the slower
/// of the median intervals of u and y when both arrive cyclically (nine intervals in
/// ten within 10 % of a multiple of the median); else the median interval of y (of x or
/// u when there is no y). The instants keep as far as possible from the usual arrival
/// of the frames, so that jitter never decides whether a value belongs to this instant
/// or the next; `t` is the nominal time of the y frame the instant belongs to, in
/// seconds since the first line of the log. The recording starts when every column has
/// a value and ends when y, or a cyclic u or x, falls silent. Instants that a cyclic
/// signal should have refreshed and did not are counted as missing.
///
/// Frames that are too short, CAN XL lines, values outside [minimum|maximum] of the DBC
/// that J1939 reserves or that are out by half the width of the limits are left out,
/// counted and noted, as the gateway does; nearer ones are kept, and noted: limits that
/// cut off a swing are wrong, and without its ends it is another one. Left out is the
/// highest raw number, too, "not available", where a signal without limits has it seldom
/// and farther out than all its other values are apart. Multiplexed signals are read only
/// from the frames that select them. Where u or y is silent for so long that the value
/// before says nothing of what happened (long_gaps.hpp), the recording has a gap.
///
/// Throws InputError for: a malformed line; a DBC error; a signal the DBC file does not
/// define; no frame with the identifier (the message lists those seen); a signal on two
/// interfaces, or from two senders where the identifier leaves them open; more than half
/// of the values outside the limits; a step back in time; NaN or an infinity in a float
/// signal; fewer than two samples; gaps or files too long. Throws std::invalid_argument
/// when no signal is named
/// or `period_s` is not positive.
[[nodiscard]] Recording read_candump(const std::string& path, const std::string& dbc_path,
                                     const CandumpOptions& options);

/// The same with signals that are known, e.g. from the gateway's configuration.
[[nodiscard]] Recording read_candump(const std::string& path,
                                     const std::vector<CandumpSignal>& signals,
                                     std::optional<double> period_s,
                                     const std::stop_token& stop = {});

/// The same for texts already in memory; the names stand in messages.
[[nodiscard]] Recording parse_candump_log(std::string_view log,
                                          const std::string& log_name,
                                          std::string_view dbc,
                                          const std::string& dbc_name,
                                          const CandumpOptions& options);

/// "--dbc needs --u MESSAGE.SIGNAL and --y MESSAGE.SIGNAL: plant.dbc has the signals …",
/// with the options to add where names tell which signals are meant; the first half alone
/// for a file that cannot be read. `missing`: not empty.
[[nodiscard]] std::string missing_dbc_signals(const std::string& dbc_path,
                                              const std::vector<Column>& missing);

}  // namespace workbench
