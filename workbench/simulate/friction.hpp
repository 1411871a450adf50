// Friction of a sticking valve, and the words the literature has for it.
#pragma once

namespace workbench {

/// Static and kinetic friction per stroke, in units of u (He, Wang, Pottmann &
/// Qin 2007, with one pair for each direction). The valve at x starts to move
///   up   when u - x >  static_ascending   and then rests at u - kinetic_ascending,
///   down when u - x < -static_descending  and then rests at u + kinetic_descending.
/// All four are >= 0, and kinetic <= static for each stroke.
struct Friction {
  double static_ascending = 0;
  double static_descending = 0;
  double kinetic_ascending = 0;
  double kinetic_descending = 0;

  /// S: travel of u after a turning point until the valve moves up (down). It
  /// holds for a turning point at which the valve had just moved; a valve of
  /// He's kind, which moves in steps, may turn up to J later and then needs
  /// less travel towards a standstill position it never reached.
  [[nodiscard]] constexpr double stick_band_ascending() const {
    return static_ascending + kinetic_descending;
  }
  [[nodiscard]] constexpr double stick_band_descending() const {
    return static_descending + kinetic_ascending;
  }
  /// J: travel of the stem at the instant it breaks free.
  [[nodiscard]] constexpr double slip_jump_ascending() const {
    return static_ascending - kinetic_ascending;
  }
  [[nodiscard]] constexpr double slip_jump_descending() const {
    return static_descending - kinetic_descending;
  }
};

/// Friction with the given stick bands and the deadband D = S - J that both
/// strokes share: S_asc - J_asc = S_desc - J_desc = fd_asc + fd_desc whatever
/// the four forces are. How D splits between the strokes only shifts x by a
/// constant; it is split in halves. Requires 0 <= deadband <= both bands.
[[nodiscard]] constexpr Friction friction_from_bands(double stick_band_ascending,
                                                     double stick_band_descending,
                                                     double deadband) {
  return {stick_band_ascending - deadband / 2, stick_band_descending - deadband / 2,
          deadband / 2, deadband / 2};
}

/// Friction of Choudhury's (2005) and Kano's (2004) symmetric S and J:
/// fs = (S + J) / 2, fd = (S - J) / 2. Requires 0 <= J <= S.
[[nodiscard]] constexpr Friction friction_from_s_j(double stick_band, double slip_jump) {
  return friction_from_bands(stick_band, stick_band, stick_band - slip_jump);
}

}  // namespace workbench
