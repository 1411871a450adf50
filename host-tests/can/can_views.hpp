// What the table of diagnostic objects says, as files for people and for their tools.
#pragma once

#include <string>
#include <string_view>

namespace can_views {

/// The DBC of the cyclic status frames of all 31 loops.
[[nodiscard]] std::string dbc();

/// `page` with the text between `<!-- NAME -->` and `<!-- /NAME -->` made anew, for every
/// NAME of a table: gateway, loop, codes, broadcast, dtcs. Throws std::runtime_error when
/// a mark is missing.
[[nodiscard]] std::string page(std::string page);

}  // namespace can_views
