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
    std::vsnprintf(text_.data(), text_.size(), format, arguments);
    va_end(arguments);
  }
  void clear() { text_[0] = '\0'; }
  [[nodiscard]] const char* c_str() const { return text_.data(); }
  [[nodiscard]] std::string_view view() const { return text_.data(); }

 private:
  std::array<char, 192> text_{};
};

}  // namespace hal
