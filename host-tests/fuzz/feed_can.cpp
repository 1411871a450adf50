#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "feed.hpp"
#include "require.hpp"
#include "support/uds/daemon.hpp"
#include "wire/sha256.hpp"
#include "wire/uds_connection.hpp"

namespace fuzz {
namespace {

class Input {
 public:
  explicit Input(std::string_view text) : left_(text) {}
  [[nodiscard]] bool empty() const { return left_.empty(); }
  std::uint8_t byte() {
    if (left_.empty()) return 0;
    const auto value = static_cast<std::uint8_t>(left_.front());
    left_.remove_prefix(1);
    return value;
  }
  std::vector<std::uint8_t> bytes(std::size_t count) {
    std::vector<std::uint8_t> out(std::min(count, left_.size()));
    for (std::uint8_t& value : out) value = byte();
    return out;
  }

 private:
  std::string_view left_;
};

// A daemon that finds out when it is asked for something it must not be asked.
class WatchfulDaemon {
 public:
  explicit WatchfulDaemon(const wire::UdsSettings& settings) : settings_(settings) {}

  void check_untouched_unless_writable() const {
    if (settings_.writes && settings_.has_key) return;
    require(daemon.resets.empty(), "no reset without the key");
    for (const wire::LoopStatus& loop : daemon.loops) {
      require(!loop.simulated, "no simulation without the key");
      require(
          loop.parameters.on_delay_windows == 2 && loop.parameters.band_min_pct == 0.5,
          "no writing without the key");
    }
  }

  support::UdsDaemon daemon;

 private:
  wire::UdsSettings settings_;
};

wire::UdsSettings settings_of(std::uint8_t choice) {
  wire::UdsSettings settings;
  settings.writes = (choice & 1) != 0;
  settings.has_key = (choice & 2) != 0;
  settings.block_bytes = (choice & 4) != 0 ? 7 : 1024;
  settings.key.fill(0x5A);
  return settings;
}

void check_response(std::span<const std::uint8_t> request,
                    std::span<const std::uint8_t> response) {
  if (response.empty()) return;
  require(!request.empty(), "an answer to a question");
  if (response[0] == 0x7F) {
    require(response.size() == 3 && response[1] == request[0] && response[2] != 0,
            "a refusal that names its service");
  } else {
    require(response[0] == static_cast<std::uint8_t>(request[0] + 0x40),
            "an answer to this service");
  }
}

std::int64_t pause_us(std::uint8_t choice) {
  constexpr std::array<std::int64_t, 4> kPauses = {0, 1'000, 400'000, 6'000'000};
  return kPauses[choice & 3];
}

}  // namespace

Outcome feed_uds(std::string_view text) {
  Input input(text);
  const wire::UdsSettings settings = settings_of(input.byte());
  WatchfulDaemon watch(settings);
  support::UdsDaemon& daemon = watch.daemon;
  wire::UdsServer server(settings, daemon.gateway, daemon.loops, *daemon.dtcs, daemon);
  std::vector<std::uint8_t> seed;
  std::int64_t now_us = 0;
  bool any = false;
  while (!input.empty()) {
    const std::uint8_t control = input.byte();
    now_us += pause_us(control);
    const bool functional = (control & 4) != 0;
    daemon.willing = (control & 8) == 0;
    std::vector<std::uint8_t> request = input.bytes(input.byte());
    if ((control & 16) != 0 && !seed.empty()) {  // the right key, which nobody guesses
      const wire::Sha256Digest digest = wire::hmac_sha256(settings.key, seed);
      request = {0x27, 0x02};
      request.insert(request.end(), digest.begin(), digest.begin() + 16);
    }
    const std::size_t room = (control & 32) != 0 ? 64 : wire::kLongestIsoTpResponse;
    std::vector<std::uint8_t> storage(room);
    const auto tester = static_cast<std::uint8_t>(control >> 6);
    const auto response = server.handle(request, functional, now_us, storage, tester);
    check_response(request, response);
    if (response.size() == 18 && response[0] == 0x67) {
      seed.assign(response.begin() + 2, response.end());
    }
    any |= !response.empty() && response[0] != 0x7F;
    watch.check_untouched_unless_writable();
    require(server.session(tester) != 1 || !server.unlocked(tester),
            "locked in the default session");
  }
  server.advance(now_us + wire::UdsServer::kS3Us);
  require(server.session() == 1 && !daemon.recording_open, "silence ends everything");
  require(!daemon.loops[0].simulated, "silence ends a simulation");
  return any ? Outcome::kAccepted : Outcome::kRefused;
}

Outcome feed_isotp(std::string_view text) {
  Input input(text);
  const std::uint8_t choice = input.byte();
  wire::IsoTpSettings link;
  if ((choice & 0x80) != 0) link = wire::normal_fixed_settings();
  link.block_size = choice >> 4 & 3;
  const wire::UdsSettings settings = settings_of(choice);
  WatchfulDaemon watch(settings);
  support::UdsDaemon& daemon = watch.daemon;
  const auto connection = std::make_unique<wire::UdsConnection>(
      link, settings, daemon.gateway, daemon.loops, *daemon.dtcs, daemon);
  std::int64_t now_us = 0;
  const auto drain = [&] {
    constexpr std::size_t kMost = wire::kLongestIsoTpResponse / 7 + 4;
    std::size_t frames = 0;
    while (const auto frame = connection->poll(now_us)) {
      require(++frames <= kMost, "a bounded answer");
      require(frame->dlc == 8 && !frame->remote && wire::is_valid(*frame),
              "padded classic frames");
      require(frame->extended == link.extended_ids, "identifiers of our kind");
      require(link.extended_ids ? (frame->id & 0x1FFF00FF) == 0x18DA0010
                                : frame->id == link.response_id,
              "our own identifier");
    }
  };
  while (!input.empty()) {
    const std::uint8_t control = input.byte();
    now_us += pause_us(control);
    wire::CanFrame frame;
    const std::array<std::uint32_t, 4> ids = {link.request_id, link.functional_id,
                                              link.request_id + 1, link.response_id};
    frame.id = ids[control >> 2 & 3];
    frame.extended = link.extended_ids;
    const std::uint8_t shape = input.byte();
    frame.dlc = shape & 0x0F;
    frame.remote = (shape & 0x10) != 0;
    frame.error = (shape & 0x20) != 0;
    const std::vector<std::uint8_t> data =
        input.bytes(std::min<std::size_t>(frame.dlc, frame.data.size()));
    std::copy(data.begin(), data.end(), frame.data.begin());
    connection->on_frame(frame, now_us);
    if ((control & 0x10) == 0) drain();
    if ((control & 0x20) != 0) connection->reset();
    watch.check_untouched_unless_writable();
  }
  drain();
  constexpr int kMostWakings = 1000;
  for (int i = 0; connection->next_us() && i < kMostWakings; ++i) {
    now_us = std::max(now_us, *connection->next_us());
    drain();
  }
  require(!connection->link().busy(), "silence ends every transfer");
  return connection->link().counters().requests > 0 ? Outcome::kAccepted
                                                    : Outcome::kRefused;
}

}  // namespace fuzz
