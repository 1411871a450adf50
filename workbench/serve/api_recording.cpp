// Requests about the recording and the verdict on its valve.
#include <sstream>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/further_signals.hpp"
#include "workbench/recording/own_readings.hpp"
#include "workbench/recording/rest_before.hpp"
#include "workbench/recording/tag_file.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/recording/within_row.hpp"
#include "workbench/serve/api_handlers.hpp"
#include "workbench/serve/api_request.hpp"
#include "workbench/serve/column_preview.hpp"
#include "workbench/serve/command_lines.hpp"
#include "workbench/serve/session_json.hpp"
#include "workbench/simulate/recording_csv.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExampleScenario = "stiction-setpoint";
constexpr std::uint64_t kExampleSeed = 2;

std::string recording_name(const ApiRequest& request) {
  const std::string name = file_name(value_or(request, "name", "recording.csv"));
  return name.empty() ? "recording.csv" : name;
}

// u is enough beside x; where u lacks, what is told is all that lacks.
Recording opened_alone(const std::string& text, const std::string& name,
                       CsvOptions options) {
  try {
    return parse_csv(text, name, options);
  } catch (const InputError&) {
    options.required = {Column::u, Column::y};
    static_cast<void>(parse_csv(text, name, options));
    throw;
  }
}

std::vector<Load> foreign_loads(Recording recording) {
  static_cast<void>(take_out_own_readings(recording));
  return std::move(recording.loads);
}

// The other columns of a file that is read again in no time.
void note_further(const std::string& text, CsvOptions options, Recording& recording) {
  constexpr std::size_t kMostBytes = std::size_t{8} << 20;
  if (!options.names.loads.empty() || text.size() > kMostBytes) return;
  options.names.loads = {"all"};
  try {
    const std::vector<std::string> names =
        names_of_moving(foreign_loads(parse_csv(text, recording.name, options)));
    if (names.empty()) return;
    recording.resampling.notes.push_back(
        filled("not used: {0}. What moves the output as well is a load; to try one, open "
               "the file again and choose its columns",
               {first_three(names)}));
  } catch (const InputError&) {  // without them it could be read
  }
}

// A log and its database are for the command line, together or alone.
void refuse_can(std::string_view text, const std::string& name) {
  const auto refuse = [&name](const char* found) {
    throw InputError(name, 1, 1, "a CSV file", found,
                     "start `stickband serve` with the log and --dbc");
  };
  if (!text.empty() && text.find('(') == text.find_first_not_of(" \t\r\n")) {
    refuse("what looks like a candump log");
  }
  if (text.substr(0, text.find('"')).starts_with("VERSION ") &&
      text.find("\nBO_ ") != std::string_view::npos) {
    refuse("a database of CAN signals (DBC)");
  }
}

ApiResponse open_text(Session& session, const std::string& text, const std::string& name,
                      const ApiRequest& request) {
  const Opens opens = opens_named(value_or(request, "opens", ""));
  const bool keep = !value_or(request, "keep", "").empty();
  CsvOptions options = csv_options(request);
  const std::string wanted = value_or(request, "output", "");
  refuse_can(text, name);
  Recording recording = opened_alone(text, name, options);
  Column output = usual_output(recording);
  if (keep) {
    output = session.view().last().model.output;
  } else if (!wanted.empty()) {
    output = output_named(wanted);
  }
  if (!recording.has(output)) {
    options.required = {Column::u, output};
    recording = parse_csv(text, name, options);
  }
  recording.name = name;
  leave_out_own_readings(recording);
  note_further(text, options, recording);
  const std::optional<double> u_before = u_before_in(request);
  if (u_before) put_rest_before(recording, *u_before);
  note_within_row(recording);
  const std::string source = source_words(name, options, u_before);
  const auto reading = std::make_shared<const CsvOptions>(options);
  if (keep) {
    session.judge(std::move(recording), source, reading, turn_in(request));
  } else {
    session.open(std::move(recording), output, source, reading, turn_in(request));
  }
  session.say_opens(opens);
  return accepted(session);
}

}  // namespace

ApiResponse open_recording(Session& session, const ApiRequest& request) {
  return open_text(session, request.body, recording_name(request), request);
}

ApiResponse open_example(Session& session, const ApiRequest& request) {
  std::ostringstream csv;
  write_csv(*simulate(kExampleScenario, kExampleSeed), csv);
  const std::string name = std::string(kExampleScenario) + ".csv";
  static_cast<void>(open_text(session, csv.str(), name, request));
  session.say_maker(std::string("stickband simulate ") + kExampleScenario + " --seed " +
                    std::to_string(kExampleSeed) + " -o " + name);
  return accepted(session);
}

ApiResponse post_direction(Session& session, const ApiRequest& request) {
  const Json opens = object_in(request).value("opens", Json(""));
  session.say_opens(
      opens_named(opens.is_string() ? opens.get<std::string>() : opens.dump()));
  return json_response(state_json(session));
}

ApiResponse get_recording(Session& session, const ApiRequest&) {
  Json json = recording_json(session.view().opened());
  json["schema"] = 1;
  return json_response(json);
}

ApiResponse get_signals(Session& session, const ApiRequest&) {
  return {200, "application/json", signals_json(session.view()), {}};
}

ApiResponse post_columns(Session&, const ApiRequest& request) {
  return json_response(
      column_preview(request.body, recording_name(request), csv_options(request)));
}

// The body is the files one behind the other; ?names= and ?sizes= have one on each line.
ApiResponse post_table(Session&, const ApiRequest& request) {
  std::istringstream names(value_or(request, "names", ""));
  std::istringstream sizes(value_or(request, "sizes", ""));
  std::vector<NamedBytes> files;
  std::size_t from = 0;
  std::string name;
  for (std::size_t size = 0; std::getline(names, name) && sizes >> size; from += size) {
    if (size > request.body.size() - from) break;
    files.push_back({file_name(name), request.body.substr(from, size)});
    refuse_can(files.back().bytes, files.back().path);
  }
  if (files.size() < 2 || from != request.body.size()) {
    throw BadRequest("expected at least two files, their names and their sizes");
  }
  return {200, "text/csv", table_of_tag_files(files, csv_options(request)), {}};
}

ApiResponse get_valve(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  static_cast<void>(view.opened());
  const auto& answer = view.valve != nullptr ? view.valve : view.valve_so_far;
  if (answer == nullptr) {
    throw NotNow("there is no verdict on the valve yet; poll /api/state until verdict");
  }
  Json json = valve_json(*view.recording, *answer);
  json["provisional"] = view.valve == nullptr;
  return json_response(json);
}

}  // namespace workbench
