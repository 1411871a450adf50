// FreeRun: from the columns to the output, and what is solved on the way.
#include <algorithm>
#include <cmath>

#include "workbench/model/base/noise.hpp"
#include "workbench/model/base/normal_equations.hpp"
#include "workbench/model/fit/free_run.hpp"

namespace workbench {

// What is left after one period of a deviation from the linear process: a storage that
// spilled starts from its brim.
double FreeRun::memory() const {
  if (!ceiling_->spills) return 0;
  const double lag_s = integrating_ ? 0 : shape_.first_lag_s;
  return integrating_ ? 1 : std::exp(-situation_->period_s / lag_s);
}

void FreeRun::behind_sensor(std::span<const double> in, std::span<double> out) const {
  for (const Piece& piece : pieces_) {
    const std::size_t count = piece.last - piece.first;
    lag_of_lines(in.subspan(piece.first, count), situation_->period_s,
                 shape_.sensor_lag_s, out.subspan(piece.first, count));
  }
}

// The linear output in residual_ becomes the one below the ceiling, behind the sensor.
void FreeRun::cut_off() {
  free_.resize(residual_.size());
  const double keep = memory();
  for (const Piece& piece : pieces_) {
    double lost = 0;
    for (std::size_t k = piece.first; k < piece.last; ++k) {
      lost *= keep;
      const bool below = residual_[k] + lost < ceiling_->level;
      free_[k] = below;
      if (!below) lost = ceiling_->level - residual_[k];
      residual_[k] += lost;
    }
  }
  if (shape_.sensor_lag_s > 0) behind_sensor(residual_, residual_);
}

// The stretches that are cut off, each with the free one behind it.
std::vector<FreeRun::Cut> FreeRun::cuts() const {
  std::vector<Cut> out;
  for (const Piece& piece : pieces_) {
    std::size_t k = piece.first;
    while (k < piece.last && free_[k]) ++k;
    while (k < piece.last) {
      Cut cut{k, k, k};
      while (cut.last < piece.last && !free_[cut.last]) ++cut.last;
      k = cut.last;
      while (k < piece.last && free_[k]) ++k;
      cut.next = k;
      out.push_back(cut);
    }
  }
  return out;
}

// The same for the derivatives with respect to the coefficients.
void FreeRun::cut_columns() {
  const std::vector<Cut> all = cuts();
  const double keep = memory();
  left_.resize(residual_.size());  // of a deviation, sample by sample after the cut
  double left = 1;
  for (double& share : left_) share = left *= keep;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::vector<double>& used = used_[i];
    used = raw_[i];
    if (columns_[i].name == "sensor_state") continue;
    for (const Cut& cut : all) {
      const double lost = -used[cut.last - 1];
      for (std::size_t k = cut.first; k < cut.last; ++k) used[k] = 0;
      for (std::size_t k = cut.last; k < cut.next; ++k)
        used[k] += lost * left_[k - cut.last];
    }
    if (shape_.sensor_lag_s > 0) behind_sensor(used, used);
  }
}

// From the columns and their coefficients to the residual, before anything is recorded.
void FreeRun::output() {
  const std::size_t n = residual_.size();
  const bool is_still =
      std::ranges::all_of(coefficients_, [](double c) { return c == 0; });
  if (is_still && !ceiling_) {
    std::copy(situation_->y.begin(), situation_->y.end(), residual_.begin());
    return;
  }
  std::fill(residual_.begin(), residual_.end(), 0.0);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double c = coefficients_[i];
    if (c == 0) continue;
    const std::vector<double>& column = ceiling_ ? raw_[i] : used_[i];
    if (ceiling_ && columns_[i].name == "sensor_state") continue;
    for (std::size_t k = extents_[i].first; k < extents_[i].last; ++k) {
      residual_[k] += c * column[k];
    }
  }
  if (ceiling_) {
    cut_off();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].name != "sensor_state") continue;
      for (std::size_t k = 0; k < n; ++k) residual_[k] += coefficients_[i] * raw_[i][k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) residual_[k] = situation_->y[k] - residual_[k];
}

// The plant, or its initial state alone, on the rows that may be fitted; then the state
// of each piece that judges, on all of that.
void FreeRun::solve(bool initial_only, Rows where) {
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const bool wanted =
        columns_[i].initial || (!initial_only && held(columns_[i]) == nullptr);
    if (wanted && !columns_[i].judges) active.push_back(i);
  }
  const std::span<const Block> rows =
      where == Rows::kAll ? blocks_->kept() : blocks_->blocks();
  solve(active, rows);
  if (drop_impossible_pipes(active)) solve(active, rows);
  if (!initial_only && gain_runs_away()) {
    std::erase(active, gain_column());
    coefficients_[gain_column()] = 0;
    static_cast<void>(drop_impossible_pipes(active));
    solve(active, rows);
  }
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    if (!pieces_[piece].judges) continue;
    active.clear();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].judges && columns_[i].piece == piece) active.push_back(i);
    }
    std::vector<Block> all;
    for (const Block& kept : blocks_->kept()) {
      const std::size_t first = std::max(kept.first, pieces_[piece].first);
      const std::size_t last = std::min(kept.last, pieces_[piece].last);
      if (first < last) all.push_back({first, last, true});
    }
    if (!active.empty()) solve(active, all);
  }
}

