// What the report pages are put together from; HTML in, HTML out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// From the doctype to the opened <main> and the line that names the recording: `kind`
/// of report, name, samples, length. Plain text in.
[[nodiscard]] std::string page_top(std::string_view kind, const Recording& recording,
                                   std::string_view headline);
/// The footer, plain text, and the end of the document.
[[nodiscard]] std::string page_end(std::string_view footer);

/// Plain title and introduction above HTML content; nothing without content.
[[nodiscard]] std::string section(std::string_view title, std::string_view introduction,
                                  const std::string& content);

enum class Mood { kOpen, kGood, kBad };

/// A paragraph of the box below; plain text, left out where `content` is empty.
struct Remark {
  std::string_view title;  ///< bold; may be empty
  std::string content;
};

/// The box that says it all: a headline and remarks.
[[nodiscard]] std::string verdict_box(Mood mood, std::string_view headline,
                                      const std::vector<Remark>& remarks);

/// One number with what it is and a detail below; plain text.
[[nodiscard]] std::string tile(std::string_view label, std::string_view value,
                               std::string_view detail);
/// Tiles in a row.
[[nodiscard]] std::string tile_row(const std::string& tiles);

/// A list of plain sentences; nothing where there are none.
[[nodiscard]] std::string bullet_list(const std::vector<std::string>& sentences);

/// Two figures side by side where there is room.
[[nodiscard]] std::string side_by_side(const std::string& left, const std::string& right);

}  // namespace workbench
