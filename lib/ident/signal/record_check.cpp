#include "ident/signal/record_check.hpp"

#include <algorithm>

#include "ident/signal/noisy_hold.hpp"

namespace ident {

template <class Real>
void RecordCheck<Real>::start(std::span<const Real> u, std::span<const Real> y,
                              std::span<const Real> sp) {
  u_ = u;
  y_ = y;
  sp_ = sp;
  health_ = {};
  search_.template emplace<SensorHoldSearch<Real>>().start(u, y);
  stage_ = Stage::kSensor;
}

template <class Real>
void RecordCheck<Real>::take_seams() {
  const Seams<Real>& seams = search<SeamSearch<Real>>().seams();
  health_.seam_at = seams.at[0];
  health_.part_first = seams.first;
  health_.part_length = seams.length;
  if (seams.count == 0) {
    health_.seam_at = 0;
  }
}

template <class Real>
void RecordCheck<Real>::take_storage() {
  const StoredSignal<Real>& stored_y = search<StorageSearch<Real>>().signal();
  health_.compressed = was_compressed(stored_u_, stored_y);
  if (health_.compressed) {
    health_.points_apart = std::max(stored_u_.points_apart, stored_y.points_apart);
  }
  // A controller or an operator may hold u; nothing but a historian holds y.
  if (stored_y.storage == Storage::kHeld) {
    health_.held_apart = stored_y.points_apart;
  }
}

template <class Real>
bool RecordCheck<Real>::step() {
  switch (stage_) {
    case Stage::kSensor:
      if (search<SensorHoldSearch<Real>>().step()) {
        health_.sensor_sticks = search<SensorHoldSearch<Real>>().hold().sticks ||
                                find_noisy_hold(u_, y_).sticks;
        search_.template emplace<SwapSearch<Real>>().start(u_, y_, sp_);
        stage_ = Stage::kSwap;
      }
      break;
    case Stage::kSwap:
      if (search<SwapSearch<Real>>().step()) {
        health_.swapped = search<SwapSearch<Real>>().evidence().swapped;
        search_.template emplace<SeamSearch<Real>>().start(u_, y_, sp_);
        stage_ = Stage::kSeam;
      }
      break;
    case Stage::kSeam:
      if (search<SeamSearch<Real>>().step()) {
        take_seams();
        search_.template emplace<StorageSearch<Real>>().start(u_);
        stage_ = Stage::kStorageOfU;
      }
      break;
    case Stage::kStorageOfU:
      if (search<StorageSearch<Real>>().step()) {
        stored_u_ = search<StorageSearch<Real>>().signal();
        search<StorageSearch<Real>>().start(y_);
        stage_ = Stage::kStorageOfY;
      }
      break;
    case Stage::kStorageOfY:
      if (search<StorageSearch<Real>>().step()) {
        take_storage();
        stage_ = Stage::kDone;
      }
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

template class RecordCheck<float>;
template class RecordCheck<double>;

}  // namespace ident
