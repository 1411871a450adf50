// write_can [--check] ROOT: brings docs/can.md and docs/stickband.dbc up to date with the
// table of diagnostic objects; with --check only says which one is not.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "can_views.hpp"

namespace {

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// True when `path` holds `text` in the end.
bool update(const std::string& path, const std::string& text, bool only_check) {
  if (read(path) == text) return true;
  if (only_check) {
    std::printf("%s: expected what the table says, found something else; run write_can\n",
                path.c_str());
    return false;
  }
  std::ofstream file(path, std::ios::binary);
  file << text;
  return file.good();
}

}  // namespace

int main(int argc, char** argv) {
  const bool only_check = argc == 3 && std::string_view(argv[1]) == "--check";
  if (argc != 2 && !only_check) {
    std::fputs("usage: write_can [--check] ROOT\n", stderr);
    return 2;
  }
  const std::string docs = std::string(argv[argc - 1]) + "/docs/";
  try {
    const bool page =
        update(docs + "can.md", can_views::page(read(docs + "can.md")), only_check);
    const bool dbc = update(docs + "stickband.dbc", can_views::dbc(), only_check);
    return page && dbc ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%scan.md: %s\n", docs.c_str(), error.what());
    return 1;
  }
}
