// What a DBC file has for a command that does not name its signals.
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// "--dbc needs --u MESSAGE.SIGNAL and --y MESSAGE.SIGNAL: plant.dbc has the signals …",
/// with the options to add where names tell which signals are meant; the first half alone
/// for a file that cannot be read. `missing`: not empty.
[[nodiscard]] std::string missing_dbc_signals(const std::string& dbc_path,
                                              const std::vector<Column>& missing);

}  // namespace workbench
