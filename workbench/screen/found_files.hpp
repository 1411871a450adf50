// The files that the paths of a command line mean.
#pragma once

#include <string>
#include <vector>

namespace workbench {

/// A path that leads to no file.
struct PathProblem {
  std::string path;
  std::string what;  ///< expected, found, what to do
};

struct FoundFiles {
  std::vector<std::string> files;  ///< sorted, each once
  std::vector<PathProblem> problems;
  /// In folders with recordings: of other kinds, not read; sorted, each once.
  std::vector<std::string> passed_over;
};

/// At most eight of these files by name, for a line: "a.log, b.dbc and 3 more".
[[nodiscard]] std::string names_of_some(const std::vector<std::string>& files);

/// Each of `paths` is a file, a folder (all recordings below it), a pattern with * ? [ ],
/// or @LIST: a text file that names one such path a line, from its own folder; lines that
/// begin with # are comments. In folders only endings of recordings count (csv, txt, tsv,
/// tab, asc, dat, lvm, xlsx, ods; capitals too), and names that begin with a dot do not.
/// Never throws for what a path names; a folder that may not be read is a problem.
[[nodiscard]] FoundFiles find_files(const std::vector<std::string>& paths);

/// The number that undated_name() takes off, tag_file.hpp; 0: none.
[[nodiscard]] int running_number(const std::string& path);

/// True for a name that is only a date or a number: 2024-03, 2024, week_12, Jan-2024.
[[nodiscard]] bool is_date_like(const std::string& name);

}  // namespace workbench
