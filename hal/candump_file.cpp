#include "hal/candump_file.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include "wire/candump.hpp"
#include "wire/text.hpp"

namespace hal {
namespace {

bool is_blank_line(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

CandumpFile::CandumpFile(std::string path, std::string interface, ReplayPace pace,
                         const Clock& clock)
    : path_(std::move(path)),
      interface_(std::move(interface)),
      pace_(pace),
      clock_(clock) {}

bool CandumpFile::open() {
  at_ = line_ = 0;
  cut_line_ = 0;
  failed_ = pending_ = any_ = false;
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
  deltas_ = wire::candump_times_are_deltas(text_);
  clock_ns_ = 0;
  pending_ = next(next_);
  if (!pending_ && !failed_) {
    error_.set("%s: expected frames%s%s, found none; name a candump log", path_.c_str(),
               interface_.empty() ? "" : " of ", interface_.c_str());
  }
  return pending_;
}

bool CandumpFile::next(ReceivedFrame& out) {
  while (!failed_ && at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = std::string_view(text_).substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    if (is_blank_line(line)) continue;
    wire::CandumpLine parsed;
    const wire::CandumpStatus status = wire::parse_candump(line, parsed);
    const bool ours = interface_.empty() || parsed.interface == interface_;
    if (status.error == wire::CandumpError::kXlFrame) {
      drops_ += ours;
      continue;
    }
    const bool last = end == text_.size();
    if (!status.ok() && last && any_ && wire::is_cut_short(line, status.column)) {
      cut_line_ = line_;
      return false;
    }
    if (!status.ok()) {
      error_.set("%s:%zu:%zu: expected %s; %s", path_.c_str(), line_, status.column,
                 wire::expected_at(status.error),
                 any_ ? "remove the line, or record with candump -l"
                      : "record with candump -l, or convert the log: in Python, "
                        "can_logconvert FILE loop.log");
      failed_ = true;
      return false;
    }
    any_ = true;
    if (parsed.relative && deltas_) parsed.time_ns = clock_ns_ += parsed.time_ns;
    if (!ours) continue;
    out = {parsed.time_ns / 1000, parsed.frame};
    return true;
  }
  return false;
}

std::vector<std::string> CandumpFile::interfaces() const {
  std::vector<std::string> names;
  for (std::string_view rest = text_; !rest.empty();) {
    wire::CandumpLine line;
    const bool read = wire::parse_candump(wire::take_until(rest, '\n'), line).ok();
    const bool known =
        std::find(names.begin(), names.end(), line.interface) != names.end();
    if (read && !known) names.emplace_back(line.interface);
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
  if (!failed_ && cut_line_ > 0) {
    error_.set("%s: the log has ended; line %zu, its last, is cut and was left out",
               path_.c_str(), cut_line_);
  } else if (!failed_) {
    error_.set("%s: the log has ended", path_.c_str());
  }
  return CanStatus::kEnded;
}

CanStatus CandumpFile::write(const wire::CanFrame& /*frame*/) {
  return CanStatus::kOk;
}

}  // namespace hal
