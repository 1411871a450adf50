// Rations what is written to the disk, which is flash and wears: the state, the windows
// and the history together.
//
// A write is one file replaced, or one batch of rows, with its wait for the disk. In any
// hour there are at most as many as the constructor is told. One is earned at a time; up
// to kMost are saved up, so that a flag that is raised can be written at once:
//
//   haste     taken where there are     or after waiting for
//   kNow      1 earned                  –
//   kSoon     kSoonNeeds                kSoonWaits times what earning one takes
//   kLater    kMost                     kLaterWaits times that
//
// Of several that may be taken the one that has waited longest is, so that nobody is kept
// from writing by another one, whatever that one does.
//
// Life: new → may_write, for each file, at every turn. One thread; no heap or clock.
// Cost: constant.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace firmware {

enum class Written : std::uint8_t { kState, kWindows, kHistory };

enum class Haste : std::uint8_t { kNone, kLater, kSoon, kNow };

class WriteBudget {
 public:
  static constexpr int kMost = 5;
  static constexpr int kAtStart = 2;
  static constexpr int kSoonNeeds = 3;
  static constexpr int kSoonWaits = 2;
  static constexpr int kLaterWaits = 5;
  static constexpr int kLeastAnHour = 2 * kMost;

  /// `an_hour`: kLeastAnHour or more.
  explicit WriteBudget(int an_hour) { set(an_hour); }
  /// From now on; who waited begins to wait anew.
  void set(int an_hour);

  /// How urgently there is something to be written; true: it is to be written now.
  [[nodiscard]] bool may_write(Written file, Haste haste, std::int64_t now_us);
  /// So many have failed, or were not needed: the disk is as it was.
  void give_back(int count);

 private:
  static constexpr std::size_t kFiles = 3;
  struct Waiting {
    Haste haste = Haste::kNone;
    std::int64_t since_us = 0;
  };
  void earn(std::int64_t now_us);
  [[nodiscard]] bool ripe(const Waiting& waiting, std::int64_t now_us) const;

  std::array<Waiting, kFiles> waiting_{};
  std::int64_t every_us_ = 0;  // one is earned
  std::int64_t last_us_ = 0;   // of the time that has earned
  int credit_ = kAtStart;
  bool started_ = false;
};

}  // namespace firmware
