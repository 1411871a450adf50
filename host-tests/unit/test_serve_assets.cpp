// The page's files, as they are in the program.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "workbench/report/page_style.hpp"
#include "workbench/serve/assets.hpp"

namespace workbench {
namespace {

TEST(ServeAssets, HoldThePageAndEverythingItNames) {
  const std::optional<Asset> page = find_asset("/");
  ASSERT_TRUE(page);
  EXPECT_TRUE(page->type.starts_with("text/html"));
  EXPECT_EQ(page->content, find_asset("/index.html")->content);
  const std::string text(page->content);
  const std::regex link("(?:src|href)=\"(/[^\"]*)\"");
  int files = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
    const std::string path = (*at)[1];
    if (path.starts_with("/api/")) continue;
    EXPECT_TRUE(find_asset(path)) << path;
    ++files;
  }
  EXPECT_GE(files, 5);
}

TEST(ServeAssets, ScriptsNameModulesThatExist) {
  const std::optional<Asset> script = find_asset("/app.js");
  ASSERT_TRUE(script);
  EXPECT_TRUE(script->type.starts_with("text/javascript"));
  const std::string text(script->content);
  const std::regex import("from '\\./([^']*)'");
  for (std::sregex_iterator at(text.begin(), text.end(), import), end; at != end; ++at) {
    EXPECT_TRUE(find_asset('/' + (*at)[1].str())) << (*at)[1];
  }
}

TEST(ServeAssets, NeedNoOtherServer) {
  for (const char* path : {"/", "/app.js", "/api.js", "/charts.js", "/page.css",
                           "/report.css", "/uplot/uPlot.min.css"}) {
    const std::optional<Asset> asset = find_asset(path);
    ASSERT_TRUE(asset) << path;
    EXPECT_EQ(asset->content.find("//cdn"), std::string_view::npos) << path;
    EXPECT_EQ(asset->content.find("http://"), std::string_view::npos) << path;
    EXPECT_EQ(asset->content.find("https://"), std::string_view::npos) << path;
  }
}

TEST(ServeAssets, ShareTheStyleOfTheReport) {
  EXPECT_EQ(find_asset("/report.css")->content, kPageStyle);
}

TEST(ServeAssets, AreNothingElse) {
  for (const char* path :
       {"", "app.js", "/no", "/../session.cpp", "//app.js", "/uplot"}) {
    EXPECT_FALSE(find_asset(path)) << path;
  }
}

}  // namespace
}  // namespace workbench
