#include "exercises/friction-efficiency/problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/statement/given_number.h"
#include "geometry/numbers/climb.h"

namespace epure::friction_efficiency {
namespace {

using geometry::Sign;

const Angle& right_angle() {
  static const Angle quarter{Rational(1, 4)};
  return quarter;
}

constexpr int figures_of_degrees = 6;

// `limit`: the friction angle at which the mechanism jams, in degrees; φ is it, or beyond it, however little.
[[noreturn]] void refuse_jammed(const Angle& phi, const Words& mechanism, double limit, bool is_at_limit) {
  const auto figures = figures_that_tell_apart(geometry::degrees(phi), limit);
  const Words excess = is_at_limit || figures
                           ? Words{}
                           : Words{" (it is beyond by less than 10^-12°)", " (lo supera di meno di 10^-12°)"};
  const int told = is_at_limit ? figures_of_degrees : figures.value_or(figures_of_degrees);
  throw BadGivens(format_words(
      "phi = {}°: must be less than {}°{}, at which {} jams in the direct motion: the force P is infinite there",
      "phi = {}°: dev'essere minore di {}°{}, a cui {} s'impunta nel moto diretto: la forza P vi è infinita",
      told_degrees(phi, std::max(12, told)), decimal(limit, told), excess, mechanism));
}
void require_below(const Angle& phi, const Angle& limit, const Words& mechanism) {
  if (const int left = sign_of(limit - phi); left <= 0)
    refuse_jammed(phi, mechanism, geometry::degrees(limit), left == 0);
}

// The rod jams when the line of the wedge's force on it passes through K, where the collar's two forces meet:
//   a - (a t + 2 m t) μ + (w t - 2 m) μ² + w μ³ = 0,   a and m the collar's length and the height of its middle.
template <class T>
T room_before_jam(const Wedge& of, const T& mu) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T t = geometry::quotient(geometry::sine<T>(of.theta), geometry::cosine<T>(of.theta));
  const T a = number(of.y_upper - of.y_lower), twice_m = number(of.y_upper + of.y_lower), w = number(of.w);
  return a - (a + twice_m) * t * mu + (w * t - twice_m) * geometry::square(mu) + w * mu * geometry::square(mu);
}
void require_moving_rod(const Wedge& of, const Angle& phi) {
  const Sign left =
      geometry::decide([&]<class T>() {
        return room_before_jam<T>(of, geometry::quotient(geometry::sine<T>(phi), geometry::cosine<T>(phi)));
      }).sign;
  if (left == Sign::positive) return;
  // For the sentence, in doubles: the first of what may be several such angles.
  constexpr int steps = 4096, halvings = 60;
  const double at_most = std::tan(geometry::to_double(phi));
  int step = 1;
  while (step < steps && room_before_jam<double>(of, at_most * step / steps) > 0) ++step;
  double moves = at_most * (step - 1) / steps, jams = at_most * step / steps;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (moves + jams) / 2;
    (room_before_jam<double>(of, middle) > 0 ? moves : jams) = middle;
  }
  refuse_jammed(phi, {"the rod in its collar of two forces", "l'asta nel collare a due forze"},
                std::atan(jams) * 180 / std::numbers::pi, left == Sign::zero);
}

// On the line of hinges the contact is the levers' relative pole: they roll there, and friction has no sense.
void require_sliding(const Levers& of, const Angle& phi, const std::string& name) {
  if (of.y_C != 0 || is_zero(phi)) return;
  throw BadGivens(
      format_words("{}.y_C = 0 m: the contact lies on the line of hinges, where the levers do not slide on each "
                   "other, and friction has no sense",
                   "{}.y_C = 0 m: il contatto sta sulla retta delle cerniere, dove le leve non strisciano l'una "
                   "sull'altra, e l'attrito non ha verso",
                   name));
}

// Turned by friction past the hinge of the lever that Q loads, the contact could hold that lever only by pulling it.
void require_pressure(const Levers& of, const Angle& phi, const Words& which) {
  const Sign ideal = turned_from_C(of, of.loaded, of.nu);
  for (const Angle& direction : {of.nu - phi, of.nu + phi})
    if (turned_from_C(of, of.loaded, direction) != ideal)
      throw BadGivens(
          format_words("phi = {}°: {} jam, and no force P moves them: the contact's force, at {}° then, does not "
                       "pass its hinge on the side on which it holds the lever that Q loads",
                       "phi = {}°: {} s'impuntano, e nessuna forza P le muove: la forza di contatto, allora a {}°, "
                       "non passa dalla parte della cerniera dalla quale regge la leva caricata da Q",
                       told_degrees(phi), which, told_degrees(direction)));
}

