// A circle or a line that rolls, and a point M that it carries: at one instant, as it is drawn. Places are from the
// contact P0, which is always near: the origin of the fixed plane need not be.
#pragma once

#include <optional>
#include <string>

#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/solution.h"
#include "geometry/motion/rolling.h"

namespace epure {

struct RollingGivens {
  geometry::Rolling rolling;
  Angle phi;           // turned through by the rolling body, in its own sense
  Angle omega, alpha;  // dφ/dt and its derivative

  bool is_line() const { return rolling.how == geometry::Rolls::line_on_circle; }
  bool rolls_on_line() const { return rolling.how == geometry::Rolls::circle_on_line; }
  // M on the rolling line itself: its path is an involute.
  bool unwinds() const { return is_line() && rolling.d == 0; }
};

// Names of quantities at an instant: "cycloid." before, "_at_s4" after.
struct InstantNames {
  std::string before = {}, after = {};
  std::string normal = "a_n";  // what the normal part of the acceleration is called
  std::string omega = "ω";     // the letters of dφ/dt
  std::string operator()(const std::string& quantity) const { return before + quantity + after; }
};

// What a picture needs of the instant, in the axes of `at`, which are those of the contact.
template <class T>
void draws_rolling(Ledger<T>& ledger, const InstantNames& name, const geometry::RollingInstant<T>& at) {
  if constexpr (std::is_same_v<T, geometry::Deep>) {
    const auto vector = [&](const std::string& letter, const geometry::Vector<T>& v) {
      ledger.draws_point(name("drawn_" + letter), {v.x, v.y});
    };
    ledger.draws_point(name("drawn_M"), at.M);
    ledger.draws_point(name("drawn_J"), at.J);
    ledger.draws_point(name("drawn_M_prime"), at.M_prime());
    vector("n", at.n);
    vector("v", at.velocity());
    vector("a", at.acceleration());
    vector("a_n", at.normal_acceleration());
    vector("a_t", at.tangential_acceleration());
    const geometry::ProjectivePoint<T> centre = at.centre_of_curvature();
    const geometry::Sign is_finite = geometry::sign(centre.w);
    if (is_finite != geometry::Sign::zero && is_finite != geometry::Sign::undecided)
      ledger.draws_point(name("drawn_centre"), geometry::finite(centre));
  }
}

struct Rolled {
  RollingGivens given;
  InstantNames names;
  double r, R, d;
  Place M, J, M_prime;
  std::optional<Place> centre = {};  // of curvature; none at infinity
  Arrow2 n, v, a, a_n, a_t;          // n: along the common normal, as in geometry/motion/rolling.h
  bool is_at_cusp;

  static constexpr Place P0 = {0, 0};
  double P0M() const { return distance(P0, M); }
  double inflection_diameter() const { return distance(P0, J); }
  bool runs_straight() const { return geometry::runs_straight(given.rolling); }
  // > 0 when the body turns counter-clockwise.
  int turning() const { return sign_of(given.omega) * geometry::sense(given.rolling); }
  // Of the rolling circle; a line has none.
  std::optional<Place> C() const { return given.is_line() ? std::nullopt : std::optional(P0 + r * n); }
  // Of the fixed circle; a line has none.
  std::optional<Place> O() const;
};
// `given.phi` may be rounded: from it follows which part of the path is drawn, not where M is.
Rolled rolled(const Solution& solution, const RollingGivens& given, const InstantNames& names = {});

// A part of the path, in radians that the body turns: from so much after the instant (before it when negative) to so
// much after it.
struct Way {
  double from, to;
  int arches = 0;       // begun; 0 for a line, whose path has none
  bool closed = false;  // the whole curve
};
// As much as a drawing shows. `overhang`: what of an arch is drawn beyond both ends of a path that does not close.
Way way_of(const RollingGivens& given, double overhang);
// The same, but of a path that goes round the fixed circle again and again a round before the instant and one after.
Way way_around(const RollingGivens& given, double overhang);

}  // namespace epure
