// Mutations under sanitizers are read, not identified.
#include "feed.hpp"

namespace fuzz {

void survive_identification(const workbench::Recording&) {}

}  // namespace fuzz
