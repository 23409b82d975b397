// The four polygons as they are drawn: the construction run on Deep, then rounded once.
#include "exercises/kit/panels/rounded.h"
#include "exercises/rivals-polygons/quantities.h"

namespace epure::rivals_polygons {
namespace {

using geometry::Deep;

// What the polygons are made of.
struct Sides {
  const Polygons<Deep>& found;
  bool crank_speeds_up;

  PolygonSide v_A() const {
    return {.quantity = "v_A",
            .label = "$\\vec{v}_{A}$",
            .direction = "⊥ $A_{0}A$",
            .magnitude = "$ω_{2}$·$A_{0}A$",
            .v = to_double(found.velocity.first.known),
            .tip = "$a'$"};
  }
  PolygonSide v_BA() const {
    return {.quantity = "v_BA",
            .label = "$\\vec{v}_{BA}$",
            .direction = "⊥ $BA$",
            .magnitude = "?",
            .v = to_double(found.velocity.first.closing),
            .tip = "$b'$",
            .along = to_double(geometry::quarter_turn(found.at.B - found.at.A))};
  }
  PolygonSide v_B() const {
    return {.quantity = "v_B",
            .label = "$\\vec{v}_{B}$",
            .direction = "∥ $A_{0}B$",
            .magnitude = "?",
            .v = to_double(found.velocity.v_X),
            .along = to_double(found.at.guide.direction())};
  }
  PolygonSide v_GA() const {
    return {.quantity = "v_GA",
            .label = "$\\vec{v}_{GA}$",
            .direction = "⊥ $GA$",
            .magnitude = "$ω_{3}$·$AG$",
            .v = to_double(found.v_GA()),
            .tip = "$g'$"};
  }
  PolygonSide v_G() const {
    return {.quantity = "v_G",
            .label = "$\\vec{v}_{G}$",
            .direction = "?",
            .magnitude = "?",
            .v = to_double(found.v_G())};
  }
  PolygonSide a_A_n() const {
    return {.quantity = "a_A_n",
            .label = "$\\vec{a}^{n}_{A}$",
            .direction = "∥ $AA_{0}$",
            .magnitude = "$ω^{2}_{2}$·$A_{0}A$",
            .v = to_double(found.a_A_n),
            .tip = crank_speeds_up ? "" : "$a'$"};
  }
  PolygonSide a_A_t() const {
    return {.quantity = "a_A_t",
            .label = "$\\vec{a}^{t}_{A}$",
            .direction = crank_speeds_up ? "⊥ $A_{0}A$" : "–",
            .magnitude = crank_speeds_up ? "$α_{2}$·$A_{0}A$" : "0",
            .v = to_double(found.a_A_t),
            .tip = "$a'$",
            .square = true};
  }
  PolygonSide a_BA_n() const {
    return {.quantity = "a_BA_n",
            .label = "$\\vec{a}^{n}_{BA}$",
            .direction = "∥ $BA$",
            .magnitude = "$ω^{2}_{3}$·$AB$",
            .v = to_double(found.acceleration.first.normal)};
  }
  PolygonSide a_BA_t() const {
    return {.quantity = "a_BA_t",
            .label = "$\\vec{a}^{t}_{BA}$",
            .direction = "⊥ $BA$",
            .magnitude = "?",
            .v = to_double(found.acceleration.first.closing),
            .tip = "$b'$",
            .along = to_double(geometry::quarter_turn(found.at.B - found.at.A)),
            .square = true};
  }
  PolygonSide a_B() const {
    return {.quantity = "a_B",
            .label = "$\\vec{a}_{B}$",
            .direction = "∥ $A_{0}B$",
            .magnitude = "?",
            .v = to_double(found.acceleration.a_X),
            .along = to_double(found.at.guide.direction())};
  }
  PolygonSide a_GA_n() const {
    return {.quantity = "a_GA_n",
            .label = "$\\vec{a}^{n}_{GA}$",
            .direction = "∥ $GA$",
            .magnitude = "$ω^{2}_{3}$·$AG$",
            .v = to_double(found.a_GA_n())};
  }
  PolygonSide a_GA_t() const {
    return {.quantity = "a_GA_t",
            .label = "$\\vec{a}^{t}_{GA}$",
            .direction = "⊥ $GA$",
            .magnitude = "$α_{3}$·$AG$",
            .v = to_double(found.a_GA_t()),
            .tip = "$g'$",
            .square = true};
  }
  PolygonSide a_G() const {
    return {.quantity = "a_G",
            .label = "$\\vec{a}_{G}$",
            .direction = "?",
            .magnitude = "?",
            .v = to_double(found.a_G())};
  }
};

VectorPolygon of_velocities(std::vector<PolygonSide> left, std::vector<PolygonSide> right) {
  return {.meaning = Meaning::velocity,
          .unit = "m/s",
          .origin = "$O_{v}$",
          .left = std::move(left),
          .right = std::move(right)};
}
VectorPolygon of_accelerations(std::vector<PolygonSide> left, std::vector<PolygonSide> right) {
  return {.meaning = Meaning::acceleration,
          .unit = "m/s²",
          .origin = "$O_{a}$",
          .left = std::move(left),
          .right = std::move(right)};
}

}  // namespace

Drawn drawn(const Instant& instant) {
  return deeply([&] {
    const Polygons<Deep> found = polygons<Deep>(instant);
    const Sides sides{found, !is_zero(instant.crank.alpha_2)};
    Drawn figure;
    figure.mechanism.A = to_double(found.at.A);
    figure.mechanism.B = to_double(found.at.B);
    figure.mechanism.G = to_double(found.at.C);
    figure.mechanism.sense = sign_of(instant.crank.n);
    figure.velocity_of_B = of_velocities({sides.v_B()}, {sides.v_A(), sides.v_BA()});
    figure.velocity_of_G = of_velocities({sides.v_G()}, {sides.v_A(), sides.v_GA()});
    figure.acceleration_of_B =
        of_accelerations({sides.a_B()}, {sides.a_A_n(), sides.a_A_t(), sides.a_BA_n(), sides.a_BA_t()});
    figure.acceleration_of_G =
        of_accelerations({sides.a_G()}, {sides.a_A_n(), sides.a_A_t(), sides.a_GA_n(), sides.a_GA_t()});
    figure.omega_2 = to_double(found.crank.omega);
    figure.omega_3 = to_double(found.coupler.omega);
    figure.alpha_3 = to_double(found.coupler.alpha);
    figure.a_B_as_printed = to_double(found.a_B_as_printed());
    return figure;
  });
}

}  // namespace epure::rivals_polygons
