// Who may talk to the page's server.
#include <gtest/gtest.h>

#include "workbench/serve/origin.hpp"

namespace workbench {
namespace {

bool passes(std::string_view host, std::string_view origin = "", int port = 8316) {
  return !refusal({host, origin}, port).has_value();
}

TEST(ServeOrigin, LetsThePageAndProgramsOfThisMachinePass) {
  EXPECT_TRUE(passes("127.0.0.1:8316"));
  EXPECT_TRUE(passes("localhost:8316"));
  EXPECT_TRUE(passes("LocalHost:8316"));
  EXPECT_TRUE(passes("127.0.0.1:8316", "http://127.0.0.1:8316"));
  EXPECT_TRUE(passes("localhost:8316", "http://localhost:8316"));
  EXPECT_TRUE(passes("127.0.0.1", "http://127.0.0.1", 80));
}

TEST(ServeOrigin, RefusesOtherNamesOfThisMachine) {
  for (const char* host :
       {"", "evil.example", "evil.example:8316", "127.0.0.1", "127.0.0.1:8317",
        "127.0.0.1:83160", "127.0.0.1.evil.example:8316", "localhost.evil.example:8316",
        "[::1]:8316", "0.0.0.0:8316"}) {
    EXPECT_FALSE(passes(host)) << host;
  }
}

TEST(ServeOrigin, RefusesPagesOfOtherSites) {
  for (const char* origin :
       {"null", "https://127.0.0.1:8316", "http://127.0.0.1:8317", "http://evil.example",
        "http://127.0.0.1:8316.evil.example", "file://"}) {
    EXPECT_FALSE(passes("127.0.0.1:8316", origin)) << origin;
  }
}

TEST(ServeOrigin, SaysWhereToGo) {
  const std::optional<std::string> why = refusal({"evil.example", ""}, 8316);
  ASSERT_TRUE(why);
  EXPECT_NE(why->find("http://127.0.0.1:8316/"), std::string::npos);
}

}  // namespace
}  // namespace workbench
