#include "workbench/serve/command_lines.hpp"

#include "workbench/recording/listed.hpp"
#include "workbench/recording/option_words.hpp"
#include "workbench/recording/signal_choice.hpp"
#include "workbench/recording/tag_file.hpp"
#include "workbench/serve/api_handlers.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

// The options behind the files of words as of source_words().
std::string options_in(const std::string& source) {
  char quote = 0;
  for (std::size_t at = 0; at < source.size(); ++at) {
    const char c = source[at];
    if (quote == 0 && source.compare(at, 3, " --") == 0) return source.substr(at + 1);
    if (quote == 0 && c == '\\') {
      ++at;
    } else if (c == '"' || c == '\'') {
      if (quote == 0) {
        quote = c;
      } else if (quote == c) {
        quote = 0;
      }
    }
  }
  return {};
}

std::string read_otherwise(const std::string& file, const std::string& own,
                           const std::string& first) {
  const auto shown = [](const std::string& options) {
    return options.empty() ? std::string("without options") : "with " + options;
  };
  return "# " + file + " was read " + shown(own) + ", the first file " + shown(first) +
         "; a command reads all alike: name its columns as those of the first";
}

// Those that a recording was put together from.
std::string file_words(const std::string& name) {
  return listed(files_in(name), " ", file_word);
}

std::string file_of(std::size_t step) {
  return "m" + (step > 1 ? std::to_string(step) : std::string()) + ".json";
}

void say_results(const std::string& source, const std::string& judging,
                 const std::string& model, std::vector<std::string>& out) {
  const std::string of = source + " --model " + model;
  out.push_back("stickband compare " + of + judging);
  out.push_back("stickband explain " + of);
  out.push_back("stickband report " + of + " -o report.html");
}

}  // namespace

std::string source_words(const std::string& path, const CsvOptions& options,
                         std::optional<double> u_before) {
  return file_words(path) + option_words(options, u_before);
}

std::vector<std::string> command_lines(const SessionView& view) {
  const Recording& recording = view.own != nullptr ? *view.own : view.opened();
  std::string source = view.source.empty() ? file_words(recording.name) : view.source;
  const std::string options = options_in(source);
  std::string judging;
  std::vector<std::string> out;
  if (!view.maker.empty()) out.push_back(view.maker);
  for (const BesideRecording& other : view.beside) {
    const std::string file = file_word(other.recording->name);
    if (other.fitted) {
      source += ' ' + file;
    } else {
      judging += " --validate " + file;
    }
    const std::string own = other.source.empty() ? options : options_in(other.source);
    if (own != options) out.push_back(read_otherwise(file, own, options));
  }
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
  if (!view.last().fitted_here || is_by_hand(model)) {
    const std::string saved = file_word(stem_of(recording.name) + ".model.json");
    out.push_back((view.last().fitted_here
                       ? "# save the model, of which values were set by hand: "
                       : "# save the model, which was fitted to another recording: ") +
                  saved);
    say_results(source, judging, saved, out);
    return out;
  }
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
  say_results(source, judging, file_of(step), out);
  return out;
}

}  // namespace workbench
