// Sizes that bound every array and every loop of the identifier.
//
// There are three sets. The small one is for a device with 20 KiB for a loop and its 512
// samples: the same methods, with less room. The least one is for 16 KiB and 384 samples,
// and leaves out what the switches below say. A set is chosen for the whole program: who
// links the CMake target stickband_ident_small, or stickband_ident_least, instead of
// stickband_ident gets the library and these headers with it. Never mix two in one
// program.
#pragma once

#include <type_traits>

namespace ident {

#ifdef STICKBAND_SMALL
inline constexpr bool kSmallSizes = true;
#else
inline constexpr bool kSmallSizes = false;
#endif
#ifdef STICKBAND_LEAST
inline constexpr bool kLeastSizes = true;
#else
inline constexpr bool kLeastSizes = false;
#endif

/// What thresholds of decisions are held against: not rounded, they decide alike in both
/// precisions; the least device has no room for arithmetic in double.
using Threshold = std::conditional_t<kLeastSizes, float, double>;

// Parts that a device may leave out, in the same way: stickband_ident_least does.

/// The paper's two-path search. It brings fit_percent and the model of the report; where
/// stems are searched (kStemSearch), a fault in few turns of u rests on it, too. No band
/// or interval does.
#ifdef STICKBAND_NO_TWO_PATH
inline constexpr bool kTwoPathSearch = false;
#else
inline constexpr bool kTwoPathSearch = true;
#endif
/// Where the physical valve's model fails: the gap of the report.
#ifdef STICKBAND_NO_MODEL_GAP
inline constexpr bool kModelGap = false;
#else
inline constexpr bool kModelGap = true;
#endif
/// Why a loop moves whose valve is fine: the cause of an identification, which no report
/// of a device carries.
#ifdef STICKBAND_NO_CAUSE
inline constexpr bool kNamesCause = false;
#else
inline constexpr bool kNamesCause = true;
#endif
/// The tracker of slips over the whole window. Without it a valve that remembers where it
/// stopped is found from the first cycles outwards alone: docs/firmware-kit.md has what
/// that costs in stick bands.
#ifdef STICKBAND_NO_SLIP_TRACKER
inline constexpr bool kSlipTracker = false;
#else
inline constexpr bool kSlipTracker = true;
#endif

/// The search for a stem that foretells y where none was found running free: under loads.
/// Without it the best band of the ladder speaks for it, the same for both strokes. Left
/// out on a bare board, whose 104 KiB of flash it would exceed by 8, and whose 4 KiB of
/// stack it would exceed, too.
#ifdef STICKBAND_NO_STEM_SEARCH
inline constexpr bool kStemSearch = false;
#else
inline constexpr bool kStemSearch = !kSmallSizes;
#endif

/// Whether strokes of u are compared with a foreign time (E18).
inline constexpr bool kStrokePace = !kSmallSizes;

/// Highest number of output lags a_1 … a_na of the process, equation (1).
inline constexpr int kMaxNa = kSmallSizes ? 3 : 4;
/// Highest number of input lags b_1 … b_nb of the process, equation (1).
inline constexpr int kMaxNb = kSmallSizes ? 2 : 4;
/// Longest dead time beyond one sample, in samples, equation (1).
inline constexpr int kMaxNk = 12;
/// Most segments (slopes) of one valve path, equation (2).
inline constexpr int kMaxSegments = !kTwoPathSearch ? 1 : kSmallSizes ? 6 : 12;
/// Most knots of one valve path, equation (2).
inline constexpr int kMaxKnots = kMaxSegments + 1;
/// Most hats, one a knot, of both paths together.
inline constexpr int kMaxHats = 2 * kMaxKnots;
/// Most unknowns of one least-squares problem: a, b, d, the initial state, κ and the
/// increments of both paths, and a few to spare.
inline constexpr int kMaxUnknowns = 2 * kMaxNa + kMaxNb + 2 + 2 * kMaxSegments + 2;

/// Stems that the valve search follows together, and their slips that it remembers.
inline constexpr int kMostStems = kSmallSizes ? 14 : 40;
inline constexpr int kMostStemSlips = kSmallSizes ? 32 : 74;
/// Valves that it screens and keeps for each time constant, and those that it then
/// follows on more and more of the window.
inline constexpr int kMostScreened = kSmallSizes ? 2 : 3;
inline constexpr int kMostGrown = kSmallSizes ? 6 : 10;

}  // namespace ident
