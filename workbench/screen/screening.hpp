// Screens an archive: files in, a ranked list of loops out.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "workbench/screen/export_file.hpp"
#include "workbench/screen/found_files.hpp"
#include "workbench/screen/screened_loop.hpp"

namespace workbench {

struct ScreeningOptions {
  ReadOptions read;
  unsigned threads = 0;     ///< 0: as many as the machine has processors
  std::string scratch;      ///< folder for temporary files; "": the system's
  std::string journal;      ///< file that remembers finished loops; "": none
  bool pool = true;         ///< files named as parts of one loop are judged together
  double within_s = 0;      ///< after so many seconds no loop is begun; 0: no limit
  bool same_clock = false;  ///< times without dates count from one instant everywhere
};

/// How far it is.
struct ScreeningProgress {
  enum class Phase { kLooking, kSplitting, kIdentifying } phase = Phase::kLooking;
  std::uint64_t done = 0;  ///< files, bytes, or loops
  std::uint64_t all = 0;
  std::string at;  ///< file being split
};

struct Screening {
  std::vector<ScreenedLoop> loops;       ///< ranked: what costs most first, errors last
  std::vector<std::string> unpaired;     ///< "FILE: TAG", signals of no loop
  std::vector<std::string> passed_over;  ///< files in folders that were not read
  std::size_t readable = 0;              ///< loops with an answer
  std::size_t resumed = 0;               ///< of them from the journal
  std::size_t left_out = 0;              ///< loops not reached when it was stopped
  bool complete = true;
};

/// Finds the loops below `paths` (found_files.hpp, export_file.hpp), identifies each with
/// all its recordings (screen_loop.hpp), finds those that oscillate together (groups.hpp)
/// and ranks them. The result is the same for any number of threads.
///
/// loop_tasks.hpp says which recordings are one loop. Tables with many loops are split
/// first (split_export.hpp): that takes about as much temporary disk as
/// they are long. Memory: some 30 MB, 64 MB while a table is split, and for each thread
/// three times the rows of one loop.
///
/// With a journal, a loop whose files are what they were is not identified again. It is
/// written as loops are finished; one line each, so that a killed run loses no more than
/// what was going on. Remove it to begin anew.
///
/// `stop` may turn true at any time and from any thread or signal handler: what is
/// finished is the result then, `complete` false. `within_s` ends the splitting of a
/// table where it is; of the loops at least one is begun, and those that are begun are
/// finished. `watch` is called from one thread at a time. Throws what SplitExport and the
/// journal throw for a full disk; what is wrong with a file stands in the loop's `error`.
[[nodiscard]] Screening screen(
    const std::vector<std::string>& paths, const ScreeningOptions& options,
    const std::atomic<bool>& stop,
    const std::function<void(const ScreeningProgress&)>& watch);

/// Files that share loops with no others: what several machines can screen apart, each
/// with a journal, so that a last screening of all with the joined journals finds every
/// loop done. `loops`: 0 for a long table, whose tags are not known before it is read.
struct IndependentFiles {
  std::vector<std::string> files;
  std::uint64_t bytes = 0;
  std::size_t loops = 0;
};
struct ScreeningPlan {
  std::vector<IndependentFiles> sets;
  std::vector<PathProblem> problems;  ///< paths that lead to no file
};
[[nodiscard]] ScreeningPlan plan_screening(const std::vector<std::string>& paths,
                                           const ScreeningOptions& options);

}  // namespace workbench
