#include "firmware/history_keeper.hpp"

#include <cerrno>
#include <cstring>
#include <vector>

namespace firmware {

HistoryKeeper::HistoryKeeper(const config::History& settings, Log& log)
    : file_(settings.path), log_(log) {}

bool HistoryKeeper::open(Daemon& daemon, std::int64_t now_us) {
  using Opened = HistoryFile::Opened;
  std::vector<HistoryLoop> loops;
  for (std::size_t k = 0; k < daemon.loops().size(); ++k) {
    const MonitoredLoop& loop = daemon.loop(k);
    loops.push_back(
        {loop.configuration().id, loop.configuration().tag, loop.configuration_crc()});
  }
  const Opened opened = file_.open(loops);
  if (opened == Opened::kTaken) return false;
  usable_ = opened != Opened::kFailed;
  const char* path = file_.path().c_str();
  if (!usable_) {
    log_.print(now_us, Priority::kError, "%s: cannot be opened: %s; there is no history",
               path, std::strerror(errno));
    return true;
  }
  if (opened == Opened::kDamaged) {
    log_.print(
        now_us, Priority::kError,
        "%s: expected a history, found another or a damaged file; begun anew, kept "
        "as .bad",
        path);
  }
  for (std::size_t k = 0; k < loops.size(); ++k) {
    daemon.recall(k, file_.rows(loops[k].id));
  }
  daemon.set_history(this);
  return true;
}

void HistoryKeeper::take(std::span<const LoopRow> rows) {
  if (!usable_) return;
  for (const LoopRow& row : rows) file_.add(row.loop, row.row);
}

void HistoryKeeper::keep(std::int64_t now_us, WriteBudget& budget) {
  if (!usable_) return;
  // Rows that do not fit would be lost.
  const std::size_t rows = file_.queued();
  const Haste haste = rows == 0                        ? Haste::kNone
                      : rows < HistoryFile::kQueue / 2 ? Haste::kLater
                                                       : Haste::kNow;
  if (budget.may_write(Written::kHistory, haste, now_us) && !file_.write()) {
    budget.give_back(1);
  }
  const std::uint32_t failures = file_.failures();
  if (failures > told_ && told_ == 0) {
    log_.print(now_us, Priority::kError, "%s: cannot be written; what came is lost",
               file_.path().c_str());
  }
  told_ = failures;
}

void HistoryKeeper::finish() {
  if (usable_) file_.finish();
}

std::uint32_t HistoryKeeper::failures() const {
  return file_.failures() + (usable_ ? 0 : 1);
}

std::uint32_t HistoryKeeper::begin(int loop) {
  if (!usable_) return 0;
  uploading_ = loop;
  return static_cast<std::uint32_t>(wire::kHistoryHeaderBytes + kHistoryLoopBytes);
}

void HistoryKeeper::read(std::uint32_t offset, std::span<std::uint8_t> out) {
  std::array<std::uint8_t, wire::kHistoryHeaderBytes> header{};
  wire::encode_history_header(static_cast<std::uint8_t>(uploading_),
                              static_cast<std::uint16_t>(kHistoryRows), header);
  std::size_t at = 0;
  for (; at < out.size() && offset + at < header.size(); ++at) {
    out[at] = header[offset + at];
  }
  if (at == out.size()) return;
  file_.read(uploading_, offset + at - header.size(), out.subspan(at));
}

}  // namespace firmware
