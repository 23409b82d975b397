// Gear flanks at the undercut limit, at pointed teeth, and with a million teeth.
#pragma once

#include "bench/family.h"
#include "geometry/gears/gear_pair.h"
#include "geometry/gears/limits.h"
#include "geometry/gears/right_flank.h"
#include "geometry/gears/tooth_thickness.h"

namespace epure::bench {

struct GearGivens {
  PairData pair;
  Rational radius;  // of a point on wheel 1's flank
};

// The point of wheel 1's right flank at that radius, in the frame of the tooth.
template <class T>
Point<T> flank_point(const GearGivens& of, const GearPair<T>& pair) {
  if constexpr (NumberWithAngles<T>) {
    const T r_b = pair.wheel1.r_b, radius = from_rational<T>(of.radius);
    // Half the angle of the tooth on the base circle, where inv = 0.
    const T half_angle = quotient(base_thickness(pair, 1), T(2) * r_b);
    return RightFlank<T>{r_b, half_angle}(pressure_angle_at(radius, r_b).tangent);
  } else if constexpr (std::is_same_v<T, Exact>) {
    throw LeavesTheTower("a point of an involute", "un punto di un'evolvente");
  } else {
    throw Undecided("a point of an involute is transcendental", "un punto di un'evolvente è trascendente");
  }
}

struct GearFlankPoint {
  static constexpr const char* name = "gear-flank-point";
  static constexpr const char* corpus = "gears.txt";
  using Givens = GearGivens;
  static Givens givens(const CorpusCase& c) {
    const auto given = [&](const char* name) { return c.givens.at(name); };
    const auto whole = [&](const char* name) { return static_cast<long>(given(name).to_double()); };
    return {.pair = {.kind = PairKind::external,
                     .z1 = whole("z1"),
                     .z2 = whole("z2"),
                     .m = given("m"),
                     .alpha = {given("alpha")},
                     .x1 = given("x1"),
                     .x2 = given("x2")},
            .radius = given("radius")};
  }

  // A gear pair is built from its exact data: that is part of every result.
  template <class T>
  using On = Unread<Givens, T>;

  template <class T, class Report>
  static void results(const On<T>& unread, Report& report) {
    const Givens& of = unread.givens;
    const GearPair<T> pair = gear_pair<T>(of.pair);
    report("r_b", [&] { return pair.wheel1.r_b; });
    report("centre_distance", [&] { return pair.centre_distance; });
    report("xi_A", [&] { return pair.position(pair.A()); });
    report("xi_E", [&] { return pair.position(pair.E()); });
    report("tip_thickness", [&] { return tip_thickness(pair, 1); });
    report("x_flank", [&] { return flank_point(of, pair).x; });
    report("y_flank", [&] { return flank_point(of, pair).y; });
  }

  static std::vector<Question> questions(const Givens& of) {
    const auto tip = [of]<class T>() -> T { return tip_thickness(gear_pair<T>(of.pair), 1); };
    return {{"room_above_undercut", [of] { return in_words(room_above_undercut(of.pair, 1)); }},
            {"tip_is", [=] { return in_words(decide(tip)); }},
            {"room_in_approach", [of] { return in_words(room_in_approach(of.pair)); }}};
  }
};

}  // namespace epure::bench
