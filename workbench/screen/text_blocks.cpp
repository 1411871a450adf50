#include "workbench/screen/text_blocks.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "wire/text.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/recording/workbook.hpp"

namespace workbench {
namespace {

constexpr std::size_t kLongestLine = std::size_t{64} << 20;
constexpr std::size_t kLongestConverted = std::size_t{512} << 20;

}  // namespace

TextBlocks::TextBlocks(const std::string& path, std::size_t block)
    : path_(path), block_(block), file_(nullptr, &std::fclose) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(path, 0, 0, "a readable file", "a folder", "name a file");
  }
  file_.reset(std::fopen(path.c_str(), "rb"));
  if (!file_) {
    throw InputError(path, 0, 0, "a readable file",
                     std::string("'") + std::strerror(errno) + "'",
                     "check the path and its permissions");
  }
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored) size_ = size;
}

void TextBlocks::convert() {
  file_.reset();
  const std::string bytes = read_text_file(path_, kLongestConverted);
  std::string converted;
  buffer_ = std::string(text_of(bytes, path_, converted));
  bytes_read_ = bytes.size();
  at_end_ = true;
  given_ = buffer_.size();
}

std::string_view TextBlocks::next() {
  buffer_.erase(0, given_);
  given_ = 0;
  while (!at_end_) {
    const std::size_t before = buffer_.size();
    buffer_.resize(before + block_);
    const std::size_t got = std::fread(buffer_.data() + before, 1, block_, file_.get());
    buffer_.resize(before + got);
    bytes_read_ += got;
    if (std::ferror(file_.get()) != 0) {
      throw InputError(path_, 0, 0, "a readable file", "a read error", "check the disk");
    }
    at_end_ = got < block_;
    if (first_) {
      first_ = false;
      std::string converted;
      const bool workbook = is_zip(buffer_);
      const std::string_view text =
          workbook ? std::string_view() : text_of(buffer_, path_, converted);
      if (workbook || !converted.empty()) {
        convert();
        return buffer_;
      }
      buffer_.erase(0, buffer_.size() - text.size());
    }
    if (at_end_) break;
    // A carriage return at the end may have its line feed in the next block.
    std::size_t end = buffer_.rfind('\n');
    if (end == std::string::npos && buffer_.size() > 1) {
      end = buffer_.rfind('\r', buffer_.size() - 2);
    }
    if (end != std::string::npos) {
      given_ = end + 1;
      return {buffer_.data(), given_};
    }
    if (buffer_.size() > kLongestLine) {
      throw InputError(path_, 0, 0, "lines of at most 64 MiB", "a longer one",
                       "export a text file with a row a line");
    }
  }
  given_ = buffer_.size();
  return buffer_;
}

std::string_view without_lines(std::string_view block, std::size_t& lines_left) {
  for (; lines_left > 0 && !block.empty(); --lines_left) (void)wire::take_line(block);
  return block;
}

std::string head_of_file(const std::string& path, std::size_t lines) {
  TextBlocks blocks(path, std::size_t{1} << 18);
  std::string head;
  std::size_t found = 0;
  for (std::string_view text = blocks.next(); !text.empty() && found < lines;
       text = blocks.next()) {
    head += text;
    found += static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; }));
    if (head.size() > kLongestLine) break;
  }
  return head;
}

}  // namespace workbench
