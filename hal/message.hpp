// A sentence of bounded length, for errors on paths that must not allocate.
#pragma once

#include <array>
#include <cstdarg>
#include <cstdio>
#include <string_view>

namespace hal {

class Message {
 public:
  /// Replaces the text, as printf does; cut after 191 characters.
  [[gnu::format(printf, 2, 3)]] void set(const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    print(format, arguments);
    va_end(arguments);
  }
  /// The same, as vprintf does.
  [[gnu::format(printf, 2, 0)]] void print(const char* format, std::va_list arguments) {
    std::vsnprintf(text_.data(), text_.size(), format, arguments);
  }
  /// A message at once.
  [[gnu::format(printf, 1, 2)]] static Message of(const char* format, ...) {
    Message out;
    std::va_list arguments;
    va_start(arguments, format);
    out.print(format, arguments);
    va_end(arguments);
    return out;
  }
  void clear() { text_[0] = '\0'; }
  [[nodiscard]] const char* c_str() const { return text_.data(); }
  [[nodiscard]] std::string_view view() const { return text_.data(); }

 private:
  std::array<char, 192> text_{};
};

}  // namespace hal
