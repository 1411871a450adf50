#include "workbench/report/truth_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 20;
constexpr const char* kAdvice = "give the file that stickband simulate --truth wrote";

nlohmann::json parse(const std::string& text, const std::string& path) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t at = std::min(error.byte, text.size());
    const std::string_view before(text.data(), at > 0 ? at - 1 : 0);
    const std::size_t line_start = before.find_last_of('\n') + 1;
    const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
    throw InputError(path, line, before.size() - line_start + 1, "JSON",
                     text.empty() ? "an empty file" : "something else", kAdvice);
  }
}

}  // namespace

KnownTruth read_truth(const std::string& path) {
  const nlohmann::json json = parse(read_text_file(path, kMaxBytes), path);
  try {
    KnownTruth truth;
    truth.kind = json.at("kind").get<std::string>();
    const nlohmann::json& band = json.at("stick_band");
    truth.stick_band_ascending = band.at("ascending").get<double>();
    truth.stick_band_descending = band.at("descending").get<double>();
    const nlohmann::json& jump = json.at("slip_jump");
    truth.slip_jump_ascending = jump.at("ascending").get<double>();
    truth.slip_jump_descending = jump.at("descending").get<double>();
    if (json.contains("process")) {
      const nlohmann::json& p = json.at("process");
      truth.process = ProcessModel{
          p.at("gain").get<double>(), p.at("lag_s").get<double>(),
          p.at("second_lag_s").get<double>(), p.at("dead_time_s").get<double>(),
          p.at("integrating").get<bool>()};
    }
    return truth;
  } catch (const nlohmann::json::exception& error) {
    // what() is "[json.exception.name.id] sentence".
    const std::string_view what = error.what();
    throw InputError(path, 0, 0, "the truth of a simulation",
                     std::string(what.substr(what.find("] ") + 2)), kAdvice);
  }
}

}  // namespace workbench
