#include "exercises/kit/four_bar.h"

#include <fmt/format.h>

#include "geometry/mechanisms/change_point.h"
#include "geometry/mechanisms/four_bar_questions.h"

namespace epure {
namespace {

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

std::string place(const FourBarInstant& at) {
  const double distance = geometry::root(squared_distance_of_pins<geometry::Fast>(at));
  return fmt::format("at crank angle {:.6g}° the pin A is {:.9g} m from B₀", degrees(at.crank), distance);
}

// Both motions that leave the change point the crank stands at; what they say depends on no speed.
std::string motions_from_change_point(const FourBarInstant& at) {
  using geometry::Fast;
  const geometry::Vector<Fast> crank{geometry::cosine<Fast>(at.crank), geometry::sine<Fast>(at.crank)};
  for (const geometry::FlatPosition& flat : geometry::flat_positions(at.lengths)) {
    if (dot(geometry::crank_direction<Fast>(at.lengths, flat), crank) < 0) continue;
    std::string text;
    for (const auto& motion : geometry::change_point_motions<Fast>(flat)) {
      text += text.empty() ? "" : ", or ";
      text += motion.leaves_to ? fmt::format("ω₃/ω₂ = {:.6g} and ω₄/ω₂ = {:.6g}", motion.omega_3, motion.omega_4)
                               : "the crank rests while coupler and rocker turn together";
    }
    return text;
  }
  return {};
}

[[noreturn]] void refuse_flat_position(const FourBarInstant& at) {
  const geometry::Truth two_motions =
      geometry::ask([&]<class T>() {
        const geometry::Vector<T> crank{geometry::cosine<T>(at.crank), geometry::sine<T>(at.crank)};
        return geometry::is_change_point<T>(at.lengths, crank);
      }).truth;
  if (two_motions == geometry::Truth::undecided)
    throw geometry::Undecided("whether the linkage is at a change point");
  if (two_motions == geometry::Truth::yes)
    throw BadGivens(
        fmt::format("{}, and all hinges are in line: a change point, which two motions leave, with {}; "
                    "choose another instant, if only a little later",
                    place(at), motions_from_change_point(at)));
  throw BadGivens(
      fmt::format("{}, where coupler and rocker are in line: the crank is at a limit position and cannot "
                  "drive the rocker",
                  place(at)));
}

void require_closure(const FourBarInstant& at) {
  const Rational sum = at.lengths.AB + at.lengths.B0B, difference = CGAL::abs(at.lengths.AB - at.lengths.B0B);
  const Sign beyond = compare_distance(at, sum), within = compare_distance(at, difference);
  if (beyond == Sign::undecided || within == Sign::undecided)
    throw geometry::Undecided("whether coupler and rocker reach from A to B₀");
  const double distance = geometry::root(squared_distance_of_pins<geometry::Fast>(at));
  if (beyond == Sign::positive)
    throw BadGivens(fmt::format("the linkage does not close: {}, and AB + B₀B = {:.9g} m is too short by {:.3g} m",
                                place(at), CGAL::to_double(sum), distance - CGAL::to_double(sum)));
  if (within == Sign::negative)
    throw BadGivens(fmt::format(
        "the linkage does not close: {}, and AB and B₀B, which differ by {:.9g} m, cannot fold up to it by "
        "{:.3g} m",
        place(at), CGAL::to_double(difference), CGAL::to_double(difference) - distance));
  if (beyond == Sign::zero || within == Sign::zero) refuse_flat_position(at);
}

bool is_zero(const geometry::Decision& decided, const char* question) {
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
  if (is_zero(at.n)) throw BadGivens("n = 0 rpm: the crank must turn, n must differ from 0");
  if (at.lengths.x_B0 == 0 && at.lengths.y_B0 == 0)
    throw BadGivens("B₀ = (0, 0) m lies on A₀: there is no frame between the hinges");
  require_closure(at);
  const bool parallel = is_zero(geometry::decide([&]<class T>() { return at.position<T>().pole().w; }),
                                "whether crank and rocker are parallel");
  at.dead_centre = is_zero(geometry::decide([&]<class T>() {
                             const auto here = at.position<T>();
                             return cross(here.A - here.A0, here.B - here.A);
                           }),
                           "whether crank and coupler are in line");
  at.one_line = parallel && at.dead_centre;
  at.pole_at_infinity = parallel && !at.dead_centre;
}

std::vector<QuantitySpec> link_rate_quantities() {
  return {{"omega_3", "$ω_{3}$", "rad/s", {"angular velocity of the coupler", "velocità angolare della biella"}},
          {"omega_4", "$ω_{4}$", "rad/s", {"angular velocity of the rocker", "velocità angolare del bilanciere"}},
          {"alpha_3",
           "$α_{3}$",
           "rad/s^2",
           {"angular acceleration of the coupler", "accelerazione angolare della biella"}},
          {"alpha_4",
           "$α_{4}$",
           "rad/s^2",
           {"angular acceleration of the rocker", "accelerazione angolare del bilanciere"}}};
}

}  // namespace epure
