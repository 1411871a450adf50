// The table of diagnostic objects as a Prometheus textfile.
//
// Numbers only, as they go on the wire: stickband_loop_<field>{loop="1",tag="…"} and
// stickband_gateway_<field>. "Not available" is NaN.
#pragma once

#include <string>

#include "wire/diagnostics.hpp"

namespace firmware {

/// Replaces `out`. After the first call with as many loops it does not allocate.
void write_metrics(const wire::GatewayView& view, std::string_view group,
                   std::string& out);

}  // namespace firmware
