// What a monitor has learned from windows that are over: what is worth keeping over a
// restart. Windows themselves, and what has been announced, are not in it.
#pragma once

#include "ident/evidence/evidence_pool.hpp"
#include "ident/valve/earlier_valve.hpp"
#include "ident/verdict/alarm.hpp"
#include "ident/verdict/verdict.hpp"

namespace ident {

/// Plain data, of one span of u and one sample period (Monitor::memory).
struct MonitorMemory {
  EvidencePool pool;
  AlarmState alarm;
  /// Windows in a row, of those that were due, that said what the newest of them did,
  /// 0 … 1000; and what that was.
  int alike_windows = 0;
  Verdict alike_verdict = Verdict::kUndecided;
  bool alike_oscillation = false;
  EarlierValve earlier;  ///< that the next window's search starts from
};

}  // namespace ident
