#include "config/dbc_file.hpp"

#include <algorithm>
#include <sstream>

#include "wire/j1939.hpp"

namespace config {
namespace {

constexpr std::size_t kLongestList = 200;

std::string quoted(std::string_view text) {
  std::string out(text.substr(0, 40));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + out + '"';
}

template <class List>
std::string names_of(const List& list) {
  std::string names;
  for (const auto& item : list) {
    if (names.size() < kLongestList)
      names += (names.empty() ? "" : ", ") + quoted(item.name);
  }
  return names.empty() ? "none" : names;
}

}  // namespace

DbcFile::DbcFile(std::string text, std::string name)
    : text_(std::move(text)), name_(std::move(name)), storage_(text_) {
  if (!storage_.status().ok()) explain(storage_.status());
}

bool DbcFile::find(const std::string& reference, wire::FrameSignal& out) {
  const wire::DbcStatus status = content().find(reference, out);
  if (!status.ok()) explain(status);
  misses_message_ = status.error == wire::DbcError::kUnknownMessage;
  return status.ok();
}

bool DbcFile::find_spn(std::uint32_t pgn, std::uint32_t spn, wire::FrameSignal& out) {
  // BA_ "SPN" SG_ 2364540158 EngSpeed 190;
  constexpr std::string_view kHead = "BA_ \"SPN\" SG_ ";
  for (std::size_t at = text_.find(kHead); at != std::string::npos;
       at = text_.find(kHead, at + 1)) {
    std::istringstream line(text_.substr(at + kHead.size(), kLongestList));
    std::uint32_t id = 0;
    std::uint32_t number = 0;
    std::string signal;
    if (!(line >> id >> signal >> number) || number != spn) continue;
    id &= wire::kMaxExtendedId;
    if (wire::j1939::pgn_of(id) != pgn) continue;
    for (const wire::DbcMessage& message : content().messages()) {
      if (message.extended && message.id == id) {
        return find(std::string(message.name) + '.' + signal, out);
      }
    }
  }
  error_ = name_ + ": expected a signal with BA_ \"SPN\" " + std::to_string(spn) +
           " in a message of PGN " + std::to_string(pgn) +
           ", found none; name another, or lay the signal out by start and length";
  return false;
}

void DbcFile::explain(const wire::DbcStatus& status) {
  error_ = name_;
  if (status.line > 0) error_ += ':' + std::to_string(status.line);
  if (status.column > 0) error_ += ':' + std::to_string(status.column);
  if (status.error == wire::DbcError::kUnknownMessage) {
    error_ += ": expected a message " + quoted(status.found) + ", found " +
              names_of(content().messages()) + "; name one of these";
    return;
  }
  if (status.error == wire::DbcError::kUnknownSignal) {
    error_ += ": expected a signal " + quoted(status.found) + ", found ";
    for (const wire::DbcMessage& message : content().messages()) {
      if (message.line == status.line) error_ += names_of(content().signals_of(message));
    }
    error_ += "; name one of these";
    return;
  }
  error_ += std::string(": expected ") + wire::expected_at(status.error) + ", found " +
            (status.found.empty() ? std::string("nothing") : quoted(status.found));
  if (status.error == wire::DbcError::kLayout) {
    error_ += std::string(", of which ") + wire::describe(status.layout);
  }
  error_ += "; repair the DBC file there";
}

}  // namespace config
