// A simulated loop as the gateway sees it: configuration, DBC file and candump log.
#pragma once

#include <cstdint>
#include <string>

#include "config/gateway.hpp"
#include "support/base/temporary_folder.hpp"
#include "workbench/simulate/simulated_loop.hpp"

/// Files of one simulated recording in a folder of their own, removed with the object.
class GatewayLoop {
 public:
  /// `scenario` as in `stickband simulate --list`; `more` is added to the configuration.
  GatewayLoop(const std::string& scenario, std::uint64_t seed,
              const std::string& more = "");
  /// The same for any recording.
  explicit GatewayLoop(const workbench::SimulatedLoop& loop,
                       const std::string& more = "");
  GatewayLoop(const GatewayLoop&) = delete;
  GatewayLoop& operator=(const GatewayLoop&) = delete;

  [[nodiscard]] const config::Gateway& gateway() const { return gateway_; }
  [[nodiscard]] std::string log() const { return folder_.file("loop.log"); }
  [[nodiscard]] std::string toml() const { return folder_.file("gateway.toml"); }
  [[nodiscard]] const std::string& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
  config::Gateway gateway_;
};
