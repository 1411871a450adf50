// The report of a screening: one page that needs nothing else.
#pragma once

#include <string>

#include "workbench/screen/screening.hpp"

namespace workbench {

/// The ranked loops with search, filters, a small picture each, and the details of one;
/// groups with their leader. A table of data and a script that draws the rows in view:
/// some 600 bytes a loop. Its policy allows no network and no other script.
[[nodiscard]] std::string screen_page(const Screening& screening);

/// The data of the page as JSON that may stand inside <script>.
[[nodiscard]] std::string page_data(const Screening& screening);

}  // namespace workbench
