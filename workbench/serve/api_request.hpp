// What a request of the workbench's API asks for, and answers put together.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/csv.hpp"
#include "workbench/serve/api.hpp"
#include "workbench/serve/session.hpp"

namespace workbench {

/// A request that says something impossible; becomes 400.
class BadRequest : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is not UTF-8 in a name or message is replaced, not refused.
[[nodiscard]] ApiResponse json_response(const nlohmann::ordered_json& json,
                                        int status = 200);
/// {"schema":1,"error":…}.
[[nodiscard]] ApiResponse error_of(int status, const nlohmann::ordered_json& error);
/// The state; work goes on.
[[nodiscard]] ApiResponse accepted(const Session& session);

/// A value of the query; `otherwise` where it is absent or empty.
[[nodiscard]] std::string value_or(const ApiRequest& request, const char* key,
                                   const char* otherwise);

// Each throws BadRequest where what it finds is not what it expects.

/// "y" or "x".
[[nodiscard]] Column output_named(const std::string& name);
/// Columns or tags by name, dates and sample period:
/// ?u=FIC101.OP&y=FIC101.PV&time=…&date_order=dmy&decimal=comma&sheet=Monday&ts=0.5&
/// load=, one load on each line
[[nodiscard]] CsvOptions csv_options(const ApiRequest& request);
/// ?u_before=0: where u rested before the first row; nothing where it is absent.
[[nodiscard]] std::optional<double> u_before_in(const ApiRequest& request);
/// ?opening=, a whole number; 0 where it is absent. `what` names it.
[[nodiscard]] std::uint64_t count_in(const ApiRequest& request, const char* key,
                                     const std::string& what);
/// ?turn= of a request that opens a file, as Session::await() takes it.
[[nodiscard]] std::uint64_t turn_in(const ApiRequest& request);
/// "yes", "no" or "".
[[nodiscard]] Opens opens_named(const std::string& word);
/// The body; an empty object where there is none.
[[nodiscard]] nlohmann::ordered_json object_in(const ApiRequest& request);
/// {"effect":"valve.stiction","with":[…]} as codes, "effect" first.
[[nodiscard]] std::vector<std::string> effects_in(const ApiRequest& request);
/// Two times in s at "from" and "to"; nothing where both are absent.
[[nodiscard]] std::optional<std::pair<double, double>> times_in(
    const nlohmann::ordered_json& json);
/// An array of strings; empty where the key is absent.
[[nodiscard]] std::vector<std::string> codes_in(const nlohmann::ordered_json& json,
                                                const char* key);
/// A finite number.
[[nodiscard]] double number_in(const nlohmann::ordered_json& json, const char* key);

}  // namespace workbench
