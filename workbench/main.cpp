#include "workbench/cli/command_line.hpp"

int main(int argc, char** argv) {
  return workbench::cli::run(argc, argv);
}
