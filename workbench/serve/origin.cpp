#include "workbench/serve/origin.hpp"

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

bool is_this_machine(const std::string& authority, int port) {
  const std::string end = ':' + std::to_string(port);
  for (const std::string name : {"127.0.0.1", "localhost"}) {
    if (authority == name + end || (port == 80 && authority == name)) return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> refusal(const RequestOrigin& request, int port) {
  const std::string here = "127.0.0.1:" + std::to_string(port);
  if (!is_this_machine(lower_case(request.host), port)) {
    return "expected Host " + here + ", found another; open http://" + here + '/';
  }
  const std::string origin = lower_case(request.origin);
  constexpr std::string_view kScheme = "http://";
  const bool own =
      origin.starts_with(kScheme) && is_this_machine(origin.substr(kScheme.size()), port);
  if (!origin.empty() && !own) {
    return "expected a request of this page or of a program, found one of another web "
           "site; open http://" +
           here + '/';
  }
  return std::nullopt;
}

}  // namespace workbench
