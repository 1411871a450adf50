#include <limits>

#include "wire/dbc.hpp"
#include "wire/decimal.hpp"
#include "wire/text.hpp"

namespace wire {
namespace {

constexpr std::uint32_t kExtendedBit = 0x80000000;
// CANdb++ keeps signals without a message under this name, with an impossible id.
constexpr std::string_view kOrphans = "VECTOR__INDEPENDENT_SIG_MSG";

constexpr bool is_number_part(char c) {
  return is_digit(c) || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
}
constexpr bool ends_name(char c) {
  return is_blank(c) || is_line_end(c) ||
         std::string_view(":|@\"(),;[]").find(c) != std::string_view::npos;
}

bool parse_unsigned(std::string_view digits, std::uint32_t& value) {
  if (digits.empty()) return false;
  std::uint64_t total = 0;
  for (const char c : digits) {
    if (!is_digit(c)) return false;
    total = total * 10 + static_cast<std::uint64_t>(c - '0');
    if (total > std::numeric_limits<std::uint32_t>::max()) return false;
  }
  value = static_cast<std::uint32_t>(total);
  return true;
}

}  // namespace

class Dbc::Parser {
 public:
  Parser(Dbc& dbc, std::string_view text) : dbc_(dbc), text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  DbcStatus parse() {
    while (!at_end()) {
      skip_blanks();
      DbcStatus status;
      if (!at_line_end()) {
        const std::string_view keyword = take_name();
        if (keyword == "BO_") {
          status = message();
        } else if (keyword == "SG_") {
          status = signal();
        } else if (keyword == "SIG_VALTYPE_") {
          status = value_type();
        } else if (keyword == "SG_MUL_VAL_") {
          status = multiplex_ranges();
        }
      }
      if (status.ok()) status = finish_line();
      if (!status.ok()) return status;
    }
    if (dbc_.message_count_ == 0) return {DbcError::kNoMessage, 0, 0, {}, {}};
    return {};
  }

