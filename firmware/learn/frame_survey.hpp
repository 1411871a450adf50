// What travels on a bus: for each identifier its rate, its length, which bytes change,
// and payloads enough to look for signals in them.
//
// Life: new → take, in order of time → read. Memory: at most kMostIds identifiers with
// kMostKept payloads each; of one that has more, every second is dropped, again and
// again, so that what is kept covers the whole time evenly.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "wire/can_frame.hpp"

namespace firmware {

/// All frames of one identifier.
struct SurveyedFrame {
  std::string bus;
  std::uint32_t id = 0;
  bool extended = false;
  bool fd = false;
  std::uint64_t count = 0;
  std::uint8_t shortest = 0;  ///< bytes
  std::uint8_t longest = 0;
  std::int64_t first_us = 0;
  std::int64_t last_us = 0;
  /// How often each byte was another one than in the frame before.
  std::array<std::uint64_t, wire::kMaxFdLength> changes{};
  std::vector<std::int64_t> time_us;   ///< of the payloads that are kept
  std::vector<wire::CanFrame> frames;  ///< these

  [[nodiscard]] double rate_hz() const;

  std::uint64_t stride = 1;  ///< one of so many frames is kept
  wire::CanFrame newest;
};

class FrameSurvey {
 public:
  static constexpr std::size_t kMostIds = 512;
  static constexpr std::size_t kMostKept = 4096;

  /// Remote and error frames are passed over.
  void take(const std::string& bus, std::int64_t t_us, const wire::CanFrame& frame);

  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  /// Frames of identifiers beyond kMostIds.
  [[nodiscard]] std::uint64_t passed_over() const { return passed_over_; }
  [[nodiscard]] double duration_s() const;
  /// By bus, then identifier.
  [[nodiscard]] std::vector<const SurveyedFrame*> all() const;

 private:
  using Key = std::tuple<std::string, bool, std::uint32_t>;

  std::map<Key, SurveyedFrame> known_;
  std::uint64_t frames_ = 0;
  std::uint64_t passed_over_ = 0;
  std::int64_t first_us_ = 0;
  std::int64_t last_us_ = 0;
};

}  // namespace firmware
