#include <memory>

#include "ident/monitor.hpp"
#include "wire/monitor_bytes.hpp"

int main() {
  using Monitor = ident::Monitor<float, ident::kSmallWindow>;
  const auto monitor = std::make_unique<Monitor>(ident::MonitorSettings<float>{});
  for (std::int64_t t = 0; t < 100; ++t) monitor->push({t * 1'000'000, 50.0F, 50.0F});
  ident::MonitorMemory back;
  const auto bytes = wire::encode_monitor(monitor->memory());
  return wire::decode_monitor(bytes, back) && monitor->report().samples.accepted == 100
             ? 0
             : 1;
}
