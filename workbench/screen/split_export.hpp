// One pass over a table with many loops, and then each of them as a recording.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"
#include "workbench/screen/export_file.hpp"
#include "workbench/screen/spill.hpp"

namespace workbench {

/// Life: new → split, once → recording(loop), from any number of threads. Reads about
/// 150 MB/s; memory 64 MiB besides the rows of the loops being read.
class SplitExport {
 public:
  /// Bytes read so far, of all; false ends the pass.
  using Watch = std::function<bool(std::uint64_t done, std::uint64_t all)>;

  SplitExport(ExportFile file, const ReadOptions& options, const std::string& scratch);

  /// `wanted`: of the loops of a wide file those whose rows are kept; empty: all. Throws
  /// InputError, and std::runtime_error where the disk is full. False: `watch` ended it.
  [[nodiscard]] bool split(const std::vector<bool>& wanted, const Watch& watch);

  [[nodiscard]] const ExportFile& file() const { return file_; }
  /// What `identify` reads with the columns of this loop named. Throws InputError.
  [[nodiscard]] Recording recording(std::size_t loop) const;

 private:
  // Gives take_row(reader, heads) each row; `heads`: it is the header once more, which
  // was passed over. False: `watch` ended it.
  template <class TakeRow>
  bool each_row(const Watch& watch, int between_flushes, TakeRow take_row);
  bool split_wide(const std::vector<bool>& wanted, const Watch& watch);
  bool split_long(const Watch& watch);
  void pair_streams(const std::vector<NamedSignal>& tags);
  [[nodiscard]] std::string joined(std::size_t loop) const;

  ExportFile file_;
  const ReadOptions& options_;
  Spill spill_;
  std::vector<std::size_t> stream_of_loop_;            // wide
  std::vector<std::vector<std::size_t>> tag_streams_;  // long: u, y, sp, x of each loop
};

}  // namespace workbench
