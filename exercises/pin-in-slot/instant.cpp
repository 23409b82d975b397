#include "exercises/pin-in-slot/instant.h"

#include <fmt/format.h>

namespace epure::pin_in_slot {

std::vector<GivenSpec> stated_givens() {
  return {
      {"M1", {"point mass at A", "massa puntiforme in A"}, "kg", "30", Range::not_negative, "$\\it{M}_{A}$"},
      {"M2", {"mass of the disc", "massa del disco"}, "kg", "20", Range::positive, "$\\it{M}_{B}$"},
      {"J2",
       {"moment of inertia of the disc about B", "momento d'inerzia baricentrico del disco"},
       "kg m^2",
       "1",
       Range::not_negative,
       "$\\it{J}_{B}$"},
      {"R", {"radius of the disc", "raggio del disco"}, "m", "0.2", Range::positive, "$\\it{R}$"},
      {"OB", {"distance of the pin from O", "distanza del piolo da O"}, "m", "0.4", Range::positive, "$OB$"},
      {"AO", {"distance of A from O", "distanza di A da O"}, "m", "0.3", Range::positive, "$AO$"},
      {"omega",
       {"angular velocity of the lever, clockwise", "velocità angolare del glifo, oraria"},
       "rad/s",
       "1",
       Range::any,
       "$ω$"},
      {"omega_dot",
       {"angular acceleration of the lever, clockwise", "accelerazione angolare del glifo, oraria"},
       "rad/s^2",
       "0.4",
       Range::any,
       "d$ω$/d$t$"},
      {"g", {"acceleration of gravity", "accelerazione di gravità"}, "m/s^2", "9.81", Range::not_negative, "$g$"},
  };
}

Instant instant(const Givens& givens) {
  const Rational &R = givens["R"], &OB = givens["OB"];
  if (OB < R) {
    throw BadGivens(format_words(
        "OB = {} m is shorter than R = {} m by {} m: the pin stays R above the guide, on which O lies, so OB must be "
        "at "
        "least R",
        "OB = {} m è più corto di R = {} m, di {} m: il perno resta R sopra la guida, su cui sta O, dunque OB "
        "dev'essere "
        "almeno R",
        decimal(CGAL::to_double(OB), 6), decimal(CGAL::to_double(R), 6), decimal(CGAL::to_double(R - OB), 3)));
  }
  return {.lengths = {R, OB, givens["AO"]},
          .masses = {givens["M1"], givens["M2"], givens["J2"], givens["g"]},
          .omega = givens.angle("omega"),
          .omega_dot = givens.angle("omega_dot")};
}

}  // namespace epure::pin_in_slot
