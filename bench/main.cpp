// stickband_bench [Google Benchmark options]
// stickband_bench --peer-files FOLDER   window.csv and structures.csv for octave/peer.m
// stickband_bench --once                one two-path structure search, to count
// instructions
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>

#include "bench/measure.hpp"
#include "bench/parts.hpp"
#include "workbench/simulate/recording_csv.hpp"

namespace {

bool write_peer_files(const std::string& folder) {
  std::ofstream window(folder + "/window.csv");
  workbench::write_csv(bench::example(), window, false);
  std::ofstream list(folder + "/structures.csv");
  list.precision(std::numeric_limits<double>::max_digits10);
  list << "na,nb,nk,segments_ascending,segments_descending,known,aic,fit_percent\n";
  for (const auto& entry : bench::coordinate_sweep(bench::example_window<double>())) {
    const ident::Structure& s = entry.structure;
    list << s.na << ',' << s.nb << ',' << s.nk << ',' << s.segments_ascending << ','
         << s.segments_descending << ',' << entry.known << ',' << entry.aic << ','
         << entry.fit_percent << '\n';
  }
  return window.flush().good() && list.flush().good();
}

}  // namespace

// A plain name, by which callgrind finds what to count.
extern "C" [[gnu::noinline]] double stickband_search_once(
    bench::SearchPart<double>& part) {
  return part.run().aic;
}

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--peer-files") == 0) {
    if (!write_peer_files(argv[2])) {
      std::fprintf(stderr, "stickband_bench: cannot write to %s\n", argv[2]);
      return 1;
    }
    return 0;
  }
  if (argc == 2 && std::strcmp(argv[1], "--once") == 0) {
    const auto window = bench::example_window<double>();
    bench::SearchPart<double> part(window,
                                   ident::StructureSearch<double>::ValveKind::kTwoPath);
    std::printf("aic %.9g\n", stickband_search_once(part));
    return 0;
  }
  bench::register_pushes();
  bench::register_identification();
  bench::register_scaling();
  benchmark::AddCustomContext("compiler", __VERSION__);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
