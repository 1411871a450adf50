// The page's files, as they are in the program.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "workbench/report/page_style.hpp"
#include "workbench/serve/assets.hpp"
#include "workbench/serve/embedded.hpp"

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

TEST(ServeAssets, NameEveryModuleAtOnce) {
  const std::string page(find_asset("/")->content);
  const auto named = [&page](std::string_view file) {
    return page.find("<link rel=\"modulepreload\" href=\"/" + std::string(file) + "\">") <
           page.find("</head>");
  };
  EXPECT_TRUE(named("texts/all.js"));
  for (const EmbeddedFile& file : embedded_files()) {
    const bool module = file.name.ends_with(".js") && !file.name.starts_with("uplot/");
    EXPECT_EQ(named(file.name), module) << file.name;
  }
}

TEST(ServeAssets, ScriptsNameModulesThatExist) {
  EXPECT_TRUE(find_asset("/app.js")->type.starts_with("text/javascript"));
  const std::regex import("from '\\./([^']*)'");
  int imports = 0;
  for (const EmbeddedFile& file : embedded_files()) {
    const std::string text(file.content);
    const std::string folder(file.name.substr(0, file.name.rfind('/') + 1));
    for (std::sregex_iterator at(text.begin(), text.end(), import), end; at != end;
         ++at) {
      EXPECT_TRUE(find_asset('/' + folder + (*at)[1].str()))
          << file.name << ' ' << (*at)[1];
      ++imports;
    }
  }
  EXPECT_GT(imports, 20);
}

TEST(ServeAssets, NeedNoOtherServer) {
  int scripts = 0;
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.name.ends_with(".js")) ++scripts;
    if (file.name == "uplot/uPlot.iife.min.js") continue;  // its head names its home
    // Names of XML, which nobody fetches.
    const std::string text = std::regex_replace(std::string(file.content),
                                                std::regex("http://www.w3.org"), "");
    for (const char* foreign : {"//cdn", "http://", "https://"}) {
      EXPECT_EQ(text.find(foreign), std::string::npos) << file.name << ' ' << foreign;
    }
  }
  EXPECT_GT(scripts, 10);
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
