#include "config/consistency.hpp"

#include <filesystem>
#include <initializer_list>
#include <map>
#include <set>
#include <system_error>
#include <tuple>

#include "config/source_reader.hpp"

namespace config {
namespace {

// Who uses an identifier of a bus. Several signals may share a frame; nothing else.
class IdMap {
 public:
  explicit IdMap(Complaints& complaints) : complaints_(complaints) {}

  void claim(std::size_t bus, std::uint32_t id, bool extended, bool is_signal,
             const Place& place, const std::string& what) {
    const auto [at, added] =
        users_.try_emplace({bus, id, extended}, User{is_signal, what});
    if (added || (is_signal && at->second.is_signal)) return;
    complaints_.add(place.line, place.key,
                    "expected an identifier of its own for " + what + ", found " +
                        hex_id(id, extended) + " used by " + at->second.what +
                        " too; change one of them");
  }

 private:
  struct User {
    bool is_signal;
    std::string what;
  };
  Complaints& complaints_;
  std::map<std::tuple<std::size_t, std::uint32_t, bool>, User> users_;
};

// slcan has classic frames only; whether a link of the kernel has CAN FD shows later.
void check_length(const Gateway& gateway, const Source& source, Complaints& complaints) {
  if (source.kind != SourceKind::kCan || source.bus >= gateway.buses.size()) return;
  const Bus& bus = gateway.buses[source.bus];
  if (bus.backend != Backend::kSlcan || !wire::needs_fd(source.signal)) return;
  complaints.add(source.place.line, source.place.key,
                 "expected a signal within eight bytes, found one that needs CAN FD on "
                 "the slcan bus \"" +
                     bus.name + "\"; use a socketcan bus");
}

void claim_signal(IdMap& ids, const Source& source) {
  if (source.kind != SourceKind::kCan || !source.readable) return;
  if (source.signal.ignored != 0) return;  // many identifiers, shared by their nature
  ids.claim(source.bus, source.signal.frame_id, source.signal.extended, true,
            source.place, source.place.key);
}

void check_ids(const Gateway& gateway, Complaints& complaints) {
  IdMap ids(complaints);
  if (const auto& uds = gateway.uds) {
    ids.claim(uds->bus, uds->request_id, uds->extended_ids, false, uds->place,
              "uds.request_id");
    ids.claim(uds->bus, uds->response_id, uds->extended_ids, false, uds->place,
              "uds.response_id");
    ids.claim(uds->bus, uds->functional_id, uds->extended_ids, false, uds->place,
              "uds.functional_id");
  }
  std::set<int> known;
  for (const Loop& loop : gateway.loops) {
    if (loop.id == 0 || !known.insert(loop.id).second) continue;  // told already
    if (gateway.broadcast) {
      ids.claim(gateway.broadcast->bus,
                gateway.broadcast->base_id + static_cast<std::uint32_t>(loop.id), false,
                false, loop.place, "the status frame of loop " + std::to_string(loop.id));
    }
    if (gateway.broadcast && gateway.broadcast->detail_base_id) {
      for (int frame = 2; frame <= wire::kBroadcastFrames; ++frame) {
        const std::uint32_t base = *gateway.broadcast->detail_base_id;
        ids.claim(gateway.broadcast->bus, wire::detail_id(frame, loop.id, base), false,
                  false, loop.place,
                  "status frame " + std::to_string(frame) + " of loop " +
                      std::to_string(loop.id));
      }
    }
  }
  for (const Loop& loop : gateway.loops) {
    claim_signal(ids, loop.u);
    claim_signal(ids, loop.y);
    for (const auto* source : {&loop.sp, &loop.mode, &loop.alive}) {
      if (*source) claim_signal(ids, **source);
    }
  }
}

bool same_signal(const Source& a, const Source& b) {
  if (a.kind != b.kind || !a.readable || !b.readable) return false;
  if (a.kind != SourceKind::kCan) {
    return a.name == b.name && a.channel == b.channel && a.index == b.index;
  }
  const wire::FrameSignal& s = a.signal;
  const wire::FrameSignal& t = b.signal;
  return a.bus == b.bus && s.frame_id == t.frame_id && s.extended == t.extended &&
         s.signal.start == t.signal.start && s.signal.byte_order == t.signal.byte_order &&
         s.multiplexed == t.multiplexed && s.multiplex_value == t.multiplex_value;
}

template <class Key>
void claim_once(std::map<Key, std::string>& taken, const Key& key, const Place& place,
                const std::string& what, Complaints& complaints) {
  const auto [at, added] = taken.try_emplace(key, place.key);
  if (added) return;
  complaints.add(place.line, place.key,
                 "expected " + what + " of its own, found that of " + at->second +
                     "; change one of them");
}

// Files that are written, with those that come and go beside them, and files that are
// read: no file may be both, nor written for two purposes.
class PathMap {
 public:
  explicit PathMap(Complaints& complaints) : complaints_(complaints) {}

