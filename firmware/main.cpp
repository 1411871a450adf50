#include "firmware/command_line.hpp"

int main(int argc, char** argv) {
  return firmware::run(argc, argv);
}
