#include "workbench/model/base/one_loop.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

void check_unit(const std::string& what, const Recording& a, const std::string& unit_a,
                const Recording& b, const std::string& unit_b) {
  if (unit_a.empty() || unit_b.empty() || unit_a == unit_b) return;
  throw InputError(
      b.name, 0, 0, what + " in " + quoted(unit_a) + ", as " + a.name + " has it",
      quoted(unit_b), "give recordings of one loop in the same units, or each by itself");
}

void check_units(const Recording& a, const Recording& b) {
  for (const Column column : {Column::u, Column::y, Column::x}) {
    check_unit(std::string(name_of(column)), a, a.unit(column), b, b.unit(column));
  }
  for (const Load& load : a.loads) {
    for (const Load& other : b.loads) {
      if (other.name == load.name) check_unit(load.name, a, load.unit, b, other.unit);
    }
  }
}

void check_loops(const Recording& a, const Recording& b) {
  if (a.loop.empty() || b.loop.empty()) return;
  if (a.loop.ends_with(b.loop) || b.loop.ends_with(a.loop)) return;
  throw InputError(
      b.name, 0, 0, filled("the loop of {0}: {1}", {a.name, a.tags}), b.tags,
      "give each loop by itself; where both are one, name the columns with --u and --y");
}

// Clock times of the first sample and behind the last, s.
struct Span {
  double first = 0;
  double last = 0;
  bool zoned = false;
};

std::optional<Span> span_of(const Recording& recording) {
  const std::optional<WrittenTime> start = written_time(recording.start);
  if (!start || start->kind != WrittenTime::Day::kKnown) return std::nullopt;
  const double first = start->since_1970_s();
  const auto samples = static_cast<double>(recording.size());
  return Span{first, first + samples * recording.period_s, start->has_zone};
}

// Time that both hold, if it is more than a sample; s.
double shared_s(const Recording& a, const Recording& b) {
  const std::optional<Span> of_a = span_of(a);
  const std::optional<Span> of_b = span_of(b);
  if (!of_a || !of_b || of_a->zoned != of_b->zoned) return 0;
  const double shared =
      std::min(of_a->last, of_b->last) - std::max(of_a->first, of_b->first);
  return shared > std::max(a.period_s, b.period_s) ? shared : 0;
}

}  // namespace

void check_one_loop(const std::vector<Recording>& recordings) {
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    for (std::size_t j = i + 1; j < recordings.size(); ++j) {
      check_units(recordings[i], recordings[j]);
      check_loops(recordings[i], recordings[j]);
    }
  }
}

std::vector<std::string> overlaps_of(const std::vector<Recording>& recordings) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    for (std::size_t j = i + 1; j < recordings.size(); ++j) {
      const Recording& a = recordings[i];
      const Recording& b = recordings[j];
      const double shared = shared_s(a, b);
      if (shared == 0 || (a.u == b.u && a.y == b.y)) continue;
      out.push_back(
          filled("{0} and {1} overlap in time by {2} s: what both hold counts twice; "
                 "export each time once",
                 {a.name, b.name, number(shared)}));
    }
  }
  return out;
}

}  // namespace workbench
