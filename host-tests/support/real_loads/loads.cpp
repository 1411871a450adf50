#include "support/real_loads/loads.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/statistics.hpp"
#include "workbench/simulate/cycles.hpp"

namespace workbench::test {
namespace {

nlohmann::json read_labels(const std::filesystem::path& folder) {
  std::ifstream file(folder / "labels.json");
  return file ? nlohmann::json::parse(file) : nlohmann::json::object();
}

// Means over `width` samples, so that thinning does not fold fast movement over.
std::vector<double> smoothed(const std::vector<double>& values, std::size_t width) {
  if (width < 2 || values.size() < width) return values;
  std::vector<double> means;
  double sum = 0;
  for (std::size_t t = 0; t < values.size(); ++t) {
    sum += values[t];
    if (t >= width) sum -= values[t - width];
    if (t + 1 >= width) means.push_back(sum / static_cast<double>(width));
  }
  return means;
}

// The signal at any time >= 0, running back and forth between its ends.
double at(const std::vector<double>& values, double time) {
  const double last = static_cast<double>(values.size() - 1);
  const double lap = std::fmod(time, 2 * last);
  const double place = lap > last ? 2 * last - lap : lap;
  const auto before = std::min(static_cast<std::size_t>(place), values.size() - 2);
  const double share = place - static_cast<double>(before);
  return (1 - share) * values[before] + share * values[before + 1];
}

void remove_line(std::vector<double>& signal) {
  const double mean = mean_of(signal);
  const double middle = (static_cast<double>(signal.size()) - 1) / 2;
  double lean = 0;
  double spread = 0;
  for (std::size_t t = 0; t < signal.size(); ++t) {
    const double away = static_cast<double>(t) - middle;
    lean += away * (signal[t] - mean);
    spread += away * away;
  }
  for (std::size_t t = 0; t < signal.size(); ++t) {
    signal[t] -= mean + lean / spread * (static_cast<double>(t) - middle);
  }
}

}  // namespace

std::vector<RealLoad> read_real_loads(const std::filesystem::path& folder) {
  std::vector<RealLoad> loads;
  std::set<std::string> sticking;
  const auto add = [&](const std::string& name, const std::string& loop, Column column) {
    CsvOptions options;
    options.required = {column};
    const std::filesystem::path path = folder / (name + ".csv");
    loads.push_back({name, loop, read_csv(path.string(), options).values(column)});
  };
  const nlohmann::json isdb = read_labels(folder / "isdb");
  for (const auto& [name, label] : isdb.items()) {
    const auto comment = label["comment"].get<std::string>();
    const bool sticks = label["stiction"].is_boolean()
                            ? label["stiction"].get<bool>()
                            : comment.find("stiction") != std::string::npos;
    const bool other = label["stiction"].is_boolean() ||
                       comment.find("disturbance") != std::string::npos;
    if (sticks) {
      sticking.insert(name);
    } else if (other) {
      add("isdb/" + name, name, Column::y);
    }
  }
  const nlohmann::json plant = read_labels(folder / "plant");
  for (const auto& [name, label] : plant.items()) {
    if (!label["stiction"].get<bool>()) {
      add("plant/" + name, label["loop"].get<std::string>(), Column::y);
    }
  }
  const nlohmann::json sacac = read_labels(folder / "sacac");
  for (const auto& [name, label] : sacac.items()) {
    if (label["cause"] != "stiction") add("sacac/" + name, name, Column::y);
  }
  const nlohmann::json oscillation = read_labels(folder / "oscillation");
  for (const auto& [name, label] : oscillation.items()) {
    if (!label["oscillating"].get<bool>() && !sticking.contains(name)) {
      add("oscillation/" + name, name, Column::u);
    }
  }
  std::sort(loads.begin(), loads.end(),
            [](const RealLoad& a, const RealLoad& b) { return a.name < b.name; });
  return loads;
}

std::vector<double> cut_load(Random& random, const RealLoad& load, std::size_t samples,
                             double stretch) {
  const double thinning = std::max(1.0, std::round(1 / stretch));
  const auto values = smoothed(load.values, static_cast<std::size_t>(thinning));
  const double start = random.uniform(0, 2 * static_cast<double>(values.size()));
  std::vector<double> cut(samples);
  for (std::size_t t = 0; t < samples; ++t) {
    cut[t] = at(values, start + static_cast<double>(t) / stretch);
  }
  const double before = std_of(cut);
  remove_line(cut);
  const double std = std_of(cut);
  if (!(std > 1e-6 * before)) return {};
  for (double& value : cut) value /= std;
  return cut;
}

}  // namespace workbench::test