 private:
  [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
  [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[at_]; }
  [[nodiscard]] bool at_comment() const { return slice(text_, at_, 2) == "//"; }
  [[nodiscard]] bool at_line_end() const {
    return at_end() || is_line_end(text_[at_]) || at_comment();
  }

  void skip_blanks() {
    while (!at_end() && is_blank(text_[at_])) ++at_;
  }
  bool accept(char c) {
    skip_blanks();
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  template <class Predicate>
  std::string_view take_while(Predicate belongs) {
    skip_blanks();
    const std::size_t start = at_;
    while (!at_end() && belongs(text_[at_])) ++at_;
    return slice(text_, start, at_ - start);
  }
  std::string_view take_name() {
    return take_while([](char c) { return !ends_name(c); });
  }
  bool take_unsigned(std::uint32_t& value) {
    const std::size_t before = at_;
    if (parse_unsigned(take_while(is_digit), value)) return true;
    at_ = before;
    return false;
  }
  bool take_decimal(double& value) {
    const std::size_t before = at_;
    if (parse_decimal(take_while(is_number_part), value)) return true;
    at_ = before;
    return false;
  }

  void new_line() {
    if (at_end()) return;
    const bool crlf =
        text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    at_ += crlf ? 2 : 1;
    ++line_;
    line_start_ = at_;
  }

  [[nodiscard]] DbcStatus fail(DbcError error) {
    skip_blanks();
    const std::size_t start = at_;
    std::size_t end = at_;
    while (end < text_.size() && !is_line_end(text_[end]) && end < start + 24) ++end;
    return {error,
            line_,
            static_cast<std::uint32_t>(start - line_start_) + 1,
            slice(text_, start, end - start),
            {}};
  }

  // Passes over a string; line breaks inside are counted.
  DbcStatus skip_string(std::string_view* content = nullptr) {
    const DbcStatus open = fail(DbcError::kOpenString);
    const std::size_t start = ++at_;
    while (!at_end() && text_[at_] != '"') {
      if (is_line_end(text_[at_])) {
        new_line();
      } else {
        at_ += slice(text_, at_, 2) == "\\\"" ? 2 : 1;
      }
    }
    if (at_end()) return open;
    if (content != nullptr) *content = slice(text_, start, at_ - start);
    ++at_;
    return {};
  }

  DbcStatus finish_line() {
    while (!at_line_end()) {
      if (text_[at_] == '"') {
        const DbcStatus status = skip_string();
        if (!status.ok()) return status;
      } else {
        ++at_;
      }
    }
    while (!at_end() && !is_line_end(text_[at_])) ++at_;
    new_line();
    return {};
  }

  DbcStatus message() {
    in_message_ = false;
    skip_blanks();
    const std::size_t id_at = at_;
    std::uint32_t id = 0;
    if (!take_unsigned(id)) return fail(DbcError::kMessageId);
    const std::string_view name = take_name();
    if (name.empty()) return fail(DbcError::kMessageName);
    if (!accept(':')) return fail(DbcError::kMessageColon);
    std::uint32_t length = 0;
    const std::size_t length_at = at_;
    if (!take_unsigned(length) || length > std::numeric_limits<std::uint16_t>::max()) {
      at_ = length_at;
      return fail(DbcError::kMessageLength);
    }
    in_message_ = true;
    orphans_ = name == kOrphans;
    if (orphans_) return {};
    const bool extended = (id & kExtendedBit) != 0;
    if ((id & ~kExtendedBit) > (extended ? kMaxExtendedId : kMaxStandardId)) {
      at_ = id_at;
      return fail(DbcError::kMessageId);
    }
    if (dbc_.message_count_ == dbc_.message_store_.size()) {
      return fail(DbcError::kTooManyMessages);
    }
    dbc_.message_store_[dbc_.message_count_++] = {
        name,     id & ~kExtendedBit,
        extended, static_cast<std::uint16_t>(length),
        line_,    static_cast<std::uint32_t>(dbc_.signal_count_),
        0};
    return {};
  }

  DbcStatus signal() {
    if (!in_message_) return fail(DbcError::kSignalOutsideMessage);
    DbcSignal out;
    out.line = line_;
    out.name = take_name();
    if (out.name.empty()) return fail(DbcError::kSignalName);
    skip_blanks();
    if (peek() != ':') {
      const std::size_t before = at_;
      if (!multiplexing(take_name(), out)) {
        at_ = before;
        return fail(DbcError::kMultiplexing);
      }
    }
    if (!accept(':')) return fail(DbcError::kSignalColon);

    if (const DbcStatus status = layout(out.signal); !status.ok()) return status;
    if (const DbcStatus status = scaling(out.signal); !status.ok()) return status;
    skip_blanks();
    if (peek() != '"') return fail(DbcError::kUnit);
    const DbcStatus status = skip_string(&out.unit);
    if (!status.ok() || orphans_) return status;

    if (dbc_.signal_count_ == dbc_.signal_store_.size()) {
      return fail(DbcError::kTooManySignals);
    }
    dbc_.signal_store_[dbc_.signal_count_++] = out;
    ++dbc_.message_store_[dbc_.message_count_ - 1].signals;
    return {};
  }

  // Start, length, byte order and sign.
  DbcStatus layout(Signal& s) {
    std::uint32_t start = 0;
    std::uint32_t length = 0;
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint16_t>::max();
    if (!take_unsigned(start) || start > kMost || !accept('|')) {
      return fail(DbcError::kStart);
    }
    if (!take_unsigned(length) || length > kMost || !accept('@')) {
      return fail(DbcError::kLength);
    }
    s.start = static_cast<std::uint16_t>(start);
    s.length = static_cast<std::uint16_t>(length);
    skip_blanks();
    if (peek() != '0' && peek() != '1') return fail(DbcError::kByteOrder);
    s.byte_order = accept('0') ? ByteOrder::kBigEndian : ByteOrder::kLittleEndian;
    if (s.byte_order == ByteOrder::kLittleEndian) ++at_;
    s.is_signed = accept('-');
    if (!s.is_signed && !accept('+')) return fail(DbcError::kSign);
    return {};
  }

  // Scale, offset and limits.
  DbcStatus scaling(Signal& s) {
    if (!accept('(')) return fail(DbcError::kScaleOffset);
    skip_blanks();
    const std::size_t scale_at = at_;
    if (!take_decimal(s.scale) || !accept(',') || !take_decimal(s.offset) ||
        !accept(')')) {
      return fail(DbcError::kScaleOffset);
    }
    if (s.scale == 0) {
      at_ = scale_at;
      return fail(DbcError::kScaleOffset);
    }
    if (!accept('[') || !take_decimal(s.minimum) || !accept('|') ||
        !take_decimal(s.maximum) || !accept(']')) {
      return fail(DbcError::kLimits);
    }
    return {};
  }

  static bool multiplexing(std::string_view text, DbcSignal& out) {
    if (text == "M") {
      out.multiplexing = Multiplexing::kMultiplexor;
      return true;
    }
    if (!text.starts_with('m')) return false;
    text.remove_prefix(1);
    const bool nested = text.ends_with('M');
    if (nested) text.remove_suffix(1);
    out.multiplexing = nested ? Multiplexing::kNested : Multiplexing::kMultiplexed;
    return parse_unsigned(text, out.multiplex_value);
  }

  // The list of keywords under NS_ names these two without anything behind them.
  bool bare_keyword() {
    skip_blanks();
    return at_line_end();
  }

  DbcStatus value_type() {
    if (bare_keyword()) return {};
    std::uint32_t id = 0;
    if (!take_unsigned(id)) return fail(DbcError::kValueType);
    const std::string_view name = take_name();
    accept(':');
    std::uint32_t type = 0;
    const std::size_t before = at_;
    if (name.empty() || !take_unsigned(type) || type > 2) {
      at_ = before;
      return fail(DbcError::kValueType);
    }
    constexpr ValueType kTypes[] = {ValueType::kInteger, ValueType::kFloat32,
                                    ValueType::kFloat64};
    if (DbcSignal* target = dbc_.stored_signal(id, name)) {
      target->signal.type = kTypes[type];
    }
    return {};
  }

  DbcStatus multiplex_ranges() {
    if (bare_keyword()) return {};
    std::uint32_t id = 0;
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    if (!take_unsigned(id)) return fail(DbcError::kMultiplexRange);
    const std::string_view name = take_name();
    const std::string_view multiplexor = take_name();
    if (name.empty() || multiplexor.empty() || !take_unsigned(from) || !accept('-') ||
        !take_unsigned(to)) {
      return fail(DbcError::kMultiplexRange);
    }
    if (DbcSignal* target = dbc_.stored_signal(id, name)) {
      const DbcSignal* selector = dbc_.stored_signal(id, multiplexor);
      skip_blanks();
      target->has_ranges |= from != to || from != target->multiplex_value ||
                            peek() == ',' || selector == nullptr ||
                            selector->multiplexing != Multiplexing::kMultiplexor;
    }
    return {};
  }

  Dbc& dbc_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  std::size_t line_start_ = 0;
  bool in_message_ = false;
  bool orphans_ = false;
};

DbcStatus Dbc::parse(std::string_view text) {
  message_count_ = 0;
  signal_count_ = 0;
  return Parser(*this, text).parse();
}

DbcSignal* Dbc::stored_signal(std::uint32_t raw_id, std::string_view name) {
  const bool extended = (raw_id & kExtendedBit) != 0;
  for (const DbcMessage& message : messages()) {
    if (message.id != (raw_id & ~kExtendedBit) || message.extended != extended) continue;
    for (DbcSignal& s : signal_store_.subspan(message.first_signal, message.signals)) {
      if (s.name == name) return &s;
    }
  }
  return nullptr;
}

}  // namespace wire
