#include "workbench/recording/dbc_signals.hpp"

#include <algorithm>
#include <optional>

#include "config/dbc_storage.hpp"
#include "wire/dbc.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/signal_suggestion.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

// Nothing where the file is not there or is no DBC file: what is wrong with the command
// comes first.
std::optional<std::vector<NamedSignal>> signals_of(const std::string& path) try {
  const std::string text = read_text_file(path, config::DbcStorage::kMaxBytes);
  const config::DbcStorage storage(text);
  if (!storage.status().ok()) return std::nullopt;
  std::vector<NamedSignal> out;
  const wire::Dbc& dbc = storage.content();
  for (const wire::DbcMessage& message : dbc.messages()) {
    for (const wire::DbcSignal& signal : dbc.signals_of(message)) {
      NamedSignal named;
      named.name =
          column_name(std::string(message.name) + '.' + std::string(signal.name));
      named.number = out.size() + 1;
      out.push_back(std::move(named));
    }
  }
  return out;
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace

std::string missing_dbc_signals(const std::string& dbc_path,
                                const std::vector<Column>& missing) {
  const std::optional<std::vector<NamedSignal>> read = signals_of(dbc_path);
  const std::vector<NamedSignal> signals = read.value_or(std::vector<NamedSignal>{});
  std::string needed;
  std::string options;
  for (const Column column : missing) {
    const std::string option = "--" + std::string(name_of(column));
    needed += (needed.empty() ? "" : " and ") + option + " MESSAGE.SIGNAL";
    const auto meant = [column](const NamedSignal& signal) {
      return signal.name.part == part_of(column);
    };
    if (std::ranges::count_if(signals, meant) != 1) continue;
    const auto one = std::ranges::find_if(signals, meant);
    options += (options.empty() ? "" : " ") + option + ' ' + one->name.text;
  }
  if (!read) return "--dbc needs " + needed;
  const std::string have =
      signals.empty() ? " has no signals" : " has the signals " + list_of(signals);
  return "--dbc needs " + needed + ": " + dbc_path + have +
         (options.empty() ? "" : "; add " + options);
}

}  // namespace workbench
