// A text file of any size, block by block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace workbench {

/// Whole lines, in blocks of some megabytes; without a byte-order mark. UTF-16 is
/// converted as a whole, and refused above 512 MiB.
class TextBlocks {
 public:
  /// Throws InputError where the file cannot be read or is no text.
  explicit TextBlocks(const std::string& path, std::size_t block = std::size_t{4} << 20);

  /// The next lines; empty at the end. They are gone with the next call. Throws
  /// InputError for a line of more than 64 MiB and where reading fails.
  [[nodiscard]] std::string_view next();

  [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  void convert();

  const std::string path_;
  std::size_t block_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::string buffer_;
  std::size_t given_ = 0;  // bytes of the buffer that were handed out
  std::uint64_t bytes_read_ = 0;
  std::uint64_t size_ = 0;
  bool first_ = true;
  bool at_end_ = false;
};

/// `block` without its first `lines_left` lines; what the block lacks is left.
[[nodiscard]] std::string_view without_lines(std::string_view block,
                                             std::size_t& lines_left);

/// The first `lines` lines of a file, at most 64 MiB.
[[nodiscard]] std::string head_of_file(const std::string& path, std::size_t lines);

}  // namespace workbench
