#include "workbench/simulate/noise.hpp"

#include <cmath>

namespace workbench {

std::vector<double> first_order_noise(Random& random, std::size_t samples, double pole,
                                      double innovation_std) {
  std::vector<double> v(samples);
  double last = random.normal() * innovation_std / std::sqrt(1 - pole * pole);
  for (double& value : v) {
    last = pole * last + innovation_std * random.normal();
    value = last;
  }
  return v;
}

std::vector<double> coloured_noise(Random& random, std::size_t samples, double pole,
                                   double std) {
  return first_order_noise(random, samples, pole, std * std::sqrt(1 - pole * pole));
}

}  // namespace workbench
