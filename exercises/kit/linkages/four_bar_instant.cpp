#include "exercises/kit/linkages/four_bar_instant.h"

#include <fmt/format.h>

#include <numbers>

#include "exercises/kit/panels/rounded.h"
#include "geometry/mechanisms/change_point.h"
#include "geometry/mechanisms/four_bar_questions.h"

namespace epure {
namespace {

using geometry::Deep;
using geometry::Sign;

// |AB₀|² for the crank in its place.
template <class T>
T squared_distance_of_pins(const FourBarInstant& at) {
  const geometry::Point<T> B0 = geometry::rocker_hinge<T>(at.lengths);
  const T a = geometry::from_rational<T>(at.lengths.A0A);
  const geometry::Vector<T> AB0{B0.x - a * geometry::cosine<T>(at.crank), B0.y - a * geometry::sine<T>(at.crank)};
  return geometry::length_squared(AB0);
}

Sign compare_distance(const FourBarInstant& at, const Rational& length) {
  return geometry::decide(
             [&]<class T>() { return squared_distance_of_pins<T>(at) - geometry::from_rational<T>(length * length); })
      .sign;
}

Words place(const FourBarInstant& at) {
  const double distance = geometry::root(squared_distance_of_pins<geometry::Fast>(at));
  return format_words("at crank angle {}° the pin A is {} m from B₀",
                      "con la manovella a {}° il perno A dista {} m da B₀", decimal(degrees(at.crank), 6),
                      decimal(distance, 9));
}

// Both motions that leave the change point the crank stands at; what they say depends on no speed.
Words motions_from_change_point(const FourBarInstant& at) {
  using geometry::Fast;
  const geometry::Vector<Fast> crank{geometry::cosine<Fast>(at.crank), geometry::sine<Fast>(at.crank)};
  for (const geometry::FlatPosition& flat : geometry::flat_positions(at.lengths)) {
    if (dot(geometry::crank_direction<Fast>(at.lengths, flat), crank) < 0) continue;
    Words text;
    for (const auto& motion : geometry::change_point_motions<Fast>(flat)) {
      if (!text.empty()) text = text + Words{", or ", ", o "};
      text = text + (motion.leaves_to ? format_words("ω₃/ω₂ = {} and ω₄/ω₂ = {}", "ω₃/ω₂ = {} e ω₄/ω₂ = {}",
                                                     decimal(motion.omega_3, 6), decimal(motion.omega_4, 6))
                                      : Words{"the crank rests while coupler and rocker turn together",
                                              "la manovella ferma mentre biella e bilanciere ruotano insieme"});
    }
    return text;
  }
  return {};
}

// The longest of the four links is as long as the three others: they lie in line, stretched, and in no other way.
bool closes_only_stretched(const geometry::FourBarLengths& of) {
  const Rational a = of.A0A, b = of.AB, c = of.B0B, d2 = geometry::frame_squared(of);
  if (d2 == (a + b + c) * (a + b + c)) return true;
  for (const Rational& d : {Rational(a - b - c), Rational(b - a - c), Rational(c - a - b)})
    if (d > 0 && d2 == d * d) return true;
  return false;
}

[[noreturn]] void refuse_flat_position(const FourBarInstant& at) {
  if (closes_only_stretched(at.lengths))
    throw BadGivens(
        format_words("{}, and all hinges are in line: one link is as long as the three others, so the linkage closes "
                     "in this position alone, and cannot move",
                     "{}, e tutte le cerniere sono allineate: un'asta è lunga quanto le altre tre, quindi il "
                     "meccanismo si chiude in questa sola posizione, e non può muoversi",
                     place(at)));
  const geometry::Truth two_motions =
      geometry::ask([&]<class T>() {
        const geometry::Vector<T> crank{geometry::cosine<T>(at.crank), geometry::sine<T>(at.crank)};
        return geometry::is_change_point<T>(at.lengths, crank);
      }).truth;
  if (two_motions == geometry::Truth::undecided)
    throw geometry::Undecided("whether the linkage is at a change point",
                              "se il meccanismo sia in un punto di cambiamento");
  if (two_motions == geometry::Truth::yes)
    throw BadGivens(
        format_words("{}, and all hinges are in line: a change point, which two motions leave, with {}; choose "
                     "another instant, if only a little later",
                     "{}, e tutte le cerniere sono allineate: un punto di cambiamento, da cui partono due moti, con "
                     "{}; scegliere un altro istante, anche di poco successivo",
                     place(at), motions_from_change_point(at)));
  throw BadGivens(format_words(
      "{}, where coupler and rocker are in line: the crank is at a limit position and cannot drive the rocker",
      "{}, dove biella e bilanciere sono allineati: la manovella è in una posizione limite e non può muovere il "
      "bilanciere",
      place(at)));
}

// The arcs in which the crank can be; none when it turns fully. Ends that are one in doubles are kept apart, but
// where the linkage closes in one position alone. Throws geometry::Impossible when there is no place for it at all.
std::vector<AngleRange> crank_swings(const FourBarInstant& at) {
  std::vector<AngleRange> ranges;
  const auto direction = [](const geometry::CrankLimit<geometry::Fast>& limit) {
    const auto& [x, y] = limit.position.at.A - limit.position.at.A0;
    return geometry::arc_tangent(y, x) * 180 / std::numbers::pi;
  };
  for (const auto& arc : geometry::crank_range<geometry::Fast>(at.lengths).arcs) {
    const double from = direction(arc.from), end = direction(arc.to), to = end < from ? end + 360 : end;
    ranges.push_back({from, from == to && !closes_only_stretched(at.lengths) ? std::nextafter(to, HUGE_VAL) : to});
  }
  return ranges;
}

Words angles_at_which_it_closes(const FourBarInstant& at) {
  try {
    return where_it_closes(crank_swings(at), at.crank);
  } catch (const geometry::Impossible&) {
    return {"; it closes at no angle", "; non si chiude ad alcun angolo"};
  }
}

void require_closure(const FourBarInstant& at) {
  const Rational sum = at.lengths.AB + at.lengths.B0B, difference = CGAL::abs(at.lengths.AB - at.lengths.B0B);
  const Sign beyond = compare_distance(at, sum), within = compare_distance(at, difference);
  if (beyond == Sign::undecided || within == Sign::undecided)
    throw geometry::Undecided("whether coupler and rocker reach from A to B₀",
                              "se biella e bilanciere arrivino da A a B₀");
  const auto beyond_by = [&](const Rational& length) {
    return deeply([&] {
      return to_double(geometry::root(squared_distance_of_pins<Deep>(at)) - geometry::from_rational<Deep>(length));
    });
  };
  if (beyond == Sign::positive)
    throw BadGivens(format_words("the linkage does not close: {}, and AB + B₀B = {} m is too short by {} m{}",
                                 "il meccanismo non si chiude: {}, e AB + B₀B = {} m è troppo corto di {} m{}",
                                 place(at), decimal(CGAL::to_double(sum), 9), decimal(beyond_by(sum), 3),
                                 angles_at_which_it_closes(at)));
  if (within == Sign::negative)
    throw BadGivens(format_words(
        "the linkage does not close: {}, and AB and B₀B, which differ by {} m, cannot fold up to it by {} m{}",
        "il meccanismo non si chiude: {}, e AB e B₀B, che differiscono di {} m, non possono ripiegarsi per {} m{}",
        place(at), decimal(CGAL::to_double(difference), 9), decimal(-beyond_by(difference), 3),
        angles_at_which_it_closes(at)));
  if (beyond == Sign::zero || within == Sign::zero) refuse_flat_position(at);
}

bool is_zero(const geometry::Decision& decided, const Phrase& question) {
  if (decided.sign == Sign::undecided) throw geometry::Undecided(question);
  return decided.sign == Sign::zero;
}

}  // namespace

GivenSpec side_given(const std::string& symbol, const Words& meaning, const std::string& stated,
                     const std::string& point, const std::string& line) {
  return {.symbol = symbol,
          .meaning = meaning,
          .unit = "1",
          .stated = stated,
          .range = Range::any,
          .letters = point,
          .choices = {{"left", {point + " left of " + line, point + " a sinistra di " + line}},
                      {"right", {point + " right of " + line, point + " a destra di " + line}}}};
}

geometry::Side side_chosen(const Givens& givens, const std::string& symbol) {
  return givens.chosen(symbol).word == "left" ? geometry::Side::left : geometry::Side::right;
}

void require_drivable(FourBarInstant& at) {
  require_turning(at.n, at.alpha_2);
  if (at.lengths.x_B0 == 0 && at.lengths.y_B0 == 0)
    throw BadGivens("B₀ = (0, 0) m lies on A₀: there is no frame between the hinges",
                    "B₀ = (0, 0) m sta su A₀: tra le cerniere non c'è telaio");
  require_closure(at);
  const bool parallel =
      is_zero(geometry::decide([&]<class T>() { return at.position<T>().pole().w; }),
              {"whether crank and rocker are parallel", "se manovella e bilanciere siano paralleli"});
  at.dead_centre = is_zero(geometry::decide([&]<class T>() {
                             const auto here = at.position<T>();
                             return cross(here.A - here.A0, here.B - here.A);
                           }),
                           {"whether crank and coupler are in line", "se manovella e biella siano allineate"});
  at.one_line = parallel && at.dead_centre;
  at.pole_at_infinity = parallel && !at.dead_centre;
}

}  // namespace epure
