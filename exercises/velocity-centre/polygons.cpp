// What is drawn: the construction run on Deep, then rounded once.
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/rounded.h"
#include "exercises/velocity-centre/quantities.h"

namespace epure::velocity_centre {
namespace {

using geometry::Deep;

// v_A = v_O + v_AO: all known on the right.
VectorPolygon velocity_polygon(const MovingBar<Deep>& bar) {
  return {.meaning = Meaning::velocity,
          .unit = "m/s",
          .origin = "$O_{v}$",
          .left = {{.quantity = "v_A",
                    .label = "$\\vec{v}_{A}$",
                    .direction = "?",
                    .magnitude = "?",
                    .v = to_double(bar.v_A())}},
          .right = {{.quantity = "v_O",
                     .label = "$\\vec{v}_{O}$",
                     .direction = "∥ $x$",
                     .magnitude = "$V$",
                     .v = to_double(bar.v_O()),
                     .tip = "$o'$"},
                    {.quantity = "v_AO",
                     .label = "$\\vec{v}_{AO}$",
                     .direction = "⊥ $OA$",
                     .magnitude = "$ω$·$OA$",
                     .v = to_double(bar.v_AO()),
                     .tip = "$a'$"}}};
}

// a_A = a_O + a_AO^n + a_AO^t.
VectorPolygon acceleration_polygon(const MovingBar<Deep>& bar) {
  return {.meaning = Meaning::acceleration,
          .unit = "m/s²",
          .origin = "$O_{a}$",
          .left = {{.quantity = "a_A",
                    .label = "$\\vec{a}_{A}$",
                    .direction = "?",
                    .magnitude = "?",
                    .v = to_double(bar.a_A())}},
          .right = {{.quantity = "a_O",
                     .label = "$\\vec{a}_{O}$",
                     .direction = "∥ $x$",
                     .magnitude = "$a$",
                     .v = to_double(bar.a_O()),
                     .tip = "$o'$"},
                    {.quantity = "a_AO_n",
                     .label = "$\\vec{a}^{n}_{AO}$",
                     .direction = "∥ $AO$",
                     .magnitude = "$ω^{2}$·$OA$",
                     .v = to_double(bar.a_AO_n())},
                    {.quantity = "a_AO_t",
                     .label = "$\\vec{a}^{t}_{AO}$",
                     .direction = "⊥ $OA$",
                     .magnitude = "d$ω$/d$t$·$OA$",
                     .v = to_double(bar.a_AO_t()),
                     .tip = "$a'$",
                     .square = true}}};
}

}  // namespace

std::unique_ptr<Drawn> drawn(const Instant& instant) {
  return deeply([&] {
    const MovingBar<Deep> bar = moving_bar<Deep>(instant);
    auto figure = std::make_unique<Drawn>();
    figure->instant = instant;
    figure->centre = centre_of(instant);
    figure->bar.A = to_double(bar.A);
    figure->bar.angle = sign_of(instant.angle) < 0 ? -geometry::to_double(within_one_turn(-instant.angle))
                                                   : geometry::to_double(within_one_turn(instant.angle));
    figure->bar.sense = sign_of(instant.omega);
    figure->motion = coupler_figure(figure->bar, bar.motion, {{"O", bar.O}, {"A", bar.A}});
    figure->velocities = velocity_polygon(bar);
    figure->accelerations = acceleration_polygon(bar);
    const Arrow2 v_A = figure->A().v;
    if (v_A.y != 0) figure->normal_slope = -v_A.x / v_A.y;
    return figure;
  });
}

}  // namespace epure::velocity_centre