  void reads(const std::string& path, const std::string& what) {
    if (!path.empty()) (void)users_.try_emplace(plain(path), what);
  }
  void writes(const std::string& path, const Place& place, const std::string& what,
              std::initializer_list<const char*> endings) {
    for (const char* ending : endings) {
      const auto [at, added] = users_.try_emplace(plain(path + ending), what);
      if (added) continue;
      complaints_.add(place.line, place.key + ".path",
                      "expected a file of its own for " + what + ", found " + path +
                          ending + " used as " + at->second + "; name another file");
      return;
    }
  }

 private:
  static std::string plain(const std::string& path) {
    std::error_code error;
    const auto real = std::filesystem::weakly_canonical(path, error);
    return error ? path : real.string();
  }

  Complaints& complaints_;
  std::map<std::string, std::string> users_;
};

void check_paths(const Gateway& gateway, Complaints& complaints) {
  PathMap paths(complaints);
  paths.reads(gateway.file, "the configuration");
  if (gateway.uds) paths.reads(gateway.uds->key_file, "the key");
  for (const Bus& bus : gateway.buses) paths.reads(bus.path, "the log of a bus");
  for (const Loop& loop : gateway.loops) {
    paths.reads(loop.u.dbc, "a DBC file");
    paths.reads(loop.y.dbc, "a DBC file");
    for (const auto* source : {&loop.sp, &loop.mode, &loop.alive}) {
      if (*source) paths.reads((*source)->dbc, "a DBC file");
    }
  }
  if (const auto& metrics = gateway.metrics; metrics && !metrics->path.empty()) {
    paths.writes(metrics->path, metrics->place, "the textfile", {"", ".new"});
  }
  if (const auto& state = gateway.state; state && !state->path.empty()) {
    paths.writes(
        state->path, state->place, "the state",
        {"", ".new", ".bad", ".lock", ".windows", ".windows.new", ".windows.bad"});
  }
  if (const auto& history = gateway.history; history && !history->path.empty()) {
    paths.writes(history->path, history->place, "the history", {"", ".bad"});
  }
}

}  // namespace

void check_consistency(const Gateway& gateway, Complaints& complaints) {
  std::map<int, std::string> loop_ids;
  std::map<std::string, std::string> tags;
  std::map<std::pair<std::string, unsigned>, std::string> lines;
  for (const Loop& loop : gateway.loops) {
    if (loop.id > 0) claim_once(loop_ids, loop.id, loop.place, "an id", complaints);
    if (!loop.tag.empty()) claim_once(tags, loop.tag, loop.place, "a tag", complaints);
    if (loop.flag && !loop.flag->chip.empty()) {
      claim_once(lines, std::pair(loop.flag->chip, loop.flag->line), loop.flag->place,
                 "a GPIO line", complaints);
    }
    check_length(gateway, loop.u, complaints);
    check_length(gateway, loop.y, complaints);
    for (const auto* source : {&loop.sp, &loop.mode, &loop.alive}) {
      if (*source) check_length(gateway, **source, complaints);
    }
    if (same_signal(loop.u, loop.y)) {
      complaints.add(loop.y.place.line, loop.y.place.key,
                     "expected another signal than u, found the same; name the process "
                     "output");
    }
  }
  check_ids(gateway, complaints);
  check_paths(gateway, complaints);
}

}  // namespace config
