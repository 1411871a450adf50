// The table of words that columns and tags are called by, in the languages of control
// rooms.
#pragma once

#include <string_view>

#include "workbench/recording/column_words.hpp"

namespace workbench {

/// The part that a whole name means, folded as letters of folded.hpp are; kNone: no such
/// word. English, German, French, Spanish, Italian, Portuguese, Dutch, Swedish,
/// Norwegian, Danish, Finnish, Polish, Czech, Slovak, Hungarian, Romanian, Turkish,
/// Russian, Japanese, Chinese, Korean. O(log n).
[[nodiscard]] Part part_word(std::string_view folded);

}  // namespace workbench
