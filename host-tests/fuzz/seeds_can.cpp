#include <cstdint>

#include "seeds.hpp"

namespace fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kWritesWithKey = 3;
constexpr std::uint8_t kSmallBlocks = 4;
constexpr std::uint8_t kExtended = 0x80;
constexpr std::uint8_t kRightKey = 16;
constexpr std::uint8_t kFunctional = 4;

void append(std::string& text, const Bytes& bytes) {
  text.append(bytes.begin(), bytes.end());
}

std::string start(std::uint8_t settings) {
  return {static_cast<char>(settings)};
}

void ask(std::string& text, const Bytes& request, std::uint8_t control = 0) {
  append(text, {control, static_cast<std::uint8_t>(request.size())});
  append(text, request);
}

void frame(std::string& text, const Bytes& data, std::uint8_t control = 0) {
  append(text, {control, static_cast<std::uint8_t>(data.size())});
  append(text, data);
}

std::string reading() {
  std::string text = start(0);
  ask(text, {0x22, 0xFD, 0x10, 0xFD, 0x11, 0xF1, 0x95, 0xFD, 0x01});
  ask(text, {0x19, 0x02, 0xFF});
  ask(text, {0x19, 0x0A});
  ask(text, {0x19, 0x04, 0x51, 0x01, 0x71, 0xFF});
  ask(text, {0x19, 0x06, 0x51, 0x01, 0x71, 0x01});
  ask(text, {0x14, 0xFF, 0xFF, 0xFF});
  ask(text, {0x31, 0x01, 0xF0, 0x01, 0x01});
  ask(text, {0x3E, 0x80}, kFunctional);
  return text;
}

std::string writing() {
  std::string text = start(kWritesWithKey);
  ask(text, {0x10, 0x03});
  ask(text, {0x27, 0x01});
  ask(text, {0x27, 0x02}, kRightKey);
  ask(text, {0x2E, 0xFD, 0x15, 0, 3, 0, 9, 0, 100, 4, 3, 0, 1});
  ask(text, {0x31, 0x01, 0xF0, 0x02, 0x1F, 0x04});
  ask(text, {0x31, 0x03, 0xF0, 0x02, 0x1F});
  ask(text, {0x31, 0x02, 0xF0, 0x02});
  ask(text, {0x31, 0x01, 0xF0, 0x00});
  return text;
}

std::string uploading(std::uint8_t settings, std::uint8_t blocks) {
  std::string text = start(settings);
  ask(text, {0x35, 0x00, 0x44, 0, 0, 0, 1, 0, 0, 1, 0});
  for (std::uint8_t counter = 1; counter <= blocks; ++counter) {
    ask(text, {0x36, counter});
  }
  ask(text, {0x37});
  return text;
}

std::string frames(std::uint8_t settings) {
  std::string text = start(settings);
  frame(text, {0x03, 0x22, 0xF1, 0x86});
  frame(text, {0x03, 0x22, 0xFD, 0x01, 0xCC, 0xCC, 0xCC, 0xCC});
  frame(text, {0x30, 0x04, 0x01});
  frame(text, {0x02, 0x3E, 0x80}, 4 | 1);
  frame(text, {0x30, 0x00, 0x00}, 1);
  frame(text, {0x03, 0x22, 0xF1, 0x95}, 8);
  frame(text, {0x10, 0x0D, 0x2E, 0xFD, 0x15, 0, 3, 0});
  frame(text, {0x21, 9, 0, 100, 4, 3, 0, 1});
  frame(text, {0x10, 0x14, 0x22, 0xFD, 0x10, 0xFD, 0x11, 0xFD});
  frame(text, {0x21, 0x12, 0xFD, 0x13, 0xFD, 0x14, 0xFD, 0x15}, 2);
  frame(text, {0x22, 0xFD, 0x16, 0xFD, 0x17, 0xFD, 0x18, 0xFD});
  frame(text, {0x32, 0, 0}, 3);
  return text;
}

}  // namespace

std::vector<std::string> uds_seeds() {
  return {reading(), writing(), uploading(0, 1), uploading(kSmallBlocks, 40)};
}

std::vector<std::string> isotp_seeds() {
  return {frames(0), frames(0x10), frames(kExtended), frames(kExtended | kWritesWithKey)};
}

}  // namespace fuzz
