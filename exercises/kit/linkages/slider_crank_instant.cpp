#include "exercises/kit/linkages/slider_crank_instant.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/panels/rounded.h"
#include "geometry/numbers/climb.h"
#include "geometry/numbers/turn.h"

namespace epure {
namespace {

using geometry::Deep;
using geometry::Sign;

void require_plate(const geometry::SliderCrankLengths& of) {
  const auto longer = [](const char* long_name, const Rational& longest, const char* sum, const Rational& others) {
    if (longest > others) {
      throw BadGivens(format_words("the plate ABC does not close: {} = {} m is longer than {} = {} m by {} m",
                                   "la piastra ABC non si chiude: {} = {} m è più lungo di {} = {} m, di {} m",
                                   std::string(long_name), decimal(CGAL::to_double(longest), 6), std::string(sum),
                                   decimal(CGAL::to_double(others), 6),
                                   decimal(CGAL::to_double(longest - others), 3)));
    }
  };
  longer("AB", of.l, "AC + BC", of.AC + of.BC);
  longer("AC", of.AC, "AB + BC", of.l + of.BC);
  longer("BC", of.BC, "AB + AC", of.l + of.AC);
}

// How far A is from the guide, to its left.
template <class T>
T height_of_A(const SliderCrankInstant& at) {
  return geometry::from_rational<T>(at.lengths.r) * geometry::sine<T>(at.crank_from_guide()) -
         geometry::from_rational<T>(at.lengths.e);
}

Words angles_at_which_it_closes(const SliderCrankInstant& at) {
  const Words text = where_it_closes(crank_swings(at), at.crank);
  if (!text.empty()) return text;
  return format_words("; it closes at no angle, as the guide passes {} m from A₀",
                      "; non si chiude ad alcun angolo, perché la guida passa a {} m da A₀",
                      decimal(CGAL::to_double(CGAL::abs(at.lengths.e)), 6));
}

// The crank is square to the guide: a decision on the rational number of quarter turns between them. Radians in that
// angle never make it one, π being irrational.
bool is_square_to_guide(const SliderCrankInstant& at) {
  const Angle psi = at.crank_from_guide();
  const Rational quarters = 4 * psi.turns;
  return psi.radians == 0 && quarters.denominator() == 1 && mpz_odd_p(quarters.numerator().mpz()) != 0;
}

// The coupler stands square to the guide, at the end of its reach: there the crank is at a limit of its way, unless
// it is square to the guide itself. B lies at s = r cos ψ ± √(l² - (r sin ψ - e)²) along the guide, and from ψ = ±90°
// on the root is √(r l) |dψ| to the first order (two motions), or imaginary on both sides, when |e| = r + l.
[[noreturn]] void refuse_at_reach(const SliderCrankInstant& at) {
  const Words phi = decimal(degrees(at.crank), 6);
  const double r = CGAL::to_double(at.lengths.r), l = CGAL::to_double(at.lengths.l);
  if (!is_square_to_guide(at))
    throw BadGivens(
        format_words("at crank angle {}° the coupler AB = {} m stands square to the guide, where the crank cannot "
                     "drive the slider: its velocity does not exist",
                     "con la manovella a {}° la biella AB = {} m è perpendicolare alla guida, dove la manovella non "
                     "può muovere il corsoio: la sua velocità non esiste",
                     phi, decimal(l, 6)));
  if (CGAL::abs(at.lengths.e) == at.lengths.r + at.lengths.l)
    throw BadGivens(
        format_words("at crank angle {}° crank and coupler are stretched square to the guide: the linkage closes at "
                     "this angle alone, and cannot move",
                     "con la manovella a {}° manovella e biella sono distese perpendicolari alla guida: il "
                     "meccanismo si chiude a questo angolo soltanto, e non può muoversi",
                     phi));
  const double up = within_one_turn(at.crank_from_guide()).turns == Rational(1, 4) ? 1 : -1;
  const auto motion = [&](double omega_3) {  // + 0.0: no zero with a sign
    return format_words("ω₃/ω₂ = {} and v_B/ω₂ = {} m", "ω₃/ω₂ = {} e v_B/ω₂ = {} m", decimal(omega_3, 6),
                        decimal(up * (omega_3 * l - r) + 0.0, 6));
  };
  throw BadGivens(format_words(
      "at crank angle {}° crank and coupler AB = {} m are both square to the guide: a change point, which two "
      "motions leave, with {}, or {}; choose another crank angle, if only a little greater",
      "con la manovella a {}° manovella e biella AB = {} m sono entrambe perpendicolari alla guida: un punto di "
      "cambiamento, da cui partono due moti, con {}, o {}; scegliere un altro angolo, anche di poco maggiore",
      phi, decimal(l, 6), motion(std::sqrt(r / l)), motion(-std::sqrt(r / l))));
}

void require_closure(const SliderCrankInstant& at) {
  const Sign reach =
      geometry::decide([&]<class T>() {
        return geometry::square(geometry::from_rational<T>(at.lengths.l)) - geometry::square(height_of_A<T>(at));
      }).sign;
  if (reach == Sign::positive) return;
  if (reach == Sign::undecided)
    throw geometry::Undecided("whether the coupler reaches the guide", "se la biella raggiunga la guida");
  const double phi = degrees(at.crank);
  const double l = CGAL::to_double(at.lengths.l);
  if (reach == Sign::negative) {
    const auto [height, missing] = deeply([&] {
      const Deep from_guide = geometry::root(geometry::square(height_of_A<Deep>(at)));
      return std::pair{to_double(from_guide), to_double(from_guide - geometry::from_rational<Deep>(at.lengths.l))};
    });
    throw BadGivens(format_words(
        "the linkage does not close: at crank angle {}° the pin A is {} m from the guide, and the coupler AB = {} m "
        "is too short by {} m{}",
        "il meccanismo non si chiude: con la manovella a {}° il perno A dista {} m dalla guida, e la biella AB = {} "
        "m è troppo corta di {} m{}",
        decimal(phi, 6), decimal(height, 6), decimal(l, 6), decimal(missing, 3), angles_at_which_it_closes(at)));
  }
  refuse_at_reach(at);
}

// A₀, A and B in line. Seen from the guide, crank at ψ and coupler have the same sine when the crank points ahead,
// (r + l) sin ψ = e, and opposite ones when it points back, (r - l) sin ψ = e. Only a rational sine can be that (and
// any, when r = l and e = 0: the links stay folded, B on A₀), and of a rational turn these are known: see
// rational_cosine. (With radians in the angle the sine is transcendental.)
bool is_dead_centre(const SliderCrankInstant& at) {
  const auto& [r, l, AC, BC, e] = at.lengths;
  if (is_square_to_guide(at)) return false;
  const Rational length = at.crank_points_ahead() ? r + l : r - l;
  if (length == 0) return e == 0;
  const Angle psi = at.crank_from_guide();
  if (psi.radians != 0) return false;
  const auto sine = geometry::rational_cosine(geometry::turn_for_sine({psi.turns}));
  return sine && length * *sine == e;
}

}  // namespace

std::vector<GivenSpec> slider_crank_givens(bool with_alpha_2) {
  std::vector<GivenSpec> givens{
      {"r", {"crank A₀A", "manovella A₀A"}, "m", "0.20", Range::positive, "$r$"},
      {"l", {"coupler AB", "biella AB"}, "m", "0.50", Range::positive, "$l$"},
      {"BC", {"side BC of the coupler plate", "lato BC della biella"}, "m", "0.40", Range::positive, "$BC$"},
      {"AC", {"side AC of the coupler plate", "lato AC della biella"}, "m", "0.30", Range::positive, "$AC$"},
      {"n",
       {"crank speed, counter-clockwise", "velocità della manovella, antioraria"},
       "rpm",
       "360",
       Range::any,
       "$n$"},
      instant_given("1/72", Range::not_negative, {"t1"}),
      crank_angle_given(),
  };
  if (with_alpha_2) {
    givens.push_back({"alpha_2",
                      {"angular acceleration of the crank", "accelerazione angolare della manovella"},
                      "rad/s^2",
                      "0",
                      Range::any,
                      "$α_{2}$"});
  }
  givens.push_back({.symbol = "e",
                    .meaning = {"offset of the guide from A₀, positive to the left of its direction",
                                "distanza della guida da A₀, positiva a sinistra della sua direzione"},
                    .unit = "m",
                    .stated = "0",
                    .range = Range::any,
                    .letters = "$e$",
                    .beyond_source = true});
  givens.push_back({.symbol = "delta",
                    .meaning = {"direction of the guide, from +x", "direzione della guida, da +x"},
                    .unit = "deg",
                    .stated = "0",
                    .range = Range::any,
                    .letters = "$δ$",
                    .beyond_source = true});
  return givens;
}

SliderCrankInstant slider_crank_instant(const Givens& givens) {
  SliderCrankInstant at{.lengths = {givens["r"], givens["l"], givens["AC"], givens["BC"], givens["e"]},
                        .n = givens.angle("n"),
                        .crank = givens.angle("phi"),
                        .guide = within_one_turn(givens.angle("delta"))};
  for (const GivenSpec& spec : givens.specs()) {
    if (spec.symbol == "alpha_2") at.alpha_2 = givens.angle("alpha_2");
  }
  require_plate(at.lengths);
  require_drivable(at);
  return at;
}

void require_drivable(SliderCrankInstant& at) {
  require_turning(at.n, at.alpha_2);
  require_closure(at);
  at.pole_at_infinity = is_square_to_guide(at);
  at.dead_centre = is_dead_centre(at);
}

bool SliderCrankInstant::crank_points_ahead() const {
  const Angle psi = within_one_turn(crank_from_guide()), quarter{Rational(1, 4)};
  return sign_of(psi - quarter) < 0 || sign_of(psi - Rational(3) * quarter) > 0;
}

std::vector<Deep> crank_limits(const SliderCrankInstant& at) {
  const geometry::CrankRange range = geometry::crank_range(at.lengths);
  if (range.is_empty || range.is_full_turn()) return {};
  const Deep delta = given_in_degrees<Deep>(at.guide), half = geometry::from_rational<Deep>(180);
  const auto degrees = [](const Rational& of_sine) {
    const Deep sine = geometry::from_rational<Deep>(of_sine);
    return in_degrees(geometry::arc_tangent(sine, geometry::root(Deep(1) - geometry::square(sine))));
  };
  if (!range.highest) return {delta + degrees(*range.lowest), delta + half - degrees(*range.lowest)};
  if (!range.lowest) return {delta - half - degrees(*range.highest), delta + degrees(*range.highest)};
  const Deep low = degrees(*range.lowest), high = degrees(*range.highest);
  return {delta + low, delta + high, delta + half - high, delta + half - low};
}

// Ends that are one in doubles are kept apart, but where the linkage is stretched square to its guide.
std::vector<AngleRange> crank_swings(const SliderCrankInstant& at) {
  const bool is_one_place = CGAL::abs(at.lengths.e) == at.lengths.r + at.lengths.l;
  return deeply([&] {
    const std::vector<Deep> limits = crank_limits(at);
    std::vector<AngleRange> ranges;
    for (std::size_t i = 0; i < limits.size(); i += 2) {
      const double from = to_double(limits[i]), to = to_double(limits[i + 1]);
      ranges.push_back({from, from == to && !is_one_place ? std::nextafter(to, HUGE_VAL) : to});
    }
    return ranges;
  });
}

}  // namespace epure
