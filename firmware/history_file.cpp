#include "firmware/history_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <iterator>
#include <utility>

#include "wire/byte_stream.hpp"
#include "wire/crc32.hpp"

namespace firmware {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic = {'S', 'B', 'H', 'F', 1, 0, 0, 0};
constexpr std::size_t kHeaderContent =
    kMagic.size() + wire::kMostLoops * (wire::kTagBytes + 4);
static_assert(kHeaderContent + wire::kChecksumBytes <= kHistoryHeader);

std::int64_t begin_of(int loop) {
  return static_cast<std::int64_t>(kHistoryHeader) +
         (loop - 1) * static_cast<std::int64_t>(kHistoryLoopBytes);
}

// Moves all `bytes` by pread or pwrite.
template <class Move, class Byte>
bool move_all(Move move, int file, std::span<Byte> bytes, std::int64_t offset) {
  while (!bytes.empty()) {
    const ssize_t count = move(file, bytes.data(), bytes.size(), offset);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    offset += count;
  }
  return true;
}

bool read_all(int file, std::span<std::uint8_t> out, std::int64_t offset) {
  return move_all(::pread, file, out, offset);
}

bool write_all(int file, std::span<const std::uint8_t> data, std::int64_t offset) {
  return move_all(::pwrite, file, data, offset);
}

// `a` was written after `b`, of a ring that holds fewer than 32,768.
bool after(std::uint16_t a, std::uint16_t b) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(a - b)) > 0;
}

}  // namespace

HistoryFile::HistoryFile(std::string path)
    : path_(std::move(path)),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

void HistoryFile::reserve(std::int64_t size) const {
  constexpr std::int64_t kBlock = 512;  // of st_blocks
  struct stat about {};
  if (fstat(file_.get(), &about) == 0 && about.st_blocks * kBlock >= size) return;
  (void)posix_fallocate(file_.get(), 0, size);
}

HistoryFile::Opened HistoryFile::open(std::span<const HistoryLoop> loops) {
  Opened result = Opened::kGood;
  for (int tries = 0; tries < 2; ++tries) {
    file_ = hal::Descriptor(::open(
        path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600));
    if (!file_.valid()) return Opened::kFailed;
    if (flock(file_.get(), LOCK_EX | LOCK_NB) != 0) {
      return errno == EWOULDBLOCK ? Opened::kTaken : Opened::kFailed;
    }
    struct stat about {};
    if (fstat(file_.get(), &about) != 0) return Opened::kFailed;
    if (about.st_size == 0) {
      if (result == Opened::kGood) result = Opened::kNew;
      break;
    }
    if (read_header()) break;
    result = Opened::kDamaged;
    (void)std::rename(path_.c_str(), (path_ + ".bad").c_str());
  }
  std::array<bool, wire::kMostLoops> marks{};
  int last = 0;
  for (const HistoryLoop& loop : loops) {
    const auto at = static_cast<std::size_t>(loop.id) - 1;
    HistoryLoop& known = known_[at];
    last = std::max(last, loop.id);
    if (known.tag != loop.tag && !clear(loop.id)) return Opened::kFailed;
    marks[at] = known.tag == loop.tag && known.configuration != loop.configuration;
    known = loop;
    find_ends(loop.id);
  }
  // What is reserved now cannot be missing later; where that is unknown, it may.
  reserve(begin_of(last + 1));
  if (!write_header()) return Opened::kFailed;
  for (const HistoryLoop& loop : loops) {
    const auto at = static_cast<std::size_t>(loop.id) - 1;
    if (!marks[at]) continue;
    wire::HistoryRow mark;
    mark.time_s = rings_[at][0].newest_s;
    add(loop.id, mark);
  }
  return result;
}

bool HistoryFile::open_to_read() {
  file_ = hal::Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  errno = file_.valid() ? 0 : errno;
  return file_.valid() && read_header();
}

bool HistoryFile::read_header() {
  std::array<std::uint8_t, kHeaderContent + 4> header;
  if (!read_all(file_.get(), header, 0)) return false;
  wire::ByteReader in(header);
  const bool ours = std::ranges::equal(in.bytes(kMagic.size()), kMagic);
  const auto content = std::span(header).first<kHeaderContent>();
  if (!ours ||
      wire::get_big_endian(std::span(header).last<4>()) != wire::crc32(content)) {
    return false;
  }
  for (std::size_t k = 0; k < known_.size(); ++k) {
    const auto tag = in.bytes(wire::kTagBytes);
    const auto end = std::ranges::find(tag, std::uint8_t{0});
    known_[k] = {static_cast<int>(k) + 1, std::string(tag.begin(), end),
                 static_cast<std::uint32_t>(in.number(4))};
  }
  return true;
}

