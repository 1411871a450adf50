// write_seeds FOLDER: one file per seed, in a folder per fuzzer, for libFuzzer.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "seeds.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: write_seeds FOLDER\n", stderr);
    return 2;
  }
  const auto write = [&](const char* name, const std::vector<std::string>& seeds) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / name;
    std::filesystem::create_directories(folder);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      std::ofstream(folder / std::to_string(i), std::ios::binary) << seeds[i];
    }
  };
  write("fuzz_csv", fuzz::csv_seeds());
  write("fuzz_candump", fuzz::candump_seeds());
  write("fuzz_frames", fuzz::frames_seeds());
  write("fuzz_dbc", fuzz::dbc_seeds());
  write("fuzz_uds", fuzz::uds_seeds());
  write("fuzz_isotp", fuzz::isotp_seeds());
  write("fuzz_toml", fuzz::toml_seeds());
  std::ofstream dictionary(std::filesystem::path(argv[1]) / "words.dict");
  for (const std::string_view word : fuzz::words()) {
    dictionary << '"';
    for (const char c : word) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\x%02X", static_cast<unsigned char>(c));
      dictionary << escaped;
    }
    dictionary << "\"\n";
  }
  return 0;
}
