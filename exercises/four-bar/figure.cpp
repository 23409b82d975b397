#include "exercises/four-bar/figure.h"

#include "exercises/four-bar/at_special_positions.h"

#include "geometry/motion/instant_centres.h"

namespace epure::four_bar {

using geometry::Deep;

namespace {

geometry::Point<Deep> corner(const Problem& of, const geometry::FourBar<Deep>& at) {
  return geometry::right_angled_corner(at.A, at.B, of.instant.lengths.AB, of.AC, of.C_side);
}

// A' and B', between which the inflection circle is built; none without a pole.
std::vector<CircleBuilder> builders(const geometry::FourBar<Deep>& at) {
  if (!to_double(at.pole())) return {};
  const geometry::Point<Deep> P0 = finite(at.pole());
  return {{"$A'$", to_double(geometry::euler_savary_point(P0, at.A, at.A0)), to_double(at.A)},
          {"$B'$", to_double(geometry::euler_savary_point(P0, at.B, at.B0)), to_double(at.B)}};
}

// By Aronhold and Kennedy: on the frame's line and on the coupler's.
std::optional<Place> relative_pole(const geometry::FourBar<Deep>& at) {
  try {
    const auto centres =
        geometry::instant_centres<Deep>(4, {geometry::hinge(1, 2, at.A0), geometry::hinge(2, 3, at.A),
                                            geometry::hinge(3, 4, at.B), geometry::hinge(1, 4, at.B0)});
    const auto& P42 = centres.of(2, 4).at;
    return P42 ? to_double(*P42) : std::nullopt;
  } catch (const geometry::Undecided&) {
    return {};  // at a dead centre 256 bits cannot tell two centres that coincide
  }
}

// c', by similarity.
PolygonImage image_of_C(const CouplerFigure& coupler, const std::string& letter, const std::string& prefix) {
  const CouplerPoint &A = coupler.points.front(), &C = coupler.points.back();
  const bool velocity = letter == "v";
  const Arrow2 absolute = velocity ? C.v : C.a, of_A = velocity ? A.v : A.a;
  const Words similar =
      velocity ? Words{"$c'$: square to $AC$ through $a'$, square to $BC$ through $b'$. The triangle $a'b'c'$ is the "
                       "image of $ABC$.",
                       "$c'$: normale ad $AC$ per $a'$, normale a $BC$ per $b'$. Il triangolo $a'b'c'$ è l'immagine "
                       "di $ABC$."}
               : Words{"$c'$: the triangle $a'b'c'$ is similar to $ABC$, in the same sense.",
                       "$c'$: il triangolo $a'b'c'$ è simile ad $ABC$, nello stesso verso."};
  return {.absolute = {.quantity = prefix + letter + "_C",
                       .label = "$\\vec{" + letter + "}_{C}$",
                       .v = absolute,
                       .tip = "$c'$"},
          .relative = {.label = "$\\vec{" + letter + "}_{CA}$", .v = {absolute.x - of_A.x, absolute.y - of_A.y}},
          .explained = similar};
}

}  // namespace

Drawn::Drawn(const Problem& of, const geometry::FourBar<Deep>& at, const std::string& prefix)
    : problem(of), mechanism(drawn_four_bar(at, sign_of(of.instant.n))), coupler{&mechanism} {
  const Deep speed = of.instant.omega_2<Deep>();
  const auto motion = geometry::four_bar_motion(at, speed, geometry::radians<Deep>(of.instant.alpha_2));
  const geometry::Point<Deep> C = corner(of, at);
  mechanism.C = to_double(C);
  coupler = coupler_figure(mechanism, motion.coupler, {{"A", at.A}, {"B", at.B}, {"C", C}});
  coupler.pole = "P31";
  coupler.pole_symbol = "P_{31}";
  coupler.prefix = prefix;
  coupler.builders = builders(at);
  velocity = velocity_polygon(at, motion, prefix);
  acceleration = acceleration_polygon(at, motion, prefix);
  velocity.images = {image_of_C(coupler, "v", prefix)};
  acceleration.images = {image_of_C(coupler, "a", prefix)};
  omega_2 = to_double(speed);
  P42 = relative_pole(at);
  omega_4 = to_double(motion.rocker.omega);
  alpha_4 = to_double(motion.rocker.alpha);
}

std::unique_ptr<Drawn> at_instant(const Problem& of) {
  return drawn(
      of, [&] { return of.instant.position<Deep>(); }, "");
}

std::unique_ptr<Drawn> at_dead_centre(const Problem& of, geometry::Reach reach) {
  const std::string prefix = reach == geometry::Reach::extended ? "dead_centre_extended." : "dead_centre_folded.";
  try {
    if (is_change_point(of, reach)) return nullptr;
    return drawn(
        of, [&] { return geometry::dead_centre<Deep>(of.instant.lengths, reach, of.instant.side).at; }, prefix);
  } catch (const geometry::Impossible&) {
    return nullptr;
  }
}

}  // namespace epure::four_bar
