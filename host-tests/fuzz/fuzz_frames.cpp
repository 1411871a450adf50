#include <cstddef>
#include <cstdint>
#include <string_view>

#include "feed.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::feed_frames({reinterpret_cast<const char*>(data), size});
  return 0;
}
