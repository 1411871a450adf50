// The program's side of bench/python/overhead: `stickband identify --json` without
// reading and writing. REC is read once; each line on standard input asks for one
// identification, and its processor time is printed, s.
#include <cstdio>
#include <ctime>
#include <iostream>
#include <string>

#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/recording/csv.hpp"

namespace {

double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: identify_peer REC.csv\n", stderr);
    return 2;
  }
  const workbench::Recording recording = workbench::read_csv(argv[1]);
  std::string asked;
  while (std::getline(std::cin, asked)) {
    const double begin = processor_s();
    const workbench::Analysis analysis(recording);
    const std::string json =
        workbench::json_line(workbench::identification_json(recording, analysis));
    const double spent = processor_s() - begin;
    std::printf("%.9f %zu\n", spent, json.size());
    std::fflush(stdout);
  }
}
