#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/parsed_json.hpp"

namespace workbench {
namespace {

using nlohmann::json;

std::string nested(std::size_t depth) {
  return std::string(depth, '[') + std::string(depth, ']');
}

TEST(ParsedJson, IsDiscardedWhereItIsNoneOrTooDeep) {
  EXPECT_EQ(parsed_json<json>("{\"a\":[1]}").at("a")[0], 1);
  EXPECT_TRUE(parsed_json<json>("{\"a\":").is_discarded());
  EXPECT_TRUE(parsed_json<json>(nested(kDeepestJson)).is_array());
  EXPECT_TRUE(parsed_json<json>(nested(kDeepestJson + 1)).is_discarded());
  EXPECT_TRUE(parsed_json<json>(nested(300'000)).is_discarded());
}

TEST(ParsedJson, BracketsInTextsAreNoLevels) {
  EXPECT_EQ(parsed_json<json>("[\"" + std::string(500, '[') + "\"]")[0],
            std::string(500, '['));
  EXPECT_EQ(parsed_json<json>("[\"\\\"" + std::string(500, '{') + "\"]")[0],
            '"' + std::string(500, '{'));
}

}  // namespace
}  // namespace workbench
