// Where the search for a valve starts: grids of stick bands, slips and stem positions.
#pragma once

#include "ident/valve/stick_slip_valve.hpp"
#include "ident/valve/valve_form.hpp"

namespace ident {

/// Candidate `index` for a valve that slides on, to be tried on a whole window: the
/// linear valve first, then every form on a grid of stick bands from 2 % to 115 % of
/// `swing` (the usual swing of u, > 0), finer where they are small. False past the end
/// (177 candidates).
template <class Real>
[[nodiscard]] bool sliding_start(int index, Real swing, ValveForm& form,
                                 ValveFriction<Real>& friction);

/// Candidate `index` for a valve that remembers where it stopped or slipped (`motion`),
/// to be tried on the first cycles: stick bands from 10 % to 120 % of `swing`, each 10 %
/// more than the one before, in nine proportions, and stem positions across the band
/// around the first value of u, `first_u`. What must be hit within a few percent of the
/// slip is where the stem stood; a valve that slides forgets it and gets two starts
/// instead of up to 24. False past the end (486 and 3402 candidates).
template <class Real>
[[nodiscard]] bool remembering_start(int index, SlipMotion motion, Real swing,
                                     Real first_u, ValveFriction<Real>& friction,
                                     Real& position);

}  // namespace ident
