#include "workbench/serve/command_lines.hpp"

#include "workbench/recording/resample.hpp"
#include "workbench/recording/signal_choice.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

const char* word_of(DateOrder order) {
  switch (order) {
    case DateOrder::dmy:
      return "dmy";
    case DateOrder::mdy:
      return "mdy";
    case DateOrder::ymd:
      return "ymd";
  }
  return "";
}

std::string file_of(std::size_t step) {
  return "m" + (step > 1 ? std::to_string(step) : std::string()) + ".json";
}

}  // namespace

std::string source_words(const std::string& path, const CsvOptions& options,
                         std::optional<double> u_before) {
  std::string out = shell_word(path);
  const auto add = [&out](const char* option, const std::string& value) {
    if (!value.empty()) out += std::string(" ") + option + ' ' + shell_word(value);
  };
  add("--time", options.names.time);
  add("--u", options.names.u);
  add("--y", options.names.y);
  add("--sp", options.names.sp);
  add("--x", options.names.x);
  for (const std::string& load : options.names.loads) add("--load", load);
  if (options.date_order) add("--date-order", word_of(*options.date_order));
  if (options.decimal) add("--decimal", *options.decimal == ',' ? "comma" : "point");
  add("--sheet", options.sheet);
  if (options.ts) add("--ts", number(*options.ts, 9));
  if (u_before) add("--u-before", number(*u_before, 9));
  return out;
}

std::vector<std::string> command_lines(const SessionView& view) {
  const Recording& recording = view.own != nullptr ? *view.own : view.opened();
  std::string source = view.source.empty() ? shell_word(recording.name) : view.source;
  for (const BesideRecording& other : view.beside) {
    if (other.fitted) source += ' ' + shell_word(other.recording->name);
  }
  std::vector<std::string> out;
  if (view.whole != nullptr) {
    out.push_back("# " + recording.name + ": save its signals as CSV and name that file");
  }
  if (!recording.left_out.empty()) {
    out.push_back("# samples are left out of it; the commands take all of them");
  }
  if (recording.split.pair_samples > 0 ||
      recording.split.estimation_share != Split{}.estimation_share) {
    out.push_back("# its samples are shared out by hand; the commands do it as usual");
  }
  if (recording.has(Column::y)) out.push_back("stickband identify " + source);
  if (view.steps.empty()) return out;
  const Model& model = view.last().model;
  const std::string output = model.output == Column::x ? " --output x" : "";
  std::size_t step = 1;
  if (view.last().ladder) {
    out.push_back("stickband ladder " + source + output + " -o " + file_of(step));
  } else {
    out.push_back("stickband model " + source + output + " -o " + file_of(step));
    for (const HistoryStep& done : model.history) {
      // The commands fit to all of the recordings from the start.
      if (done.effect == "process" || done.effect == kRefitted) continue;
      const bool removed = done.effect.starts_with('-');
      out.push_back((removed ? "stickband remove " + shell_word(done.effect.substr(1))
                             : "stickband add " + shell_word(done.effect)) +
                    ' ' + source + " --model " + file_of(step) + " -o " +
                    file_of(step + 1));
      ++step;
    }
  }
  out.push_back("stickband compare " + source + " --model " + file_of(step));
  out.push_back("stickband explain " + source + " --model " + file_of(step));
  out.push_back("stickband report " + source + " --model " + file_of(step) +
                " -o report.html");
  return out;
}

}  // namespace workbench
