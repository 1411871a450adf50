// Which files and tags of an archive make which loop.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "workbench/screen/export_file.hpp"
#include "workbench/screen/screened_loop.hpp"

namespace workbench {

/// One recording of a loop: a file, a loop of a table with many, or files of one signal
/// each.
struct PartOfLoop {
  static constexpr std::size_t kWholeFile = static_cast<std::size_t>(-1);
  std::size_t file = 0;             ///< index of an ExportFile
  std::size_t loop = kWholeFile;    ///< of its `loops`
  std::vector<std::size_t> beside;  ///< files of its other signals
};

/// A loop that is to be identified.
struct LoopTask {
  std::string name;
  std::string u_tag;  ///< where its signals are tags; "" a file of its own
  std::string y_tag;
  std::vector<PartOfLoop> parts;
};

struct LoopTasks {
  std::vector<LoopTask> tasks;
  std::vector<ScreenedLoop> errors;   ///< what makes no loop, and why
  std::vector<std::string> unpaired;  ///< "FILE: TAG"
};

/// Recordings are one loop where they have one tag or, without tags, one name
/// (undated_name), in one folder or in folders named by dates; with `pool` false each is
/// its own. Files of one signal each are paired within their folder (tag_pairs.hpp).
/// `broken`: files that are left out, and why.
[[nodiscard]] LoopTasks make_tasks(const std::vector<ExportFile>& files,
                                   const std::map<std::size_t, std::string>& broken,
                                   const PairRules& pairs, bool pool);

/// Folder of `path`; with `pool` without parts that only date it.
[[nodiscard]] std::string folder_of(const std::string& path, bool pool);

/// A loop without an answer.
[[nodiscard]] ScreenedLoop failed(const std::string& name, std::vector<std::string> files,
                                  const std::string& why);

/// What tells whether a task is what it was: its files, their sizes and dates, its tags,
/// and how they are read.
[[nodiscard]] std::string key_of(const LoopTask& task,
                                 const std::vector<ExportFile>& files,
                                 const ReadOptions& read);

}  // namespace workbench
