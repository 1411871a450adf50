// JSON from outside.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace workbench {

/// Levels: what walks through a value needs the stack for each of them.
inline constexpr int kDeepestJson = 100;

/// Whether brackets outside strings go so deep.
[[nodiscard]] bool is_too_deep(std::string_view text);

/// What `text` says; discarded (`is_discarded()`) where it is no JSON, or too deep.
/// `Json`: nlohmann::json or nlohmann::ordered_json.
template <class Json>
[[nodiscard]] Json parsed_json(std::string_view text) {
  if (is_too_deep(text)) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

}  // namespace workbench
