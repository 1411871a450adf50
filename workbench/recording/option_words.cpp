#include "workbench/recording/option_words.hpp"

#include "workbench/recording/named_signal.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

void add(std::string& words, const char* option, const std::string& value) {
  if (!value.empty()) words += std::string(" ") + option + ' ' + shell_word(value);
}

}  // namespace

std::string file_word(const std::string& path) {
  return shell_word(path.starts_with('-') ? "./" + path : path);
}

std::string option_words(const CsvOptions& options, std::optional<double> u_before) {
  std::string out;
  add(out, "--time", options.names.time);
  add(out, "--u", options.names.u);
  add(out, "--y", options.names.y);
  add(out, "--sp", options.names.sp);
  add(out, "--x", options.names.x);
  for (const std::string& load : options.names.loads) add(out, "--load", load);
  if (options.date_order) add(out, "--date-order", name_of(*options.date_order));
  if (options.decimal) add(out, "--decimal", *options.decimal == ',' ? "comma" : "point");
  add(out, "--sheet", options.sheet);
  if (options.ts) add(out, "--ts", number(*options.ts, 9));
  if (u_before) add(out, "--u-before", number(*u_before, 9));
  return out;
}

std::string option_words(const RecordingSource& source) {
  std::string out;
  add(out, "--dbc", source.dbc);
  add(out, "--config", source.config);
  if (source.loop) add(out, "--loop", std::to_string(*source.loop));
  return out + option_words(static_cast<const CsvOptions&>(source), source.u_before);
}

}  // namespace workbench
