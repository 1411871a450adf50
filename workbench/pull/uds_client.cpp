#include "workbench/pull/uds_client.hpp"

#include <algorithm>
#include <cstdio>

#include "wire/uds_codes.hpp"

namespace workbench {
namespace {

std::string hex(unsigned value) {
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "%02X", value);
  return text.data();
}

std::string reason(std::uint8_t code) {
  switch (static_cast<wire::Nrc>(code)) {
    case wire::Nrc::kServiceNotSupported:
    case wire::Nrc::kServiceNotInSession:
      return "it does not offer that service";
    case wire::Nrc::kRequestOutOfRange:
      return "it has no such loop or object";
    case wire::Nrc::kConditionsNotCorrect:
      return "it has nothing recorded yet, or another upload goes on; try again in 5 s";
    case wire::Nrc::kBusyRepeatRequest:
      return "it is busy with another tester; try again later";
    default:
      return "see ISO 14229-1";
  }
}

}  // namespace

wire::IsoTpSettings tester_settings(const wire::IsoTpSettings& server) {
  wire::IsoTpSettings settings = server;
  settings.request_id = settings.functional_id = server.response_id;
  settings.response_id = server.request_id;
  settings.answer_busy = false;
  return settings;
}

UdsClient::UdsClient(FramePort& port, const wire::IsoTpSettings& server)
    : port_(port), link_(tester_settings(server), receive_, transmit_) {}

std::vector<std::uint8_t> UdsClient::ask(std::span<const std::uint8_t> request,
                                         int tries) {
  const std::uint8_t service = request[0];
  std::int64_t patience_us = kAnswer_us;
  std::int64_t deadline_us = 0;
  int busy = 0;
  int pending = 0;
  bool send = true;
  while (true) {
    if (send) {
      link_.reset();
      if (!link_.send(request)) throw DeviceError("a request that is too long");
      patience_us = kAnswer_us;
      deadline_us = port_.now_us() + patience_us;
    }
    const auto response = answer(deadline_us);
    send = true;
    if (!response) {
      if (--tries > 0) continue;
      throw DeviceError(
          "expected an answer of the gateway within " +
          std::to_string(patience_us / 1'000'000) +
          " s, found none; check the interface, its bit rate and the identifiers");
    }
    const std::vector<std::uint8_t>& data = *response;
    if (data[0] == static_cast<std::uint8_t>(service + 0x40)) return data;
    if (data.size() != 3 || data[0] != wire::uds::kNegative || data[1] != service) {
      send = false;  // of an earlier request, or of somebody else's: no reason to wait
      if (port_.now_us() < deadline_us) continue;
      throw DeviceError(
          "expected an answer of the gateway, found only those to others; "
          "end the other tester, or try again later");
    }
    const std::uint8_t code = data[2];
    if (code == static_cast<std::uint8_t>(wire::Nrc::kResponsePending)) {
      if (++pending > kMostPending) {
        throw DeviceError("expected the gateway to answer service " + hex(service) +
                          ", found only that it will (NRC 78); try again later");
      }
      send = false;
      patience_us = kPending_us;
      deadline_us = port_.now_us() + patience_us;
      continue;
    }
    const bool is_busy = code == static_cast<std::uint8_t>(wire::Nrc::kBusyRepeatRequest);
    if (!is_busy || ++busy >= kBusyTries) {
      throw DeviceError("expected the gateway to answer service " + hex(service) +
                        ", found its refusal (NRC " + hex(code) + "): " + reason(code));
    }
    pause(port_.now_us() + kBusy_us);
  }
}

// Also while a long response keeps coming in beyond the deadline.
std::optional<std::vector<std::uint8_t>> UdsClient::answer(std::int64_t deadline_us) {
  while (true) {
    while (const auto frame = link_.poll(port_.now_us())) port_.send(*frame);
    if (const auto message = link_.request()) {
      std::vector<std::uint8_t> data(message->data.begin(), message->data.end());
      link_.release();
      return data;
    }
    const std::int64_t now_us = port_.now_us();
    if (now_us >= deadline_us && !link_.busy()) return std::nullopt;
    std::int64_t until_us = link_.busy() ? now_us + kBusy_us : deadline_us;
    if (const auto next = link_.next_us()) until_us = std::min(until_us, *next);
    const auto frame = port_.receive(std::max<std::int64_t>(until_us - now_us, 0));
    if (frame) link_.on_frame(*frame, port_.now_us());
  }
}

void UdsClient::pause(std::int64_t until_us) {
  for (std::int64_t now = port_.now_us(); now < until_us; now = port_.now_us()) {
    (void)port_.receive(until_us - now);
  }
}

}  // namespace workbench
