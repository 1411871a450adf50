#include "workbench/simulate/recording_csv.hpp"

#include <charconv>
#include <ostream>
#include <string>

namespace workbench {
namespace {

void append(std::string& line, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  line.append(digits, end);
}

}  // namespace

void write_csv(const SimulatedLoop& loop, std::ostream& out, bool with_position) {
  out << (with_position ? "t,u,y,sp,x\n" : "t,u,y,sp\n");
  std::string line;
  for (std::size_t i = 0; i < loop.t.size(); ++i) {
    line.clear();
    append(line, loop.t[i]);
    for (const auto* signal : {&loop.u, &loop.y, &loop.sp}) {
      line += ',';
      append(line, (*signal)[i]);
    }
    if (with_position) {
      line += ',';
      append(line, loop.x[i]);
    }
    line += '\n';
    out << line;
  }
}

}  // namespace workbench
