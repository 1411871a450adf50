// The pictures of the report, on numbers that can be checked by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

TEST(ReportTicks, AreRoundNumbersInsideTheRange) {
  EXPECT_EQ(ticks(0, 10, 5), (Values{0, 2, 4, 6, 8, 10}));
  EXPECT_FALSE(std::signbit(ticks(0, 10, 5)[0]));
  EXPECT_EQ(ticks(-1, 1, 4), (Values{-1, -0.5, 0, 0.5, 1}));
  EXPECT_EQ(ticks(3, 3, 4), (Values{3}));
  for (const double width : {1e-9, 0.037, 1.0, 88.0, 4.2e7}) {
    for (const double low : {-1.3, 0.0, 7.7}) {
      const Values at = ticks(low * width, (low + 1) * width, 5);
      ASSERT_GE(at.size(), 2U);
      ASSERT_LE(at.size(), 11U);
      EXPECT_GE(at.front(), low * width - 1e-6 * width);
      EXPECT_LE(at.back(), (low + 1) * width + 1e-6 * width);
    }
  }
}

TEST(ReportVisiblePoints, KeepEveryExtremeInOrder) {
  Values y(100000);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = std::sin(static_cast<double>(i) * 0.7);
  y[54321] = 9;
  y[77777] = -9;
  const std::vector<std::size_t> shown = visible_points(y, 500);
  EXPECT_LE(shown.size(), 2000U);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  EXPECT_NE(std::find(shown.begin(), shown.end(), 54321U), shown.end());
  EXPECT_NE(std::find(shown.begin(), shown.end(), 77777U), shown.end());
  EXPECT_EQ(shown.front(), 0U);
  EXPECT_EQ(shown.back(), y.size() - 1);
  EXPECT_EQ(visible_points({1, 2, 3}, 500).size(), 3U);
}

TEST(ReportText, IsEscaped) {
  EXPECT_EQ(escaped("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
}

TEST(ReportFigure, DrawsConstantAndEmptyLinesWithoutNonsense) {
  Plot plot;
  plot.title = "a \"plot\"";
  plot.x_label = "t";
  plot.y_label = "y";
  plot.lines = {{"flat", Ink::kMeasured, {0, 1, 2}, {5, 5, 5}},
                {"absent", Ink::kValve, {}, {}}};
  const std::string svg = figure(plot, "");
  EXPECT_NE(svg.find("flat"), std::string::npos);
  EXPECT_EQ(svg.find("absent"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_NE(svg.find("a &quot;plot&quot;"), std::string::npos);
}

TEST(ReportFigure, DrawsBarsLevelsNamesAndNotes) {
  Plot plot;
  plot.width = 300;
  plot.height = 150;
  plot.bars = {{-0.5, 0.5, 1, false}, {0.5, 1.5, -2, true}};
  plot.levels = {{"noise", 0.5}};
  plot.names = {"start", "+ dead\ntime"};
  PlotLine line{"", Ink::kTwoPath, {0, 1}, {1, -2}};
  line.is_signal = false;
  line.notes = {"one", "<two>"};
  plot.lines = {line};
  const std::string svg = figure(plot, "");
  for (const char* part :
       {"class=\"usual\"", "class=\"raised\"", "class=\"level\"", ">noise<", ">start<",
        ">+ dead<", ">time<", ">one<", ">&lt;two&gt;<", "<circle", "data-still"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(svg.find("legend"), std::string::npos);
  // Beside its point, where the line comes down to it.
  EXPECT_NE(svg.find("text-anchor=\"middle\">one<"), std::string::npos);
  EXPECT_NE(svg.find("text-anchor=\"start\">&lt;two&gt;<"), std::string::npos);
}

TEST(ReportFigure, StaggersNamesThatNeedRoom) {
  Plot plot;
  plot.names = {"one", "two", "three"};
  plot.lines = {{"", Ink::kTwoPath, {0, 1, 2}, {1, 2, 3}}};
  const auto height_of = [](const std::string& svg, const std::string& name) {
    const std::size_t at = svg.rfind(" y=\"", svg.find('>' + name + '<'));
    return std::stod(svg.substr(at + 4));
  };
  const std::string level = figure(plot, "");
  EXPECT_EQ(height_of(level, "one"), height_of(level, "two"));
  plot.staggered = true;
  const std::string staggered = figure(plot, "");
  EXPECT_GT(height_of(staggered, "two"), height_of(staggered, "one") + 20);
  EXPECT_EQ(height_of(staggered, "three"), height_of(staggered, "one"));
}

TEST(ReportTime, HasTheUnitThatGivesShortNumbers) {
  EXPECT_STREQ(time_unit_for(30).label, "time, s");
  EXPECT_EQ(time_unit_for(3600).seconds, 60);
  EXPECT_EQ(time_unit_for(86400).seconds, 3600);
  EXPECT_EQ(time_unit_for(1e7).seconds, 86400);
}

TEST(ReportTicks, OfARangeThatNumbersCannotDivideAreOne) {
  EXPECT_EQ(ticks(50, std::nextafter(50, 51), 5).size(), 1U);
  EXPECT_EQ(ticks(-1e9, -1e9 + 1e-5, 5).size(), 1U);
  EXPECT_GT(ticks(1e9, 1e9 + 1, 5).size(), 2U);
}

}  // namespace
}  // namespace workbench
