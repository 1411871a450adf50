// Historians that write a file for each tag: which they are, and one table of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/column_choice.hpp"
#include "workbench/recording/csv.hpp"

namespace workbench {

/// The one signal of a file, and where it stands.
struct TagFile {
  std::string tag;  ///< "FIC101.OP", with its unit where one is known: "FIC101.OP [%]"
  TimePlace time;
  std::string time_name;  ///< with its unit
  std::size_t value = 0;  ///< index of the column, as the next
  std::optional<std::size_t> quality;
};

/// The signal of a file of `layout` that holds only one beside its times; nothing where
/// it holds none or several. Its name is that of its column or of the only tag of a long
/// format, unless that says nothing (Value) or no part (FIC101) where the name of the
/// file, without what dates it, does: FIC101.OP.csv. `names.time` may name the column of
/// times. Never throws.
[[nodiscard]] std::optional<TagFile> tag_file(const CsvLayout& layout,
                                              const std::string& path,
                                              const ColumnNames& names);

/// The same for a whole text, or its first lines.
[[nodiscard]] std::optional<TagFile> tag_file(std::string_view bytes,
                                              const std::string& path,
                                              const CsvOptions& options);

/// Whether each of the files, at least two, holds one signal. False for one that cannot
/// be read.
[[nodiscard]] bool are_tag_files(const std::vector<std::string>& paths,
                                 const CsvOptions& options);

/// A file and what it holds.
struct NamedBytes {
  std::string path;
  std::string bytes;
};

/// The files as one table in long format (Tag, Time, Value, perhaps Quality), which
/// parse_csv() reads without `names.time`. Throws InputError for a file that holds not
/// just one signal. Memory: the table, about twice that of the files.
[[nodiscard]] std::string table_of_tag_files(const std::vector<NamedBytes>& files,
                                             const CsvOptions& options);

/// The files of these names in one word, for a recording: "FIC101.OP.csv +
/// FIC101.PV.csv".
[[nodiscard]] std::string name_of_files(const std::vector<std::string>& names);
/// The names in such a word; a name of one file, each of whose parts does not end as a
/// file does, is one.
[[nodiscard]] std::vector<std::string> files_in(const std::string& name);

/// `path` without its folders, its ending, and what numbers or dates it as one of several
/// recordings of a loop: FIC-101_2024-03.csv and FIC-101-2.csv are FIC-101. A trailing
/// number counts only where it is at most two digits behind a name that holds a digit of
/// its own, so that FIC-101 stays FIC-101.
[[nodiscard]] std::string undated_name(const std::string& path);

}  // namespace workbench
