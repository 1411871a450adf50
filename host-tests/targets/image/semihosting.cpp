#include "host-tests/targets/image/semihosting.hpp"

#include <cstdint>
#include <cstring>

namespace semihosting {
namespace {

enum class Call : std::uint32_t {
  kOpen = 0x01,
  kWrite0 = 0x04,
  kRead = 0x06,
  kCommandLine = 0x15,
  kExitExtended = 0x20,
};

int call(Call what, const void* argument) {
  register std::uint32_t r0 asm("r0") = static_cast<std::uint32_t>(what);
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return static_cast<int>(r0);
}

std::uint32_t word(const void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
}

}  // namespace

void write(const char* text) {
  call(Call::kWrite0, text);
}

bool command_line(std::span<char> line) {
  const std::uint32_t block[] = {word(line.data()), line.size()};
  return call(Call::kCommandLine, block) == 0;
}

int open(const char* path) {
  constexpr std::uint32_t kReadBinary = 1;
  const std::uint32_t block[] = {word(path), kReadBinary, std::strlen(path)};
  return call(Call::kOpen, block);
}

std::size_t read(int file, std::span<std::byte> out) {
  const std::uint32_t block[] = {static_cast<std::uint32_t>(file), word(out.data()),
                                 out.size()};
  const int left = call(Call::kRead, block);
  return out.size() - static_cast<std::size_t>(left);
}

void leave(int status) {
  constexpr std::uint32_t kApplicationExit = 0x20026;
  const std::uint32_t block[] = {kApplicationExit, static_cast<std::uint32_t>(status)};
  while (true) {
    call(Call::kExitExtended, block);
  }
}

}  // namespace semihosting
