// What a file of an archive holds: one loop, or many.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workbench/recording/column_choice.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/screen/tag_pairs.hpp"

namespace workbench {

/// How the files of a screening are read.
struct ReadOptions : CsvOptions {
  PairRules pairs;
};

/// One loop in a table with many.
struct ExportLoop {
  std::string name;
  std::string u_tag;  ///< as written: FIC101.OP
  std::string y_tag;
  ColumnChoice choice;           ///< columns counted in `layout`
  CsvLayout layout;              ///< of the narrow table of this loop
  std::vector<std::size_t> own;  ///< columns of the file, ascending, behind `shared`
  std::string error;             ///< why it cannot be read; then all above may be empty
};

/// A file as its first lines show it.
struct ExportFile {
  enum class Kind {
    kSingle,  ///< one loop, or what is no recording: `identify` reads it or says why not
    kWide,    ///< columns of several loops
    kLong,    ///< rows tag, time, value: the loops are known once it was read
  };
  std::string path;
  std::uint64_t bytes = 0;
  std::int64_t modified = 0;  ///< s, as the file system counts
  Kind kind = Kind::kSingle;
  bool named_by_file = true;          ///< `loop` is from the file's name, not its tags
  std::string loop;                   ///< kSingle: name of the loop
  std::string tag;                    ///< kSingle: of its only signal; "" it has more
  ColumnNames names;                  ///< kSingle: its columns, where rules named them
  CsvLayout layout;                   ///< of the file; kWide, kLong
  ColumnChoice choice;                ///< kLong
  std::vector<std::size_t> shared;    ///< kWide: columns that all loops need
  std::vector<ExportLoop> loops;      ///< kWide
  std::vector<std::string> unpaired;  ///< names of no loop
  std::vector<std::string> doubts;    ///< tags with two candidates for u or y
};

/// Looks at the first lines of a file, and walks on where a column of tags rests in them.
/// Never throws for what is in it. About 1 ms, with thousands of columns some seconds.
[[nodiscard]] ExportFile look_into(const std::string& path, const ReadOptions& options);

}  // namespace workbench
