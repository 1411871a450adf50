#include "wire/candump.hpp"

#include <algorithm>
#include <limits>

#include "wire/text.hpp"

namespace wire {
namespace {

constexpr std::uint32_t kErrorFlag = 0x20000000;
constexpr int kBitRateSwitch = 1;  // flags of CAN FD
constexpr int kErrorState = 2;
constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr int kMaxDecimals = 9;
constexpr std::size_t kEpochDigits = 10;  // of seconds since 1970, as -t a writes
constexpr std::int64_t kMaxSeconds =
    std::numeric_limits<std::int64_t>::max() / kNsPerSecond - 1;

class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}
  [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  char take() { return text_[at_++]; }
  bool accept(char c) {
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::size_t skip_blanks() {
    const std::size_t before = at_;
    while (!at_end() && is_blank(text_[at_])) ++at_;
    return at_ - before;
  }
  [[nodiscard]] std::size_t position() const { return at_; }
  [[nodiscard]] std::string_view since(std::size_t start) const {
    return slice(text_, start, at_ - start);
  }
  [[nodiscard]] CandumpStatus fail(CandumpError error) const { return {error, at_ + 1}; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

bool take_time(Cursor& cursor, std::int64_t& time_ns) {
  if (!is_digit(cursor.peek())) return false;
  std::int64_t seconds = 0;
  while (is_digit(cursor.peek())) {
    if (seconds > kMaxSeconds / 10) return false;
    seconds = seconds * 10 + (cursor.take() - '0');
  }
  if (seconds > kMaxSeconds) return false;
  std::int64_t fraction = 0;
  if (cursor.accept('.')) {
    int digits = 0;
    for (; is_digit(cursor.peek()) && digits < kMaxDecimals; ++digits) {
      fraction = fraction * 10 + (cursor.take() - '0');
    }
    if (digits == 0) return false;
    for (; digits < kMaxDecimals; ++digits) fraction *= 10;
  }
  time_ns = seconds * kNsPerSecond + fraction;
  return true;
}

bool take_identifier(Cursor& cursor, CanFrame& frame, int& digits) {
  std::uint32_t id = 0;
  for (digits = 0; digits < 8 && hex_value(cursor.peek()) >= 0; ++digits) {
    id = id << 4 | static_cast<std::uint32_t>(hex_value(cursor.take()));
  }
  if (digits == 3) {
    frame.id = id;
    return id <= kMaxStandardId;
  }
  frame.error = (id & kErrorFlag) != 0;
  frame.extended = !frame.error;
  frame.id = id & ~kErrorFlag;
  return digits == 8 && frame.id <= kMaxExtendedId;
}

// The raw DLC 9 … F that candump appends as `_9` to eight-byte frames.
bool take_raw_dlc(Cursor& cursor, const CanFrame& frame) {
  if (!cursor.accept('_')) return true;
  if (frame.dlc != kMaxClassicLength || hex_value(cursor.peek()) < 9) return false;
  cursor.take();
  return true;
}

CandumpStatus take_remote(Cursor& cursor, CanFrame& frame) {
  cursor.take();
  frame.remote = true;
  if (is_digit(cursor.peek())) {
    if (cursor.peek() > '8') return cursor.fail(CandumpError::kTooLong);
    frame.dlc = static_cast<std::uint8_t>(cursor.take() - '0');
  }
  return take_raw_dlc(cursor, frame) ? CandumpStatus{} : cursor.fail(CandumpError::kData);
}

CandumpStatus take_bytes(Cursor& cursor, CanFrame& frame) {
  const std::size_t most = frame.fd ? kMaxFdLength : kMaxClassicLength;
  while (hex_value(cursor.peek()) >= 0) {
    if (frame.dlc == most) return cursor.fail(CandumpError::kTooLong);
    const int high = hex_value(cursor.take());
    const int low = hex_value(cursor.peek());
    if (low < 0) return cursor.fail(CandumpError::kData);
    cursor.take();
    frame.data[frame.dlc++] = static_cast<std::uint8_t>(high << 4 | low);
    if (cursor.peek() == '.' && hex_value(cursor.peek(1)) >= 0) cursor.take();
  }
  return {};
}

CandumpStatus take_data(Cursor& cursor, CanFrame& frame) {
  if (cursor.peek() == 'R') return take_remote(cursor, frame);
  const CandumpStatus status = take_bytes(cursor, frame);
  if (!status.ok()) return status;
  return take_raw_dlc(cursor, frame) ? CandumpStatus{} : cursor.fail(CandumpError::kData);
}

void set_fd_flags(CanFrame& frame, int flags) {
  frame.fd = true;
  frame.brs = (flags & kBitRateSwitch) != 0;
  frame.esi = (flags & kErrorState) != 0;
}

// The flags and what follows them.
CandumpStatus take_fd_data(Cursor& cursor, CanFrame& frame) {
  const int flags = hex_value(cursor.peek());
  if (flags < 0) return cursor.fail(CandumpError::kFdFlags);
  cursor.take();
  if (frame.error) return take_bytes(cursor, frame);
  set_fd_flags(frame, flags);
  const CandumpStatus status = take_bytes(cursor, frame);
  if (!status.ok()) return status;
  return is_fd_length(frame.dlc) ? CandumpStatus{} : cursor.fail(CandumpError::kFdLength);
}

// The length in brackets: one digit, of CAN FD two, of CAN XL four.
CandumpStatus take_screen_length(Cursor& cursor, CanFrame& frame) {
  (void)cursor.accept('[');
  if (!is_digit(cursor.peek())) return cursor.fail(CandumpError::kData);
  if (is_digit(cursor.peek(1)) && is_digit(cursor.peek(2))) {
    return cursor.fail(CandumpError::kXlFrame);
  }
  frame.fd = is_digit(cursor.peek(1));
  const Cursor before = cursor;
  int length = cursor.take() - '0';
  if (frame.fd) length = 10 * length + cursor.take() - '0';
  if (frame.fd && (frame.error || !is_fd_length(static_cast<std::size_t>(length)))) {
    return before.fail(CandumpError::kFdLength);
  }
  if (!frame.fd && length > kMaxClassicLength) return before.fail(CandumpError::kTooLong);
  if (!cursor.accept(']')) return cursor.fail(CandumpError::kData);
  frame.dlc = static_cast<std::uint8_t>(length);
  return {};
}

// `[5]  2A 36 6C 2B BA`, and what may follow on a screen.
CandumpStatus take_screen_data(Cursor& cursor, CanFrame& frame) {
  const CandumpStatus status = take_screen_length(cursor, frame);
  if (!status.ok()) return status;
  cursor.skip_blanks();
  if (cursor.peek() == 'r' && !frame.fd) {
    frame.remote = true;  // "remote request"
    return {};
  }
  for (std::size_t k = 0; k < frame.dlc; ++k) {
    const int high = hex_value(cursor.peek());
    const int low = hex_value(cursor.peek(1));
    if (high < 0 || low < 0) return cursor.fail(CandumpError::kData);
    cursor.take();
    cursor.take();
    cursor.skip_blanks();
    frame.data[k] = static_cast<std::uint8_t>(high << 4 | low);
  }
  const bool comment =
      cursor.at_end() || cursor.peek() == '\'' || (frame.error && cursor.peek() == 'E');
  return comment ? CandumpStatus{} : cursor.fail(CandumpError::kTrailing);
}

class Writer {
 public:
  explicit Writer(std::span<char> out) : out_(out) {}
  void put(char c) {
    if (size_ < out_.size()) {
      out_[size_] = c;
      ++size_;
    } else {
      overflow_ = true;
    }
  }
  void put(std::string_view text) {
    for (const char c : text) put(c);
  }
  void decimal(std::uint64_t value, int digits) {
    std::uint64_t unit = 1;
    for (int i = 1; i < digits || value / unit >= 10; ++i) unit *= 10;
    for (; unit > 0; unit /= 10) put(static_cast<char>('0' + value / unit % 10));
  }
  void hex(std::uint32_t value, int digits) {
    for (int i = digits - 1; i >= 0; --i) put("0123456789ABCDEF"[value >> (4 * i) & 0xF]);
  }
  [[nodiscard]] std::size_t size() const { return overflow_ ? 0 : size_; }

 private:
  std::span<char> out_;
  std::size_t size_ = 0;
  bool overflow_ = false;
};

}  // namespace

const char* expected_at(CandumpError error) {
  switch (error) {
    case CandumpError::kNone:
      return "nothing else";
    case CandumpError::kTimeStart:
      return "'(' and a time, as candump -L writes";
    case CandumpError::kTime:
      return "seconds with up to nine decimals";
    case CandumpError::kTimeEnd:
      return "')' and a space after the time";
    case CandumpError::kInterface:
      return "an interface name and a space";
    case CandumpError::kIdentifier:
      return "a CAN identifier of 3 or 8 hex digits (up to 7FF or 1FFFFFFF) and '#'";
    case CandumpError::kData:
      return "data bytes as pairs of hex digits";
    case CandumpError::kTooLong:
      return "at most 8 data bytes, or 64 of CAN FD";
    case CandumpError::kTrailing:
      return "the end of the line";
    case CandumpError::kFdFlags:
      return "a hex digit of CAN FD flags after '##'";
    case CandumpError::kFdLength:
      return "0 to 8, 12, 16, 20, 24, 32, 48 or 64 data bytes of a CAN FD frame";
    case CandumpError::kXlFrame:
      return "a CAN or CAN FD frame";
  }
  return "a candump line";
}

CandumpStatus parse_candump(std::string_view line, CandumpLine& out) {
  while (!line.empty() && (is_blank(line.back()) || line.back() == '\r')) {
    line.remove_suffix(1);
  }
  out = {};
  Cursor cursor(line);
  cursor.skip_blanks();
  if (!cursor.accept('(')) return cursor.fail(CandumpError::kTimeStart);
  const std::size_t time = cursor.position();
  if (!take_time(cursor, out.time_ns)) return cursor.fail(CandumpError::kTime);
  const bool few_digits = cursor.since(time).find('.') < kEpochDigits;
  if (!cursor.accept(')') || cursor.skip_blanks() == 0) {
    return cursor.fail(CandumpError::kTimeEnd);
  }

  const std::size_t name = cursor.position();
  while (cursor.peek() > ' ' && cursor.peek() < 0x7F) cursor.take();
  out.interface = cursor.since(name);
  if (out.interface.empty() || out.interface.size() > kMaxInterfaceName ||
      cursor.skip_blanks() == 0) {
    return cursor.fail(CandumpError::kInterface);
  }

  int digits = 0;
  const std::size_t identifier = cursor.position();
  const bool id_ok = take_identifier(cursor, out.frame, digits);
  if (digits == 5 && cursor.peek() == '#') return cursor.fail(CandumpError::kXlFrame);
  if (!id_ok) return {CandumpError::kIdentifier, identifier + 1};
  if (Cursor ahead = cursor; ahead.skip_blanks() > 0 && ahead.peek() == '[') {
    out.relative = few_digits;
    return take_screen_data(ahead, out.frame);
  }
  if (!cursor.accept('#')) return cursor.fail(CandumpError::kIdentifier);
  const bool fd = cursor.accept('#');
  if (!fd && hex_value(cursor.peek(1)) >= 0 && cursor.peek(2) == ':') {
    return cursor.fail(CandumpError::kXlFrame);
  }
  const CandumpStatus status =
      fd ? take_fd_data(cursor, out.frame) : take_data(cursor, out.frame);
  if (!status.ok()) return status;

  if (cursor.at_end()) return {};
  if (cursor.skip_blanks() == 0) return cursor.fail(CandumpError::kData);
  if (!cursor.accept('R') && !cursor.accept('T')) {
    return cursor.fail(CandumpError::kTrailing);
  }
  return cursor.at_end() ? CandumpStatus{} : cursor.fail(CandumpError::kTrailing);
}

std::size_t format_candump(const CandumpLine& line, std::span<char> out) {
  const auto printable = [](char c) { return c > ' ' && c < 0x7F; };
  const std::string_view name = line.interface;
  if (!is_valid(line.frame) || line.time_ns < 0 || name.empty() ||
      name.size() > kMaxInterfaceName ||
      !std::all_of(name.begin(), name.end(), printable)) {
    return 0;
  }
  const CanFrame& frame = line.frame;
  const auto time = static_cast<std::uint64_t>(line.time_ns);
  const std::uint64_t fraction = time % kNsPerSecond;
  Writer writer(out);
  writer.put('(');
  writer.decimal(time / kNsPerSecond, 10);
  writer.put('.');
  if (fraction % 1000 == 0) {
    writer.decimal(fraction / 1000, 6);
  } else {
    writer.decimal(fraction, 9);
  }
  writer.put(") ");
  writer.put(name);
  writer.put(' ');
  if (frame.extended || frame.error) {
    writer.hex(frame.id | (frame.error ? kErrorFlag : 0), 8);
  } else {
    writer.hex(frame.id, 3);
  }
  writer.put(frame.fd ? "##" : "#");
  if (frame.fd) {
    writer.hex((frame.brs ? kBitRateSwitch : 0U) | (frame.esi ? kErrorState : 0U), 1);
  }
  if (frame.remote) {
    writer.put('R');
    if (frame.dlc > 0) writer.put(static_cast<char>('0' + frame.dlc));
  } else {
    for (std::size_t i = 0; i < frame.dlc; ++i) writer.hex(frame.data[i], 2);
  }
  return writer.size();
}

}  // namespace wire
