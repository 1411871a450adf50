// The file that keeps the state of the gateway over a restart.
//
// save() only hands over a copy: a thread writes it, waits for the disk, renames it. The
// caller, who also has frames to read, never waits. Life: new (a thread is started, which
// takes no signals if the caller has blocked them) → read, once → save … → finish.
// No heap after construction. Memory: two images, the stack of the thread.
#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "hal/descriptor.hpp"
#include "wire/state_image.hpp"

namespace firmware {

class StateFile {
 public:
  explicit StateFile(std::string path);
  ~StateFile();
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  /// Takes the file for this process, by a lock on path.lock, until the object is gone.
  /// False: another one has it.
  [[nodiscard]] bool lock();
  /// The file as it is; `exists` tells one that is empty from none. False when it cannot
  /// be read (errno says why). What is longer than a state is cut off after one byte
  /// more.
  [[nodiscard]] bool read(std::vector<std::uint8_t>& out, bool& exists) const;
  /// Renames a file that is no state to path.bad, so that the next one does not replace
  /// it.
  void set_aside() const;
  /// Begins to write `image`; false while the one before is still being written.
  [[nodiscard]] bool save(std::span<const std::uint8_t> image);
  /// Writes `image` and waits for it: for the end.
  void finish(std::span<const std::uint8_t> image);

  /// Times that writing failed.
  [[nodiscard]] std::uint32_t failures() const;
  /// errno of the newest failure; 0 after a success.
  [[nodiscard]] int error() const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void work();

  std::string path_;
  hal::Descriptor lock_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::array<char, wire::kMostStateBytes> image_;
  std::size_t size_ = 0;  // > 0: to be written, or being written
  bool ended_ = false;
  std::uint32_t failures_ = 0;
  int error_ = 0;
  std::thread thread_;
};

}  // namespace firmware
