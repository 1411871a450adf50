// identify_file FILE: a recorded window, and whether its valve sticks. FILE is a CSV
// whose first columns are t, u and y, its rows a sample period apart.
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: identify_file FILE\n", 2;
  std::ifstream file(argv[1]);
  if (!file) return std::cerr << argv[1] << ": expected a CSV file, cannot read it\n", 3;
  std::vector<double> u, y;
  std::string line;
  std::getline(file, line);  // the names of the columns
  while (std::getline(file, line)) {
    if (line.find_first_not_of(" \r") == std::string::npos) continue;  // the last line
    std::istringstream cells(line);
    double t, u_now, y_now;
    char comma;
    if (!(cells >> t >> comma >> u_now >> comma >> y_now)) {
      return std::cerr << argv[1] << ": expected numbers t,u,y, found " << line << '\n',
             3;
    }
    u.push_back(u_now);
    y.push_back(y_now);
  }
  // 150 KiB: not on the stack. It looks at the first kLargeWindow samples.
  const auto identifier =
      std::make_unique<ident::Identifier<double, ident::kLargeWindow>>();
  const ident::Identification<double>& found = identifier->run(u, y, {});
  std::cout << name(found.verdict) << ": " << sentence(found.reason) << '\n';
  const auto print = [](const char* stroke, const ident::Estimate<double>& band) {
    if (!band.known) return;
    std::cout << "stick band " << stroke << ": " << band.value << ", 95 % interval "
              << band.low << " to " << band.high << ", units of u\n";
  };
  print("ascending", found.stick_band.ascending);
  print("descending", found.stick_band.descending);
}
