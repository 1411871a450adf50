#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

class Measured final : public Effect {
 public:
  explicit Measured(std::string_view column)
      : Effect(texts_),
        column_(column),
        code_(std::string(kMeasuredLoad) + column_),
        title_("the measured load " + column_),
        cure_("It is known what moves the output: " + column_ +
              ". Feed it forward to the valve, or quieten it at its source."),
        split_("move " + column_ + " while u is at rest"),
        texts_{.code = code_,
               .title = title_,
               .place = Place::kLoad,
               .view = View::kTime,
               .signature = "follows another recorded signal",
               .cure = cure_,
               .split = split_,
               .needs_u = false,
               .recorded = true} {}

  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    const auto lag = [&s](std::string_view name) {
      return SearchedParameter{.name = name,
                               .unit = "s",
                               .low = s.period_s / 10,
                               .high = s.duration_s() / 5,
                               .logarithmic = true,
                               .open_floor = true};
    };
    // From where the load is counted: in another recording, too.
    SearchedParameter reference{.name = "load_reference", .unit = "1", .constant = true};
    if (const Load* load = find(s.loads)) {
      std::tie(reference.low, reference.high) = range_of(*load);
    }
    // As of the process, an integrator stands for the first lag.
    if (s.integrating) return {lag("load_second_lag"), reference};
    return {lag("load_lag"), lag("load_second_lag"), reference};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {
        {.name = "load_gain", .unit = "y per unit", .integrated_unit = "y/s per unit"}};
    return kSolved;
  }
  // Through lags of its own, from at once to as slow as the process.
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const Load* load = find(s.loads);
    if (load == nullptr || !moves(load->values)) return {};
    std::vector<Values> out;
    const double quick = s.period_s / 10;
    const double reference = load->values.front();
    if (s.integrating) out.push_back({quick, reference});
    for (const Values& lag : lag_starts(s)) {
      if (s.integrating) {
        out.push_back({lag[0], reference});
      } else {
        out.push_back({lag[0], quick, reference});
        out.push_back({lag[0], lag[0], reference});
      }
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals) const override {
    const Load* load = find(s.loads);
    if (load == nullptr) return {0, "moves of the load"};
    const auto [low, high] = range_of(*load);
    return {count_moves(load->values, (high - low) / 8), "moves of the load",
            kLeastMoves};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p,
                                     Reals c) const override {
    if (s.integrating) {
      return filled(
          "{0} moves the output by {1} y per second for each of its units, behind a lag "
          "of {2} s.",
          {column_, number(c[0], 3), number(p[0], 3)});
    }
    return filled(
        "{0} moves the output by {1} y for each of its units, behind a lag of {2} s.",
        {column_, number(c[0], 3), number(p[0] + p[1], 3)});
  }
  void load(Reals p, const LoadSetting& setting, Columns columns) const override {
    const Load* load = find(setting.loads);
    if (load == nullptr || load->values.size() != columns[0].size()) {
      std::ranges::fill(columns[0], 0.0);
      return;
    }
    ProcessShape shape;
    shape.first_lag_s = p[0];
    shape.second_lag_s = p[p.size() - 2];
    shape.integrating = setting.shape.integrating;
    std::vector<double> counted = load->values;
    for (double& value : counted) value -= p.back();
    std::vector<double> scratch;
    respond(shape, setting.period_s, counted, scratch, columns[0]);
  }

 private:
  [[nodiscard]] const Load* find(std::span<const Load> loads) const {
    const auto load = std::ranges::find_if(
        loads, [this](const Load& one) { return one.name == column_; });
    return load != loads.end() ? &*load : nullptr;
  }
  static std::pair<double, double> range_of(const Load& load) {
    const auto [low, high] = std::ranges::minmax_element(load.values);
    return {*low, *high};
  }
  static bool moves(const std::vector<double>& values) {
    return std::ranges::adjacent_find(values, std::not_equal_to<>()) != values.end();
  }

  std::string column_;
  std::string code_;
  std::string title_;
  std::string cure_;
  std::string split_;
  Description texts_;
};

}  // namespace

const Effect& disturbance_measured(std::string_view column) {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<const Measured>, std::less<>> known;
  const std::lock_guard lock(mutex);
  auto place = known.find(column);
  if (place == known.end()) {
    place = known.emplace(std::string(column), std::make_unique<const Measured>(column))
                .first;
  }
  return *place->second;
}

}  // namespace workbench::effects
