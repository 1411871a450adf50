#include "firmware/gateway_loop.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "workbench/simulate/candump.hpp"
#include "workbench/simulate/scenarios.hpp"

GatewayLoop::GatewayLoop(const std::string& scenario, std::uint64_t seed,
                         const std::string& more)
    : GatewayLoop(workbench::simulate(scenario, seed).value(), more) {}

GatewayLoop::GatewayLoop(const workbench::SimulatedLoop& loop, const std::string& more) {
  std::ofstream log_file(log());
  workbench::write_candump(loop, log_file);
  std::ofstream(folder_.file("loop.dbc")) << workbench::dbc_text();
  const auto [low, high] = std::minmax_element(loop.u.begin(), loop.u.end());
  const auto signal = [](const char* name, const char* what) {
    return std::string(name) +
           " = { source = \"can\", dbc = \"loop.dbc\", message = \"Loop" + what +
           "\", signal = \"" + what + "\" }\n";
  };
  std::ostringstream text;
  text
      << "[gateway]\nname = \"test\"\n[bus.can0]\nbackend = \"socketcan\"\n"
      << "interface = \"can0\"\n[uds]\n[broadcast]\n[[loop]]\nid = 1\ntag = \"FIC-211\"\n"
      << "sample_period_s = " << loop.period_s << "\nspan = [" << *low << ", "
      << std::max(*high, *low + 1) << "]\n"
      << signal("u", "OP") << signal("y", "PV") << signal("sp", "SP")
      << "flag = { chip = \"gpiochip0\", line = 3 }\n"
      << more;
  std::ofstream(toml()) << text.str();
  log_file.close();
  gateway_ = config::parse_gateway(text.str(), toml());
}
