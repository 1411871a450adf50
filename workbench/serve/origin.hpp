// Who may talk to the server: this machine's own page and programs, no foreign web site.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// What a request says about where it comes from; empty where it says nothing.
struct RequestOrigin {
  std::string_view host;    ///< header Host
  std::string_view origin;  ///< header Origin
};

/// Why a request to 127.0.0.1:`port` must be refused; nothing where it may pass.
///
/// A web site whose name was made to point at this machine (DNS rebinding) sends its own
/// name as Host; a page elsewhere that posts here sends its own Origin. Programs send no
/// Origin and pass.
[[nodiscard]] std::optional<std::string> refusal(const RequestOrigin& request, int port);

}  // namespace workbench
