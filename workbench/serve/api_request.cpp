#include "workbench/serve/api_request.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "wire/text.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/parsed_json.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/serve/session_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

// A finite number of the query, where there is one; `expected` says what it has to be.
std::optional<double> number_of(const std::string& text, const std::string& expected,
                                bool positive) {
  if (text.empty()) return std::nullopt;
  const std::optional<double> value = wire::number_of<double>(text);
  if (!value || !std::isfinite(*value) || (positive && *value <= 0)) {
    throw BadRequest(filled("expected {0}, found {1}; correct it, or leave it empty",
                            {expected, workbench::quoted(text)}));
  }
  return value;
}

// Columns or tags by name: ?u=FIC101.OP&y=FIC101.PV&time=...&load=, one on each line.
ColumnNames names_in(const ApiRequest& request) {
  std::vector<std::string> loads;
  std::istringstream lines(value_or(request, "load", ""));
  for (std::string name; std::getline(lines, name);) loads.push_back(name);
  return {value_or(request, "time", ""), value_or(request, "u", ""),
          value_or(request, "y", ""),    value_or(request, "sp", ""),
          value_or(request, "x", ""),    loads};
}

std::optional<DateOrder> date_order_of(const ApiRequest& request) {
  const std::string text = value_or(request, "date_order", "");
  const std::optional<DateOrder> order = date_order_named(text);
  if (order || text.empty()) return order;
  throw BadRequest("expected date_order dmy, mdy or ymd, found " +
                   workbench::quoted(text));
}

std::optional<char> decimal_of(const ApiRequest& request) {
  const std::string text = value_or(request, "decimal", "");
  if (text.empty()) return std::nullopt;
  if (text == "point") return '.';
  if (text == "comma") return ',';
  throw BadRequest("expected decimal point or comma, found " + workbench::quoted(text));
}

}  // namespace

ApiResponse accepted(const Session& session) {
  return json_response(state_json(session), 202);
}

CsvOptions csv_options(const ApiRequest& request) {
  return {number_of(in_seconds(value_or(request, "ts", "")),
                    "a positive number of seconds as the sample period", true),
          {Column::u},
          names_in(request),
          date_order_of(request),
          decimal_of(request),
          value_or(request, "sheet", "")};
}

std::optional<double> u_before_in(const ApiRequest& request) {
  return number_of(value_or(request, "u_before", ""),
                   "a number as the value of u before the first row", false);
}

std::uint64_t count_in(const ApiRequest& request, const char* key,
                       const std::string& what) {
  const std::string text = value_or(request, key, "0");
  const auto value = wire::number_of<std::uint64_t>(text);
  if (!value) {
    throw BadRequest(filled("expected {0}, found {1}", {what, workbench::quoted(text)}));
  }
  return *value;
}

std::uint64_t turn_in(const ApiRequest& request) {
  return count_in(request, "turn", "the time of opening, ms since 1970");
}

ApiResponse json_response(const Json& json, int status) {
  // What is not UTF-8 in a name or message is replaced, not refused.
  return {status,
          "application/json",
          json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n',
          {}};
}

ApiResponse error_of(int status, const Json& error) {
  return json_response({{"schema", 1}, {"error", error}}, status);
}

std::string value_or(const ApiRequest& request, const char* key, const char* otherwise) {
  const auto found = request.query.find(key);
  return found == request.query.end() || found->second.empty() ? otherwise
                                                               : found->second;
}

Column output_named(const std::string& name) {
  if (name == "y") return Column::y;
  if (name == "x") return Column::x;
  throw BadRequest("expected output y or x, found '" + name + "'");
}

Opens opens_named(const std::string& word) {
  if (word.empty()) return Opens::unknown;
  if (word == "yes") return Opens::yes;
  if (word == "no") return Opens::no;
  throw BadRequest("expected opens yes or no, found " + workbench::quoted(word));
}

Json object_in(const ApiRequest& request) {
  if (request.body.empty()) return Json::object();
  const Json json = parsed_json<Json>(request.body);
  if (!json.is_object()) {
    throw BadRequest("expected a JSON object as body, found " +
                     workbench::quoted(request.body));
  }
  return json;
}

std::vector<std::string> codes_in(const Json& json, const char* key) {
  std::vector<std::string> codes;
  const Json list = json.value(key, Json::array());
  const bool strings = list.is_array() && std::ranges::all_of(list, [](const Json& item) {
                         return item.is_string();
                       });
  if (!strings) {
    throw BadRequest(std::string("expected an array of effects at '") + key + '\'');
  }
  for (const Json& item : list) codes.push_back(item.get<std::string>());
  return codes;
}

std::vector<std::string> effects_in(const ApiRequest& request) {
  const Json json = object_in(request);
  const Json effect = json.value("effect", Json(nullptr));
  if (!effect.is_string()) {
    throw BadRequest("expected {\"effect\": \"valve.stiction\"} or another code, found " +
                     workbench::quoted(request.body));
  }
  std::vector<std::string> codes = codes_in(json, "with");
  codes.insert(codes.begin(), effect.get<std::string>());
  return codes;
}

std::optional<std::pair<double, double>> times_in(const Json& json) {
  if (!json.contains("from") && !json.contains("to")) return std::nullopt;
  return std::pair(number_in(json, "from"), number_in(json, "to"));
}

double number_in(const Json& json, const char* key) {
  const Json value = json.value(key, Json(nullptr));
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    throw BadRequest(std::string("expected a number at '") + key + "', found " +
                     workbench::quoted(value.dump()));
  }
  return value.get<double>();
}

}  // namespace workbench
