// What historians write where a value is missing or not to be trusted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace workbench {

/// Words of one column and how often each occurs.
class WordCounts {
 public:
  void add(std::string_view word);
  [[nodiscard]] std::size_t total() const { return total_; }
  /// "'Stale' 12, 'Last Known' 1, others 3": at most kMostWords words, in the order in
  /// which they came, each cut as quoted() does.
  [[nodiscard]] std::string list() const;

  static constexpr std::size_t kMostWords = 8;

 private:
  std::vector<std::pair<std::string, std::size_t>> words_;
  std::size_t total_ = 0;
};

/// True for a cell that says "no value": a gap, not a mistake. Known, without regard
/// to case, are
/// - words: OL, null, (null), none, n/a, NA, <NA>, <GATED>, \N, ND, N.D., N/D, n.c., s/d,
/// void, invalid, missing, unknown, unavailable, shutdown, off-line, off-scan,
///   ungültig, schlecht, Fehler, gestört, keine Daten, kein Wert; and `---`, `***`,
///   `???`, `+++`, of any length;
/// - whatever begins with Bad, No Data, No Good Data, No Result, I/O Timeout, Timeout,
///   Digital State, Pt Created, Scan, Comm, Out of Serv, Not Connect, Not Available, Not
///   Collect, Configure, Calc, Over Range, Under Range, Intf, Equip, Failed, Error, Arc,
///   Set to Bad, Access Denied, Resize to, or with `#` and a letter (#N/A, #DIV/0!, #NV);
/// - only in an `export_file`: NaN, -nan, 1.#QNAN, -1.#IND00, and single - * ? . marks.
/// - and marks of a column too narrow to print: `##`, `#####`.
/// Infinities are none of them.
[[nodiscard]] bool says_no_value(std::string_view cell, bool export_file);

/// True for `<600`, `>=95 %`: beyond what the instrument measures, and by how much is not
/// known.
[[nodiscard]] bool is_beyond(std::string_view cell);

/// True for what is_beyond(), for infinities (+INF, 1.#INF00), and for other words, which
/// a column of numbers may hold here and there where a value is missing: at least three
/// letters, more than digits, none of the digits in front, and no word for 0 or 1 but
/// OFF, which recorders write for a channel without a value. A number with a word of
/// says_no_value() behind it counts too: `45.2 (Bad)`. `12..3`, `1O` and `45.2*` are
/// typing mistakes.
[[nodiscard]] bool reads_as_word(std::string_view cell);

/// How far a quality cell lets its value count.
enum class Quality : std::uint8_t { kGood, kUncertain, kBad };

/// Quality cells of one signal. Words (quality_words.hpp): Good, OK, Valid, Bonne, 正常
/// are good, as are unknown ones, which are counted; Uncertain, Questionable and the like
/// uncertain; Bad, Poor, False, Mauvaise, 異常 and what says_no_value() bad. Numbers,
/// 0x80000000 too, are read on the scale that the whole column shows: OPC (192 good, 64
/// to 191 uncertain, below bad; beside 192 Ignition's 256 to 1023 are bad, too), OPC UA
/// (0 good, from 1073741824 uncertain, from 2147483648 bad; so are the negative numbers
/// that 32 bits with a sign make of these; where 192 is among them, 0 is bad), percent or
/// 1 good and 0 bad; where nine of ten are zeros, 0 is good and the others are bad.
class QualityScale {
 public:
  /// `marks_bad`: 1 and True mark what is bad (quality_words.hpp); a column with other
  /// numbers is none of qualities then.
  explicit QualityScale(bool marks_bad = false) : marks_bad_(marks_bad) {}
  /// Code of a cell, and the column remembers its range. An empty cell counts as good.
  [[nodiscard]] double add(std::string_view cell);
  /// What a code means, once all cells are added.
  [[nodiscard]] Quality meaning(double code) const;
  /// Words that are not known.
  [[nodiscard]] const WordCounts& unknown() const { return unknown_; }

 private:
  bool marks_bad_;
  bool flags_only_ = true;  // numbers are 0 and 1
  bool has_192_ = false;
  double most_ = 0;
  std::size_t zeros_ = 0;  // as numbers
  std::size_t cells_ = 0;  // that are not empty
  WordCounts unknown_;
};

}  // namespace workbench