void FreeRun::hold(std::span<const Held> held) {
  solved_.reset();
  held_.assign(held.begin(), held.end());
  for (Slot& slot : slots_) {
    for (const Held& one : held_) {
      if (one.effect != slot.effect || one.name != slot.parameter.name) continue;
      slot.parameter.constant = true;
    }
  }
}

const FreeRun::Held* FreeRun::held(const Column& column) const {
  for (const Held& one : held_) {
    if (one.effect == column.effect && one.name == column.name) return &one;
  }
  return nullptr;
}

std::size_t FreeRun::gain_column() const {
  std::size_t i = 0;
  while (!is_gain(columns_[i])) ++i;
  return i;
}

// A gain with which the loop would feed its own error back to itself.
bool FreeRun::gain_runs_away() const {
  const std::size_t gain = gain_column();
  return held(columns_[gain]) == nullptr &&
         coefficients_[gain] * situation_->gain_sign < 0;
}

// (W4) What is underway at the first sample is what the gain makes of an earlier u, which
// was somewhere in the range of the signal. True: some stood for more, and is taken out.
bool FreeRun::drop_impossible_pipes(std::vector<std::size_t>& active) {
  constexpr double kFarthest =
      50;  // spans of u: a recording moves 2 % of a range at least
  const double most =
      kFarthest * std::abs(coefficients_[gain_column()]) * situation_->u_span();
  return std::erase_if(active, [&](std::size_t i) {
           const bool pipe =
               columns_[i].name == kPipe || columns_[i].name == kFirstHalfOfPipe;
           const bool impossible = pipe && !(std::abs(coefficients_[i]) <= most);
           if (impossible) coefficients_[i] = 0;
           return impossible;
         }) > 0;
}

void FreeRun::set_aside() {
  aside_.clear();
  for (const SampleRange& range : blocks_->left_out()) {
    for (std::size_t k = range.first; k < range.last; ++k) {
      aside_.push_back(residual_[k]);
      residual_[k] = 0;
    }
  }
}

void FreeRun::weigh_by(std::vector<double> colour) {
  solved_.reset();
  weight_ = std::move(colour);
}

// Each piece for itself; what its first samples owe to those before it is not known, and
// they count nothing.
void FreeRun::weigh(std::span<const double> in, std::vector<double>& out) const {
  if (weight_.empty()) return;
  out.assign(in.size(), 0.0);
  const std::size_t unknown = weight_.size() - 1;
  for (const Piece& piece : pieces_) {
    const std::vector<double> part =
        whitened({weight_}, in.subspan(piece.first, piece.last - piece.first));
    if (part.size() <= unknown) continue;
    std::ranges::copy(std::span(part).subspan(unknown),
                      out.begin() + static_cast<std::ptrdiff_t>(piece.first + unknown));
  }
}

std::vector<double> FreeRun::judged_column(std::size_t i) const {
  std::vector<double> out(used_[i]);
  weigh(used_[i], out);
  return out;
}

// What the rows add to the active coefficients.
void FreeRun::improve(const std::vector<std::size_t>& active,
                      std::span<const Block> rows) {
  std::vector<std::span<const double>> columns;
  std::vector<SampleRange> extents;
  std::vector<std::vector<double>> weighed(weight_.empty() ? 0 : active.size());
  for (std::size_t i = 0; i < active.size(); ++i) {
    SampleRange extent = extents_[active[i]];
    if (!weighed.empty()) {
      weigh(used_[active[i]], weighed[i]);
      extent.last = std::min(extent.last + weight_.size(), residual_.size());
    }
    columns.emplace_back(weighed.empty() ? used_[active[i]] : weighed[i]);
    extents.push_back(extent);
  }
  weigh(residual_, judged_);
  const std::vector<double> step = least_squares(columns, judged(), rows, extents);
  for (std::size_t i = 0; i < active.size(); ++i) coefficients_[active[i]] += step[i];
  output();
}

double FreeRun::error_on(std::span<const Block> rows) {
  weigh(residual_, judged_);
  return sum_of_squares(judged(), rows);
}

