#include "ident/verdict/verdict.hpp"

namespace ident {

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kStiction:
      return "stiction";
    case Verdict::kBacklash:
      return "backlash";
    case Verdict::kNoStiction:
      return "no_stiction";
    case Verdict::kUndecided:
      return "undecided";
    case Verdict::kBadData:
      return "bad_data";
  }
  return "undecided";
}

}  // namespace ident
