// Many streams of text in one temporary file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace workbench {

/// What one pass over a file writes, sorted by stream: a table that is too wide for the
/// memory becomes one narrow text for each of its loops, at the cost of writing what is
/// wanted once and reading it once. Passes over the file for batches of columns would
/// cost no disk, but a file of 20 GB some hundred passes in the same memory.
///
/// The file has no name, so that nothing of it is left when the program is killed. Life:
/// add_stream … → buffer(stream) and flush_full, in one thread → finish → text(stream),
/// from any number of threads.
class Spill {
 public:
  /// Buffers take about `memory` bytes together. `folder`: where the file goes, "": the
  /// system's folder for temporary files. Throws std::runtime_error.
  explicit Spill(const std::string& folder, std::size_t memory = std::size_t{64} << 20);
  ~Spill();
  Spill(const Spill&) = delete;
  Spill& operator=(const Spill&) = delete;

  std::size_t add_stream();
  [[nodiscard]] std::size_t streams() const { return streams_.size(); }
  /// What is appended here belongs to the stream; empty after a flush.
  [[nodiscard]] std::string& buffer(std::size_t stream) {
    return streams_[stream].buffer;
  }
  /// Writes the buffers that are full. Throws std::runtime_error where the disk is.
  void flush_full();
  /// Writes all of them and frees them.
  void finish();

  [[nodiscard]] std::uint64_t size(std::size_t stream) const;
  /// All of a stream, once finished. Throws std::runtime_error.
  [[nodiscard]] std::string text(std::size_t stream) const;

 private:
  struct Extent {
    std::uint64_t at;
    std::uint64_t bytes;
  };
  struct Stream {
    std::string buffer;
    std::vector<Extent> extents;
  };
  void flush(Stream& stream);

  std::size_t memory_;
  std::string folder_;
  int file_ = -1;
  std::uint64_t end_ = 0;
  std::vector<Stream> streams_;
};

}  // namespace workbench
