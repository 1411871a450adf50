// Keeps the history of all loops in its file (history_file.hpp), gives the daemon what it
// knew at the start, and who asks over the bus what is there.
//
// A file that cannot be opened is told and counted; the daemon goes on without a history.
// Rows that could not be written are lost, told once, counted. No heap after open(), one
// thread beside its own.
#pragma once

#include <span>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "firmware/history_file.hpp"
#include "firmware/log.hpp"
#include "firmware/write_budget.hpp"

namespace firmware {

class HistoryKeeper final : public HistorySource {
 public:
  /// `log` outlives this object.
  HistoryKeeper(const config::History& settings, Log& log);

  /// Opens the file and gives `daemon` its rows, before its first step. False: another
  /// process has the file.
  [[nodiscard]] bool open(Daemon& daemon, std::int64_t now_us);
  void take(std::span<const LoopRow> rows);
  /// At every turn.
  void keep(std::int64_t now_us, WriteBudget& budget);
  /// Waits until nothing is being written any more.
  void settle() { file_.settle(); }
  /// At the end.
  void finish();
  /// Times that rows were written, those that failed included.
  [[nodiscard]] std::uint32_t writes() const { return file_.writes(); }
  /// Times that it could not be opened or written, and rows that were lost.
  [[nodiscard]] std::uint32_t failures() const;

  [[nodiscard]] std::uint32_t begin(int loop) override;
  void read(std::uint32_t offset, std::span<std::uint8_t> out) override;

 private:
  HistoryFile file_;
  Log& log_;
  bool usable_ = false;
  std::uint32_t told_ = 0;
  int uploading_ = 0;  // the loop
};

}  // namespace firmware
