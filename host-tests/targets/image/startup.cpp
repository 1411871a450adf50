// From reset to main on a Cortex-M4F: memory, floating point, and a guard that turns a
// write through a null pointer or past the stack into a fault.
#include <cstdint>
#include <cstring>

#include "host-tests/targets/image/semihosting.hpp"

extern "C" {
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[];
extern const std::uint32_t data_load[];
extern std::uint32_t stack_low[], stack_high[];
int main();
[[noreturn]] void reset();
}

namespace {

constexpr int kFaultStatus = 99;

[[noreturn]] void fault() {
  semihosting::write("fault: the processor refused an instruction or an access\n");
  semihosting::leave(kFaultStatus);
}

volatile std::uint32_t& at(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

void turn_on_floating_point() {
  constexpr std::uintptr_t kCpacr = 0xE000ED88;
  at(kCpacr) = at(kCpacr) | (0xFu << 20);
  asm volatile("dsb\n isb" ::: "memory");
}

// Regions of the memory protection unit, the later ones above the earlier.
void guard_memory() {
  constexpr std::uintptr_t kControl = 0xE000ED94;
  constexpr std::uintptr_t kBase = 0xE000ED9C;
  constexpr std::uintptr_t kAttributes = 0xE000EDA0;
  constexpr std::uint32_t kSelect = 1u << 4;  // the low bits of kBase name a region
  constexpr std::uint32_t kEnable = 1;
  constexpr std::uint32_t kCodeSize = 21u << 1;  // 2^22 bytes
  constexpr std::uint32_t kGuardSize = 4u << 1;  // 2^5 bytes
  constexpr std::uint32_t kReadOnly = 6u << 24;
  constexpr std::uint32_t kNoAccess = 1u << 28;  // nor is it executed
  at(kBase) = 0u | kSelect | 0u;
  at(kAttributes) = kReadOnly | kCodeSize | kEnable;
  at(kBase) = reinterpret_cast<std::uintptr_t>(stack_low) | kSelect | 1u;
  at(kAttributes) = kNoAccess | kGuardSize | kEnable;
  constexpr std::uint32_t kElsewhereAsUsual = 1u << 2;
  at(kControl) = kElsewhereAsUsual | kEnable;
  asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace

extern "C" void reset() {
  turn_on_floating_point();
  std::memcpy(data_begin, data_load,
              static_cast<std::size_t>(data_end - data_begin) * sizeof(std::uint32_t));
  std::memset(bss_begin, 0,
              static_cast<std::size_t>(bss_end - bss_begin) * sizeof(std::uint32_t));
  guard_memory();
  semihosting::leave(main());
}

namespace {

using Handler = void (*)();

struct Vectors {
  std::uint32_t* stack;
  Handler handlers[15];
};

}  // namespace

extern "C" [[gnu::section(".vectors"), gnu::used]] const Vectors vectors = {
    stack_high,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     fault, fault, fault}};
