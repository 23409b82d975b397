// What the source printed, and why its couple is wrong, which it could not find: "Il secondo punto sembra venire
// errato, non riesco ad identificare l'errore."
#include <cmath>

#include "exercises/pin-in-slot/printed.h"

namespace epure::pin_in_slot {
namespace {

// The source's last formula, with its numbers: v_B = k ω OB with k = 1/sin α = 2, differentiated as if k were
// constant.
double couple_with_constant_angle() {
  const double OB = 0.4, R = 0.2, omega = 1, omega_dot = 0.4, M1 = 30, M2 = 20, J2 = 1, AO = 0.3, g = 9.81;
  const double cosine = std::sqrt(1 - R * R / (OB * OB)), k = OB / R, v_rel = omega * OB * cosine * k;
  return M1 * g * AO * cosine + M1 * AO * AO * omega_dot +
         k * k * OB * (M2 + J2 / (R * R)) * (omega_dot * OB + omega * v_rel);
}

// The only variant found that gives the couple the source quotes as the answer: 0.4 m is B's distance from O along
// the guide, not along the slot, the weight of M1 helps, and g = 9.8.
double couple_of_another_figure() {
  const double x = 0.4, R = 0.2, OB = std::hypot(x, R), omega = 1, omega_dot = 0.4;
  const double M1 = 30, M2 = 20, J2 = 1, AO = 0.3, g = 9.8;
  const double v_B = omega * OB * OB / R, a_B = omega_dot * OB * OB / R + 2 * omega * x * v_B / R;
  const double kinetic = M1 * AO * AO * omega_dot + (M2 + J2 / (R * R)) * v_B * a_B / omega;
  return kinetic - M1 * g * AO * x / OB;
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  return {
      {"v_B", "0.8", "analytic"},
      {"omega_disc", "-4", "analytic"},
      {"a_B", "3.1", "analytic"},
      {"alpha_disc", "-15.5", "analytic"},
      {"C", "138.9", "power balance", 0,
       Explanation{{"E_k is differentiated after v_B = 2·OB·ω is put in; the 2 is 1/sin α at this instant only, and "
                    "α varies too. With v_B = OB²·ω/R, which holds always, the balance gives 188.8 N m. The formula "
                    "as printed: M₁·g·AO·cos α + M₁·AO²·ω' + 4·OB·(M₂ + J₂/R²)·(ω'·OB + ω·v_rel)",
                    "E_c è derivata dopo aver posto v_B = 2·OB·ω; il 2 è 1/sen α solo in questo istante, e anche α "
                    "varia. Con v_B = OB²·ω/R, che vale sempre, il bilancio dà 188,8 N m. La formula com'è stampata: "
                    "M₁·g·AO·cos α + M₁·AO²·ω' + 4·OB·(M₂ + J₂/R²)·(ω'·OB + ω·v_rel)"},
                   couple_with_constant_angle}},
      {"C", "120.2", "power balance", 0,
       Explanation{{"a conjecture: the answer the source quotes comes out of another figure, with B 0.4 m from O "
                    "along the guide instead of along the slot, the weight of M₁ helping and g = 9.8 m/s²; the "
                    "disc's motion printed before it contradicts that figure",
                    "una congettura: il risultato riportato dalla fonte esce da un'altra figura, con B a 0,4 m da O "
                    "lungo la guida anziché lungo il glifo, il peso di M₁ che aiuta e g = 9,8 m/s²; il moto del "
                    "disco stampato prima contraddice quella figura"},
                   couple_of_another_figure}},
  };
}

}  // namespace epure::pin_in_slot