// The contact's force passes through the hinge of P's lever. (Not in the direct motion, in which P has to supply what
// Q takes and friction loses.)
bool is_at_limit(const Levers& of, const Angle& phi) {
  const auto passes = [&](const Angle& direction) { return turned_from_C(of, of.driven(), direction) == Sign::zero; };
  return passes(of.nu - phi) || passes(of.nu + phi);
}

// The link's force must stand above the friction cone of slider 4: sin(θ - φ) > sin δ = 2 r sin φ/l.
void require_moving_link(const DoubleSlider& of, const Angle& phi, const Rational& radius) {
  const Sign above = geometry::decide([&]<class T>() {
                       return geometry::from_rational<T>(of.l) * geometry::sine<T>(of.theta - phi) -
                              geometry::from_rational<T>(2 * radius) * geometry::sine<T>(phi);
                     }).sign;
  if (above == Sign::positive) return;
  const double theta = geometry::to_double(of.theta), ratio = CGAL::to_double(2 * radius / of.l);
  const double limit = std::atan2(std::sin(theta), ratio + std::cos(theta)) * 180 / std::numbers::pi;
  refuse_jammed(phi, {"the double slider with friction in its pins", "il doppio pattino con attrito nei perni"},
                limit, above == Sign::zero);
}

}  // namespace

std::vector<GivenSpec> stated_givens() {
  std::vector<GivenSpec> all = givens_of_loaded_mechanisms();
  all.push_back({"phi",
                 {"friction angle at every contact", "angolo d'attrito di ogni contatto"},
                 "deg",
                 "5",
                 Range::not_negative,
                 "$φ$"});
  all.push_back({"double_slider_pins.r",
                 {"radius of the pins, double slider", "raggio dei perni, doppio pattino"},
                 "m",
                 "0.010",
                 Range::positive,
                 "$r$"});
  return all;
}

Words why_no_sliding(const Fairbairn& of, const std::string& name) {
  const Words where = of.touches ? Words{"the crank stands square to the lever, which rests",
                                         "la manovella sta normale alla leva, che è ferma"}
                                 : Words{"the lever stands upright", "la leva è verticale"};
  return format_words("{}.theta = {}°: {}: the bodies do not slide on each other, and friction has no sense",
                      "{}.theta = {}°: {}: i corpi non strisciano l'uno sull'altro, e l'attrito non ha verso", name,
                      told_degrees(of.theta), where);
}

Problem::Problem(const Givens& givens)
    : of(givens), phi(givens.angle("phi")), radius(givens["double_slider_pins.r"]) {
  const Angle &theta = of.wedge.theta, &slope = of.double_slider.theta;
  // Fairbairn's ram jams at 45°, beyond any wedge.
  require_below(phi, Rational(1, 2) * (right_angle() - theta), {"the wedge", "il cuneo"});
  require_below(phi, slope, {"the double slider", "il doppio pattino"});
  require_moving_rod(of.wedge, phi);
  require_sliding(of.levers, phi, "sliding_levers");
  require_sliding(of.levers_Q_on_2, phi, "sliding_levers_Q_on_2");
  require_pressure(of.levers, phi, {"the sliding levers with Q on 3", "le leve striscianti con Q sulla 3"});
  require_pressure(of.levers_Q_on_2, phi, {"the sliding levers with Q on 2", "le leve striscianti con Q sulla 2"});
  if (is_zero(phi) || 2 * radius == of.double_slider.l) tilt = phi;
  wedge_at_limit = phi == Rational(1, 2) * theta;
  double_slider_at_limit = phi == right_angle() - slope;
  pins_at_limit = tilt && phi + *tilt == right_angle() - slope;
  levers_at_limit = is_at_limit(of.levers, phi);
  levers_Q_on_2_at_limit = is_at_limit(of.levers_Q_on_2, phi);
  const Sign reaches = geometry::decide([&]<class T>() {
                         return geometry::from_rational<T>(of.double_slider.l) -
                                geometry::from_rational<T>(2 * radius) * geometry::sine<T>(phi);
                       }).sign;
  if (reaches != Sign::positive)
    throw BadGivens(
        format_words("double_slider_pins.r = {} m: the friction circles are wider than the link is long",
                     "double_slider_pins.r = {} m: i cerchi d'attrito sono più larghi della lunghezza dell'asta",
                     decimal(CGAL::to_double(radius), 6)));
  require_moving_link(of.double_slider, phi, radius);
}

}  // namespace epure::friction_efficiency
