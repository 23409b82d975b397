#include "exercises/cam-dynamics/cam.h"

#include "exercises/kit/statement/given_number.h"

namespace epure::cam_dynamics {
namespace {}  // namespace

std::vector<GivenSpec> stated_givens() {
  return {
      {"r", {"radius of the disc", "raggio del disco"}, "m", "0.100", Range::positive, "$r$"},
      {"r_r", {"radius of the roller", "raggio del rullo"}, "m", "0.050", Range::not_negative, "$r_{r}$"},
      {"A0A", {"eccentricity of the disc", "eccentricità del disco"}, "m", "0.030", Range::positive, "$A_{0}A$"},
      {"phi", {"angle of A0A from x", "angolo di A0A da x"}, "deg", "21", Range::any, "$φ$"},
      {"e", {"abscissa of the follower's axis", "ascissa dell'asse del cedente"}, "m", "0.0486", Range::any, "$e$"},
      {"m_2", {"mass of the disc", "massa del disco"}, "kg", "2.2", Range::not_negative, "$m_{2}$"},
      {"m_3", {"mass of the follower", "massa del cedente"}, "kg", "1.9", Range::not_negative, "$m_{3}$"},
      {"P", {"closing force, downwards", "forza di chiusura, verso il basso"}, "N", "50", Range::any, "$\\it{P}$"},
      {"g", {"acceleration of gravity", "accelerazione di gravità"}, "m/s^2", "9.81", Range::not_negative, "$g$"},
      {"n", {"speed of the cam", "velocità della camma"}, "rpm", "50", Range::any, "$n$"},
      {"n_lift", {"speed at maximum lift", "velocità alla massima alzata"}, "rpm", "350", Range::any, "$n_{l}$"}};
}

Cam cam(const Givens& givens) {
  const Rational& e = givens["e"];
  const Cam of{.lengths = {givens["A0A"], givens["r"], givens["r_r"], -e},
               .offset = e,
               .m_2 = givens["m_2"],
               .m_3 = givens["m_3"],
               .P = givens["P"],
               .g = givens["g"],
               .angle = givens.angle("phi"),
               .omega = givens.angle("n"),
               .fast = givens.angle("n_lift")};
  if (!of.lengths.turns_fully())
    throw BadGivens(
        format_words("|e| + A0A = {} m must be less than r + r_r = {} m: the disc's centre passes the follower's "
                     "axis at that distance, the roller does not reach it there, and the follower leaves the cam",
                     "|e| + A0A = {} m dev'essere minore di r + r_r = {} m: il centro del disco passa a quella "
                     "distanza dall'asse del cedente, il rullo non vi arriva, e il cedente lascia la camma",
                     told_value(CGAL::abs(e) + of.lengths.eccentricity), told_value(of.lengths.reach())));
  return of;
}

}  // namespace epure::cam_dynamics
