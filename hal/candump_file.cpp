#include "hal/candump_file.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

namespace hal {
CandumpFile::CandumpFile(std::string path, std::string interface, ReplayPace pace,
                         const Clock& clock)
    : path_(std::move(path)),
      interface_(std::move(interface)),
      pace_(pace),
      clock_(clock) {}

bool CandumpFile::open() {
  log_ = {};
  failed_ = pending_ = false;
  log_start_us_ = -1;
  real_start_us_ = clock_.realtime_us();
  text_.clear();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen(path_.c_str(), "rb"), std::fclose);
  struct stat about {};
  if (!file || fstat(fileno(file.get()), &about) != 0) {
    error_.set("%s: %s; name a candump log", path_.c_str(), std::strerror(errno));
    return false;
  }
  if (!S_ISREG(about.st_mode) || static_cast<std::size_t>(about.st_size) > kMaxBytes) {
    error_.set("%s: expected a file of at most %zu MiB; cut the log", path_.c_str(),
               kMaxBytes >> 20);
    return false;
  }
  text_.resize(static_cast<std::size_t>(about.st_size));
  text_.resize(std::fread(text_.data(), 1, text_.size(), file.get()));
  error_.clear();
  log_ = wire::CandumpReader(text_);
  pending_ = next(next_);
  if (!pending_ && !failed_) {
    error_.set("%s: expected frames%s%s, found none; name a candump log", path_.c_str(),
               interface_.empty() ? "" : " of ", interface_.c_str());
  }
  return pending_;
}

bool CandumpFile::next(ReceivedFrame& out) {
  while (!failed_ && log_.next()) {
    const wire::CandumpLine& line = log_.line();
    const bool ours = interface_.empty() || line.interface == interface_;
    if (log_.is_xl()) {
      drops_ += ours;
    } else if (!log_.status().ok()) {
      error_.set("%s:%zu:%zu: expected %s; %s", path_.c_str(), log_.number(),
                 log_.status().column, wire::expected_at(log_.status().error),
                 log_.cure());
      failed_ = true;
    } else if (ours) {
      out = {line.time_ns / 1000, line.frame};
      return true;
    }
  }
  return false;
}

std::vector<std::string> CandumpFile::interfaces() const {
  std::vector<std::string> names;
  for (wire::CandumpReader log(text_); log.next();) {
    const std::string_view name = log.line().interface;
    const bool known = std::ranges::find(names, name) != names.end();
    if (log.status().ok() && !known) names.emplace_back(name);
  }
  return names;
}

CanStatus CandumpFile::read(std::span<ReceivedFrame> out, std::size_t& count) {
  count = 0;
  const bool paced = pace_ == ReplayPace::kRealTime;
  const std::int64_t now_us = paced ? clock_.realtime_us() : 0;
  while (pending_ && count < out.size()) {
    ReceivedFrame frame = next_;
    if (paced) {
      if (log_start_us_ < 0) log_start_us_ = frame.time_us;
      frame.time_us += real_start_us_ - log_start_us_;
      if (frame.time_us > now_us) break;
    }
    out[count++] = frame;
    pending_ = next(next_);
  }
  if (count > 0) return CanStatus::kOk;
  if (pending_) return CanStatus::kWait;
  if (!failed_ && cut_line() > 0) {
    error_.set("%s: the log has ended; line %zu, its last, is cut and was left out",
               path_.c_str(), cut_line());
  } else if (!failed_) {
    error_.set("%s: the log has ended", path_.c_str());
  }
  return CanStatus::kEnded;
}

CanStatus CandumpFile::write(const wire::CanFrame& /*frame*/) {
  return CanStatus::kOk;
}

}  // namespace hal
