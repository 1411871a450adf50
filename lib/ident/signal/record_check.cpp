#include "ident/signal/record_check.hpp"

#include <algorithm>

#include "ident/signal/noisy_hold.hpp"
#include "ident/signal/range_end.hpp"
#include "ident/signal/seam.hpp"
#include "ident/signal/sensor_hold.hpp"
#include "ident/signal/storage.hpp"
#include "ident/signal/swap.hpp"

namespace ident {

RecordHealth<double> check_record(std::span<const double> u, std::span<const double> y,
                                  std::span<const double> sp) {
  RecordHealth<double> health;
  health.sensor_sticks = find_sensor_hold(u, y).sticks || find_noisy_hold(u, y).sticks;
  health.cut_off = find_range_end(y, false).share + find_range_end(y, true).share;
  health.swapped = are_swapped(u, y, sp);
  const Seams seams = find_seams(u, y, sp);
  health.seam_at = seams.count > 0 ? seams.at[0] : 0;
  const StoredSignal stored_u = find_storage(u);
  const StoredSignal stored_y = find_storage(y);
  health.compressed = was_compressed(stored_u, stored_y);
  if (health.compressed) {
    health.points_apart = std::max(stored_u.points_apart, stored_y.points_apart);
  }
  // A controller or an operator may hold u; nothing but a historian holds y.
  if (stored_y.storage == Storage::kHeld) {
    health.held_apart = stored_y.points_apart;
  }
  return health;
}

}  // namespace ident
