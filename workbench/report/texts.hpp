// The sentences of the program in another language.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace workbench {

/// With a capital first letter of ASCII or Latin-1.
[[nodiscard]] std::string capitalised(std::string text);

/// A table of sentences, English to another language, as serve/assets/texts has them and
/// the page reads them. What the table lacks stays English.
class Texts {
 public:
  /// Takes the entries of a table: the lines `  'English': 'other',` of a script, with
  /// `\'` and `\\` within. Later ones replace earlier ones of the same key; other lines
  /// are passed over.
  void take(std::string_view script);

  /// True without entries: every text stays as it is.
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// What the table has for this very key; the key where it lacks it.
  [[nodiscard]] std::string_view entry(std::string_view key) const;

  /// A text of the program, whole, as a list of names, or sentence by sentence, each with
  /// its gaps {0}, {1} … filled (recording/filled.hpp). Decimal points become the mark of
  /// the language; white space around the text stays. O(entries · length).
  [[nodiscard]] std::string translated(std::string_view text) const;

 private:
  struct Entry {
    std::string key;
    std::string other;
  };
  // A sentence with gaps: pieces[0] {gaps[0]} pieces[1] {gaps[1]} … pieces.back().
  struct Pattern {
    std::vector<std::string> pieces;
    std::vector<std::size_t> gaps;
    std::size_t fixed = 0;  // characters outside of gaps
    bool words = false;     // gaps take single words, or it would fit almost anything
    std::size_t entry = 0;
  };

  void add_pattern(std::size_t entry);
  [[nodiscard]] const std::string* find(std::string_view key) const;
  [[nodiscard]] bool known(std::string_view bare, std::string& out) const;
  [[nodiscard]] bool filled_in(const Pattern& pattern, std::string_view bare,
                               std::string& out) const;
  [[nodiscard]] bool listed(std::string_view bare, std::string& out) const;
  [[nodiscard]] std::string in_turn(std::string_view bare) const;
  [[nodiscard]] std::string with_mark(std::string_view text) const;

  std::vector<Entry> entries_;
  std::unordered_map<std::string, std::size_t> places_;
  std::vector<Pattern> patterns_;  // longest first
};

}  // namespace workbench
