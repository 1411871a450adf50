#include "wire/uds_connection.hpp"

namespace wire {

void UdsConnection::on_frame(const CanFrame& frame, std::int64_t now_us) {
  link_.on_frame(frame, now_us);
  answer(now_us);
}

void UdsConnection::answer(std::int64_t now_us) {
  while (const std::optional<IsoTpRequest> request = link_.request()) {
    const std::span<const std::uint8_t> response = server_.handle(
        request->data, request->functional, now_us, response_, request->tester);
    const std::uint8_t tester = request->tester;
    if (!response.empty() && link_.send(response)) {
      answered_ = tester;
    } else {
      link_.release();
    }
  }
}

void UdsConnection::wait(std::int64_t now_us) {
  server_.advance(now_us);
  link_.expire(now_us);
}

std::optional<CanFrame> UdsConnection::poll(std::int64_t now_us) {
  if (link_.sending()) {
    server_.keep_alive(now_us, answered_);
  }
  server_.advance(now_us);
  answer(now_us);  // what waited for a response to end
  return link_.poll(now_us);
}

}  // namespace wire
