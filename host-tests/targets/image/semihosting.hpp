// The debugger's calls of an Arm target: text out, files in, exit.
#pragma once

#include <cstddef>
#include <span>

namespace semihosting {

/// Prints a text that ends with a zero.
void write(const char* text);
/// Fills `line` with the command line, ended by a zero; false when it is too long.
[[nodiscard]] bool command_line(std::span<char> line);
/// Opens a file of the host for reading; negative when it cannot.
[[nodiscard]] int open(const char* path);
/// Bytes read into `out`, fewer at the end of the file.
[[nodiscard]] std::size_t read(int file, std::span<std::byte> out);
/// Ends the emulator with this status.
[[noreturn]] void leave(int status);

}  // namespace semihosting
