// A tester in front of the UDS server of a daemon that does what it is asked.
#pragma once

#include <vector>

#include "support/uds/daemon.hpp"
#include "wire/sha256.hpp"
#include "wire/uds_server.hpp"

namespace support {

using Bytes = std::vector<std::uint8_t>;

inline Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline wire::UdsSettings writing_settings() {
  wire::UdsSettings settings;
  settings.writes = true;
  settings.has_key = true;
  for (std::size_t i = 0; i < settings.key.size(); ++i) {
    settings.key[i] = static_cast<std::uint8_t>(i * 5 + 1);
  }
  return settings;
}

struct UdsTester {
  explicit UdsTester(const wire::UdsSettings& settings = {})
      : key(settings.key.begin(), settings.key.end()),
        server(settings, daemon.gateway, daemon.loops, *daemon.dtcs, daemon) {}

  Bytes ask(const Bytes& request) { return ask(request, false); }
  Bytes ask_all(const Bytes& request) { return ask(request, true); }
  Bytes ask(const Bytes& request, bool functional, std::uint8_t tester = 0) {
    const auto response = server.handle(request, functional, now_us, storage, tester);
    return {response.begin(), response.end()};
  }
  /// As the tester with that source address.
  Bytes ask_as(std::uint8_t tester, const Bytes& request) {
    return ask(request, false, tester);
  }
  Bytes key_for(const Bytes& seed) const {
    const wire::Sha256Digest digest = wire::hmac_sha256(key, seed);
    return {digest.begin(), digest.begin() + 16};
  }
  Bytes seed() {
    const Bytes answer = ask({0x27, 0x01});
    return {answer.begin() + 2, answer.end()};
  }
  void unlock() {
    EXPECT_EQ(ask({0x10, 0x03})[0], 0x50);
    EXPECT_EQ(ask(Bytes{0x27, 0x02} + key_for(seed())), (Bytes{0x67, 0x02}));
  }

  Bytes key;
  UdsDaemon daemon;
  std::array<std::uint8_t, 4095> storage{};
  std::int64_t now_us = 1'000'000;
  wire::UdsServer server;
};

inline Bytes refusal(std::uint8_t service, wire::Nrc nrc) {
  return {0x7F, service, static_cast<std::uint8_t>(nrc)};
}

}  // namespace support
