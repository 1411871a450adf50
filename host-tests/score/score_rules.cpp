// Identifies loops whose valve is known and writes what was found of each, for
// weigh_rules.py, which asks what each threshold of the verdict is worth.
//
//   score_rules FILE [LOOPS=40]
//
// LOOPS of each family of `stickband simulate`, four times as many sticking and six times
// as many healthy ones under loads cut from recordings, where these are there. Seeds
// begin at 1001: the ones that thresholds are chosen on.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "judged_loop.hpp"
#include "support/real_loads/loads.hpp"
#include "support/real_loads/loop.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using Identifier = ident::Identifier<double, ident::kLargeWindow>;
using workbench::test::JudgedLoop;
using workbench::test::LoopKind;

constexpr std::uint64_t kFirstSeed = 1001;

class Writer {
 public:
  explicit Writer(std::FILE* file) : file_(file) {}

  void add(const workbench::SimulatedLoop& loop, bool simulated, bool sticks) {
    const JudgedLoop judged{simulated, sticks, identifier_->run(loop.u, loop.y, loop.sp)};
    if (std::fwrite(&judged, sizeof judged, 1, file_) != 1) {
      std::fprintf(stderr,
                   "score_rules: the file cannot be written: is the disk full?\n");
      std::exit(3);
    }
  }

 private:
  std::FILE* file_;
  std::unique_ptr<Identifier> identifier_ = std::make_unique<Identifier>();
};

void add_simulated(Writer& writer, std::uint64_t loops) {
  for (const char* name :
       {"stiction", "stiction-one-sided", "stiction-mixed", "stiction-integrating",
        "stiction-setpoint", "stiction-few-steps", "backlash"}) {
    for (std::uint64_t k = 0; k < loops; ++k) {
      writer.add(*workbench::simulate(name, kFirstSeed + k), true, true);
    }
  }
  for (const char* name :
       {"external-sinusoid", "tight-tuning", "random-load", "setpoint", "healthy",
        "quantised", "healthy-positioner", "load-and-noise", "few-steps"}) {
    for (std::uint64_t k = 0; k < loops; ++k) {
      writer.add(*workbench::simulate(name, kFirstSeed + k), true, false);
    }
  }
}

void add_under_loads(Writer& writer, std::uint64_t loops) {
  const auto loads = workbench::test::read_real_loads(STICKBAND_RECORDINGS);
  if (loads.empty()) {
    std::fprintf(stderr, "score_rules: without the recordings, simulated loops only\n");
    return;
  }
  for (std::uint64_t k = 0; k < 4 * loops; ++k) {
    writer.add(real_load_loop(LoopKind::kSticking, kFirstSeed + k, loads).recorded, false,
               true);
  }
  for (std::uint64_t k = 0; k < 6 * loops; ++k) {
    writer.add(real_load_loop(LoopKind::kHealthy, kFirstSeed + k, loads).recorded, false,
               false);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int loops = argc > 2 ? std::atoi(argv[2]) : 40;
  std::FILE* file = argc > 1 && loops > 0 ? std::fopen(argv[1], "wb") : nullptr;
  if (file == nullptr) {
    std::fprintf(
        stderr,
        "score_rules: expected FILE, which can be written, and a number of loops "
        "of each family, 1 or more\n");
    return 2;
  }
  Writer writer(file);
  add_simulated(writer, static_cast<std::uint64_t>(loops));
  add_under_loads(writer, static_cast<std::uint64_t>(loops));
  std::fclose(file);
}