bool HistoryFile::write_header() {
  std::array<std::uint8_t, kHistoryHeader> header{};
  wire::ByteWriter out(header);
  out.bytes(kMagic);
  for (const HistoryLoop& loop : known_) {
    std::array<std::uint8_t, wire::kTagBytes> tag{};
    std::copy_n(loop.tag.begin(), std::min(loop.tag.size(), tag.size()), tag.begin());
    out.bytes(tag);
    out.number(loop.configuration, 4);
  }
  out.number(wire::crc32(std::span(header).first<kHeaderContent>()), 4);
  std::array<std::uint8_t, kHistoryHeader> there;
  if (read_all(file_.get(), there, 0) && there == header) return true;
  return write_all(file_.get(), header, 0) && fdatasync(file_.get()) == 0;
}

bool HistoryFile::clear(int loop) const {
  const std::vector<std::uint8_t> zeros(kHistoryLoopBytes);
  return write_all(file_.get(), zeros, begin_of(loop));
}

void HistoryFile::read(int loop, std::size_t offset, std::span<std::uint8_t> out) const {
  if (!read_all(file_.get(), out, begin_of(loop) + static_cast<std::int64_t>(offset))) {
    std::ranges::fill(out, std::uint8_t{0});
  }
}

void HistoryFile::find_ends(int loop) {
  std::vector<std::uint8_t> bytes(kHistoryLoopBytes);
  read(loop, 0, bytes);
  std::size_t first = 0;
  for (std::size_t k = 0; k < kHistoryRings.size(); ++k) {
    Ring ring;
    for (std::size_t i = 0; i < kHistoryRings[k].rows; ++i) {
      wire::HistoryRow row;
      const auto at = std::span(bytes).subspan((first + i) * wire::kHistoryRowBytes);
      if (!wire::decode_history_head(at.first<wire::kHistoryRowBytes>(), row)) continue;
      if (!ring.empty && !after(row.sequence, ring.sequence)) continue;
      ring = {(i + 1) % kHistoryRings[k].rows, row.sequence, row.time_s, false};
    }
    rings_[static_cast<std::size_t>(loop) - 1][k] = ring;
    first += kHistoryRings[k].rows;
  }
}

std::vector<HistoryLoop> HistoryFile::loops() const {
  std::vector<HistoryLoop> out;
  std::copy_if(known_.begin(), known_.end(), std::back_inserter(out),
               [](const HistoryLoop& loop) { return !loop.tag.empty(); });
  return out;
}

std::vector<wire::HistoryRow> HistoryFile::rows(int loop) const {
  std::vector<std::uint8_t> bytes(kHistoryLoopBytes);
  read(loop, 0, bytes);
  std::vector<wire::HistoryRow> rows(kHistoryRows);
  rows.resize(wire::read_history(bytes, rows));
  return rows;
}

void HistoryFile::add(int loop, wire::HistoryRow row) {
  auto& rings = rings_[static_cast<std::size_t>(loop) - 1];
  std::size_t first = 0;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    Ring& ring = rings[k];
    const std::size_t begin = std::exchange(first, first + kHistoryRings[k].rows);
    const bool mark = row.verdict == wire::LoopVerdict::kNotEvaluated;
    const bool soon = !ring.empty && !mark && row.time_s >= ring.newest_s &&
                      row.time_s - ring.newest_s < kHistoryRings[k].apart_s;
    if (soon) continue;
    if (queue_.size == kQueue) {
      ++lost_;
      continue;
    }
    row.sequence = ++ring.sequence;
    Pending& pending = queue_.rows[queue_.size++];
    pending.offset = begin_of(loop) + static_cast<std::int64_t>((begin + ring.next) *
                                                                wire::kHistoryRowBytes);
    wire::encode_history_row(row, pending.bytes);
    ring.next = (ring.next + 1) % kHistoryRings[k].rows;
    ring.newest_s = row.time_s;
    ring.empty = false;
  }
}

bool HistoryFile::write() {
  const std::lock_guard lock(mutex_);
  if (busy_) return false;
  if (queue_.size > 0) hand_over();
  return true;
}

// With the lock, while the thread is idle.
void HistoryFile::hand_over() {
  std::copy_n(queue_.rows.begin(), queue_.size, writing_.rows.begin());
  writing_.size = std::exchange(queue_.size, 0);
  busy_ = true;
  changed_.notify_all();
}

void HistoryFile::settle() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !busy_; });
}

void HistoryFile::finish() {
  settle();
  (void)write();
  settle();
}

std::uint32_t HistoryFile::writes() const {
  const std::lock_guard lock(mutex_);
  return writes_;
}

std::uint32_t HistoryFile::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_ + lost_;
}

bool HistoryFile::write_rows(const Queue& queue) const {
  for (const Pending& row : std::span(queue.rows).first(queue.size)) {
    if (!write_all(file_.get(), row.bytes, row.offset)) return false;
  }
  return fdatasync(file_.get()) == 0;
}

void HistoryFile::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, stop, [this] { return busy_; });
    if (!busy_) return;
    lock.unlock();
    const bool good = write_rows(writing_);
    lock.lock();
    ++writes_;
    failures_ += good ? 0 : 1;
    busy_ = false;
    changed_.notify_all();
  }
}

}  // namespace firmware