void FreeRun::solve(const std::vector<std::size_t>& active, std::span<const Block> rows) {
  if (!ceiling_) {
    output();
    improve(active, rows);
    return;
  }
  // The cut makes the output piecewise linear in the coefficients: Gauss-Newton steps,
  // the first over what lies clearly below the level.
  const Ceiling ceiling = *ceiling_;
  ceiling_.reset();
  std::vector<Block> below;
  for (const Block& block : rows) {
    if (!block.estimation) continue;
    for (std::size_t k = block.first; k < block.last; ++k) {
      if (situation_->y[k] > ceiling.level - 0.02 * situation_->y_span()) continue;
      if (below.empty() || below.back().last != k) below.push_back({k, k, true});
      below.back().last = k + 1;
    }
  }
  output();
  improve(active, below);
  ceiling_ = ceiling;
  output();
  double best = error_on(rows);
  constexpr int kMostSteps = 4;
  for (int i = 0; i < kMostSteps; ++i) {
    cut_columns();
    const std::vector<double> kept = coefficients_;
    const std::vector<unsigned char> before = free_;
    improve(active, rows);
    const double error = error_on(rows);
    if (!(error < best)) {
      coefficients_ = kept;
      output();
      return;
    }
    if (free_ == before || error > best * (1 - 1e-4)) return;
    best = error;
  }
}

std::span<double> FreeRun::part(std::vector<double>& signal, std::size_t piece) const {
  return std::span(signal).subspan(pieces_[piece].first,
                                   pieces_[piece].last - pieces_[piece].first);
}

Situation FreeRun::in_piece(std::size_t piece) const {
  Situation here = *situation_;
  const std::size_t first = pieces_[piece].first;
  const std::size_t count = pieces_[piece].last - first;
  here.u = here.u.subspan(first, count);
  here.y = here.y.subspan(first, count);
  here.pieces = {};
  return here;
}

// The columns as they are recorded, where that can be said of each.
void FreeRun::record_columns(std::span<const double> p) {
  rounded_ = false;
  if (ceiling_) return;
  for (const Effect* effect : effects_) {
    if (effect->description().place != Place::kRecord) continue;
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
      const Situation here = in_piece(piece);
      for (std::size_t i = 0; i < columns_.size() && !rounded_; ++i) {
        if (extents_[i].last <= pieces_[piece].first ||
            extents_[i].first >= pieces_[piece].last) {
          continue;
        }
        rounded_ =
            !effect->record_part(of(*effect, p, piece), here, part(used_[i], piece));
      }
    }
  }
}

void FreeRun::finish(std::span<const double> p) {
  for (const Effect* effect : effects_) {
    if (effect->description().place != Place::kRecord) continue;
    for (std::size_t k = 0; k < residual_.size(); ++k) {
      residual_[k] = situation_->y[k] - residual_[k];
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      effect->record(of(*effect, p, i), in_piece(i), part(residual_, i));
    }
    for (std::size_t k = 0; k < residual_.size(); ++k) {
      residual_[k] = situation_->y[k] - residual_[k];
    }
  }
}

// What a rounding makes of the output differs from it in step with it, so the
// coefficients that fit best before the rounding are not those that fit best behind it.
void FreeRun::solve_behind_rounding(std::span<const double> p) {
  if (!rounded_ || ceiling_) return;
  std::vector<std::size_t> active;
  std::vector<std::span<const double>> columns;
  std::vector<SampleRange> extents;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const bool stands =
        held(columns_[i]) != nullptr ||
        (is_gain(columns_[i]) && situation_->gain_sign != 0 && coefficients_[i] == 0);
    if (stands) continue;
    active.push_back(i);
    columns.emplace_back(used_[i]);
    extents.push_back(extents_[i]);
  }
  const NormalEquations equations(columns, blocks_->blocks(), extents);
  double best = sum_of_squares(residual_, blocks_->blocks());
  constexpr int kMostSteps = 6;
  double share = 1;
  std::vector<double> kept = coefficients_;
  std::vector<double> left = residual_;
  std::vector<double> step = equations.solve(left);
  for (int i = 0; i < kMostSteps; ++i) {
    for (std::size_t j = 0; j < step.size(); ++j) {
      coefficients_[active[j]] = kept[active[j]] + share * step[j];
    }
    output();
    finish(p);
    const double error = sum_of_squares(residual_, blocks_->blocks());
    if (error < best) {
      if (error > best * (1 - 1e-4)) return;
      best = error;
      kept = coefficients_;
      left = residual_;
      if (i + 1 < kMostSteps) step = equations.solve(left);
    } else {
      share /= 3;
      coefficients_ = kept;
      residual_ = left;
    }
  }
}

}  // namespace workbench
