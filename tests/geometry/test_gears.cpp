// Pairs of involute gears, constructed and by formulas, held against a corpus that knows the generating rack only.
#include "geometry/analytic/gear_limits.h"
#include "geometry/gears/faults.h"
#include "geometry/gears/limits.h"
#include "geometry/gears/sliding.h"
#include "geometry/gears/tooth_thickness.h"
#include "tests/geometry/every_number.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

#include <algorithm>
#include <functional>
#include <map>

using namespace epure::geometry;
using namespace epure::tests;

namespace {

using Kind = Fault::Kind;

const std::vector<CorpusCase>& gears() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/gears.txt");
  return cases;
}

long whole(const Rational& z) { return mpz_get_si(z.numerator().mpz()); }

PairData pair_of(const CorpusCase& c) {
  const auto at = [&](const char* symbol) { return c.givens.at(symbol); };
  const std::string& kind = c.choices.at("kind");
  return {.kind = kind == "internal" ? PairKind::internal
                  : kind == "rack"   ? PairKind::rack
                                     : PairKind::external,
          .z1 = whole(at("z1")),
          .z2 = whole(at("z2")),
          .m = at("m") / 1000,
          .alpha = {at("alpha") / 360},
          .x1 = at("x1"),
          .x2 = kind == "rack" ? Rational(0) : at("x2"),
          .ha = at("ha"),
          .hf = at("hf"),
          .k = at("k"),
          .rho = at("rho"),
          .j = at("j") / 1000};
}

analytic::Gears formulas_of(const PairData& of) {
  const auto mate = of.kind == PairKind::internal ? analytic::Mate::ring
                    : of.kind == PairKind::rack   ? analytic::Mate::rack
                                                  : analytic::Mate::wheel;
  return {mate, of.z1, of.z2, of.m, of.alpha, of.x1, of.x2, of.ha, of.hf, of.k, of.j};
}

template <class T>
using Values = std::map<std::string, T>;

template <class T>
Values<T> constructed(const PairData& of) {
  const GearPair<T> pair = gear_pair<T>(of);
  Values<T> v{{"centre_distance", pair.O2 ? distance(pair.O1, *pair.O2) : pair.centre_distance},
              {"path_of_approach", -pair.position(pair.A())},
              {"path_of_recess", pair.position(pair.E())},
              {"interference_limit_approach", -pair.position(pair.T1)},
              {"start_of_active_profile_radius_1", distance(pair.O1, pair.A())},
              {"tooth_thickness_tip_1", tip_thickness(pair, 1)},
              {"tooth_thickness_tip_2", tip_thickness(pair, 2)},
              {"tooth_thickness_base_1", base_thickness(pair, 1)},
              {"specific_sliding_1_approach", flank_velocities(pair, T(3), pair.A()).specific_1()},
              {"specific_sliding_2_recess", flank_velocities(pair, T(3), pair.E()).specific_2()}};
  if (pair.O2) {
    v.emplace("r_w_2", pair.wheel2->r_w);
    v.emplace("start_of_active_profile_radius_2", distance(*pair.O2, pair.E()));
    v.emplace("max_tip_radius_2_without_interference", distance(*pair.O2, pair.T1));
    v.emplace("tooth_thickness_base_2", base_thickness(pair, 2));
    v.emplace("tooth_thickness_working_2", tooth_thickness(pair, 2, pair.wheel2->r_w, pair.alpha_w));
  }
  return v;
}

template <class T>
Values<T> calculated(const PairData& of) {
  const analytic::GearFormulas<T> by = analytic::gear_formulas<T>(formulas_of(of));
  Values<T> v{{"centre_distance", by.a()},
              {"path_of_approach", by.path_of_approach()},
              {"path_of_recess", by.path_of_recess()},
              {"interference_limit_approach", by.limit_of_path(1)},
              {"start_of_active_profile_radius_1", by.start_of_active_profile(1)},
              {"tooth_thickness_tip_1", by.tip_thickness(1)},
              {"tooth_thickness_base_1", by.base_thickness(1)},
              {"contact_ratio", by.contact_ratio()},
              {"specific_sliding_1_approach", by.specific_sliding_1(-by.path_of_approach())},
              {"specific_sliding_2_recess", by.specific_sliding_2(by.path_of_recess())}};
  if (of.kind != PairKind::rack) {
    v.emplace("r_w_2", by.r_w(2));
    v.emplace("start_of_active_profile_radius_2", by.start_of_active_profile(2));
    v.emplace("max_tip_radius_2_without_interference", by.limit_of_tip(2));
    v.emplace("tooth_thickness_tip_2", by.tip_thickness(2));
    v.emplace("tooth_thickness_working_2", by.working_thickness(2));
  }
  return v;
}

// Bounded and Deep enclose every reference; Fast is off by no more than Bounded is wide, and a little of rounding.
template <class Find>
void hold(const CorpusCase& c, const Find& find) {
  const PairData of = pair_of(c);
  const Arithmetic<Bounded> bounded;
  const Arithmetic<Deep> deep(224);
  const Values<Bounded> enclosed = find.template operator()<Bounded>(of);
  const Values<Deep> narrowed = find.template operator()<Deep>(of);
  Values<Fast> computed;
  {
    const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
    computed = find.template operator()<Fast>(of);
  }
  for (const auto& [name, x] : narrowed) {
    const std::string reference = c.reference(name);
    CAPTURE(c.name, c.why, name, reference);
    REQUIRE_FALSE(reference.empty());
    const Rational expected = exact_decimal(reference);
    CHECK(overlaps(x, expected));
    if (expected != 0) CHECK(narrow(x));
    const Bounded& around = enclosed.at(name);
    CHECK(overlaps(enclosure(around), expected));
    const double slack = 4 * (around.sup() - around.inf()) + 1e-15 * CGAL::to_double(CGAL::abs(expected));
    CHECK(std::abs(computed.at(name) - CGAL::to_double(expected)) <= slack);
  }
}

std::vector<Kind> kinds(const PairData& of) {
  std::vector<Kind> found;
  for (const Fault& fault : faults(of)) {
    CAPTURE(fault.reason.english);
    CHECK_FALSE(fault.undecided);
    found.push_back(fault.kind);
  }
  return found;
}
bool has(const PairData& of, Kind kind) {
  const std::vector<Kind> found = kinds(of);
  return std::count(found.begin(), found.end(), kind) > 0;
}

Angle degrees(int whole_degrees) { return {Rational(whole_degrees, 360)}; }
PairData source() { return {.z1 = 20, .z2 = 40, .m = Rational(1, 100), .alpha = degrees(22)}; }
PairData with_teeth(long z, int angle) { return {.z1 = z, .z2 = 40, .m = Rational(1, 100), .alpha = degrees(angle)}; }

const std::vector<const char*> hairs{"1e-9", "1e-15", "1e-30"};

}  // namespace

TEST_CASE("gears: the construction encloses the corpus", "[gears]") {
  CHECK(gears().size() == 25);
  for (const CorpusCase& c : gears()) hold(c, []<class T>(const PairData& of) { return constructed<T>(of); });
}

TEST_CASE("gears: the closed formulas enclose the corpus", "[gears]") {
  for (const CorpusCase& c : gears()) hold(c, []<class T>(const PairData& of) { return calculated<T>(of); });
}

TEST_CASE("gears: least numbers of teeth are those found by counting", "[gears]") {
  for (const CorpusCase& c : gears()) {
    CAPTURE(c.name, c.why);
    const PairData of = pair_of(c);
    const long rack = std::stol(c.reference("minimum_teeth_no_undercut_rack"));
    const long pinion = std::stol(c.reference("minimum_teeth_pinion_for_this_ratio"));
    CHECK(minimum_teeth_against_rack(of, of.x1) == rack);
    CHECK(analytic::minimum_teeth_against_rack(formulas_of(of)) == rack);
    CHECK(minimum_teeth_of_pinion(of) == pinion);
    CHECK(analytic::minimum_teeth_of_pinion(formulas_of(of)) == pinion);
    if (const std::string tips = c.reference("tips_collide"); !tips.empty())
      CHECK(has(of, Kind::tips_collide) == (tips == "1"));
  }
}

TEST_CASE("gears: with algebraic angles every special point lies exactly where it should, also on Exact and Calcium",
          "[gears]") {
  const auto check = []<class T>() {
    const Scope<T> scope;
    for (const PairKind kind : {PairKind::external, PairKind::internal, PairKind::rack}) {
      PairData of = source();
      of.kind = kind;
      of.z2 = 60;
      of.alpha = degrees(30);
      const GearPair<T> pair = gear_pair<T>(of);
      CHECK(is(distance(pair.O1, pair.T1), pair.wheel1.r_b));
      CHECK(is(distance(pair.O1, pair.E()), pair.wheel1.r_tip));
      CHECK(is_on(pair.A(), pair.line_of_action));
      CHECK(is_on(pair.T1, pair.line_of_action));
      CHECK(is(pair.at(pair.position(pair.E())), pair.E()));
      if (!pair.O2) continue;
      CHECK(is(distance(*pair.O2, *pair.T2), pair.wheel2->r_b));
      CHECK(is(distance(*pair.O2, pair.A()), pair.wheel2->r_tip));
      CHECK(is(distance(pair.O1, *pair.O2), pair.centre_distance));
    }
  };
  check.operator()<Fast>();
  check.operator()<Bounded>();
  check.operator()<Deep>();
  check.operator()<Exact>();
  check.operator()<Calcium>();
}

TEST_CASE("gears: 8 teeth at 30 degrees are the limit of undercut, proved; a hair less is undercut", "[gears]") {
  // 2/sin²30° = 8 and 2/sin²45° = 4; at 60 degrees 3 teeth are the limit for ha = 9/8.
  const auto room = [](const PairData& of) { return room_above_undercut(of, 1).sign; };
  CHECK(room(with_teeth(8, 30)) == Sign::zero);
  CHECK(room(with_teeth(4, 45)) == Sign::zero);
  PairData sixty = with_teeth(3, 60);
  sixty.ha = Rational(9, 8);
  CHECK(room(sixty) == Sign::zero);
  CHECK(room(with_teeth(7, 30)) == Sign::negative);
  CHECK(room(with_teeth(9, 30)) == Sign::positive);
  CHECK_FALSE(has(with_teeth(8, 30), Kind::undercut));
  CHECK(has(with_teeth(7, 30), Kind::undercut));
  for (const char* hair : hairs)
    for (const int angle : {30, 45}) {
      CAPTURE(hair, angle);
      PairData of = with_teeth(angle == 30 ? 8 : 4, angle);
      of.x1 = -exact_decimal(hair);
      CHECK(room(of) == Sign::negative);
      CHECK(minimum_teeth_against_rack(of, of.x1) == of.z1 + 1);
      of.x1 = exact_decimal(hair);
      CHECK(room(of) == Sign::positive);
      CHECK(minimum_teeth_against_rack(of, of.x1) == of.z1);
    }
}

TEST_CASE("gears: the least numbers of teeth that the books print", "[gears]") {
  // For the full depth ha = 1: 17.1 at 20 degrees (DIN 3960), 31.9 at 14.5, 11.2 at 25, 29.9 at 15.
  const std::vector<std::pair<Rational, long>> printed{
      {20, 18}, {Rational(29, 2), 32}, {25, 12}, {15, 30}, {22, 15}, {30, 8}, {45, 4}, {60, 3}};
  for (const auto& [angle, least] : printed) {
    PairData of = source();
    of.alpha = {angle / 360};
    CAPTURE(least);
    CHECK(minimum_teeth_against_rack(of, 0) == least);
    of.z1 = least;
    CHECK_FALSE(has(of, Kind::undercut));
    of.z1 = least - 1;
    CHECK(has(of, Kind::undercut));
  }
  // 20 degrees, ha = 1: 13 teeth mesh with 13, 14 up to 26, 17 up to 1309 (Norton, Design of Machinery, table 9-5).
  const std::vector<std::pair<long, long>> largest_gear{{13, 16}, {14, 26}, {15, 45}, {16, 101}, {17, 1309}};
  for (const auto& [pinion, gear] : largest_gear) {
    PairData of = with_teeth(pinion, 20);
    CAPTURE(pinion, gear);
    of.z2 = gear;
    CHECK_FALSE(has(of, Kind::interference_approach));
    CHECK(minimum_teeth_of_pinion(of) == pinion);
    of.z2 = gear + 1;
    CHECK(has(of, Kind::interference_approach));
    CHECK(minimum_teeth_of_pinion(of) == pinion + 1);
  }
}

TEST_CASE("gears: a mate's tip exactly on T1 does not interfere, a hair beyond it does", "[gears]") {
  // At 30 degrees with u = z2/z1 = 21/10 and ha = 1 the ring's condition 4 - 4 u z + z² (2u - 1)/4 has the root z =
  // 10; with u = 5/6 and ha = 2 the external one, z² (2u + 1)/4 - 8 u z - 16, has the root z = 12.
  PairData ring = with_teeth(10, 30);
  ring.kind = PairKind::internal;
  ring.z2 = 21;
  PairData external = with_teeth(12, 30);
  external.z2 = 10;
  external.ha = 2;
  for (PairData of : {ring, external}) {
    const Rational ha = of.ha;
    CHECK(room_in_approach(of).sign == Sign::zero);
    CHECK(minimum_teeth_of_pinion(of) == of.z1);
    CHECK(analytic::minimum_teeth_of_pinion(formulas_of(of)) == of.z1);
    CHECK(decide([&]<class T>() -> T { return interference_limit_teeth<T>(of) - T(static_cast<int>(of.z1)); }).sign ==
          Sign::zero);
    CHECK_FALSE(has(of, Kind::interference_approach));
    for (const char* hair : hairs) {
      CAPTURE(hair);
      of.ha = ha + exact_decimal(hair);
      CHECK(has(of, Kind::interference_approach));
      CHECK(minimum_teeth_of_pinion(of) == of.z1 + 1);
      of.ha = ha - exact_decimal(hair);
      CHECK_FALSE(has(of, Kind::interference_approach));
    }
  }
}

TEST_CASE("gears: the source's pair has no fault; each change brings its own", "[gears]") {
  CHECK(kinds(source()).empty());
  const auto changed = [](const std::function<void(PairData&)>& change) {
    PairData of = source();
    change(of);
    return of;
  };
  CHECK(has(changed([](PairData& p) { p.z1 = 14; }), Kind::undercut));
  CHECK(kinds(changed([](PairData& p) { p.z1 = 15; })) == std::vector{Kind::undercut_by_edge});
  CHECK(
      kinds(changed([](PairData& p) { p.z1 = 16; })).empty());  // the edge reaches 1.25 - (1 - sin 22°)/4: 15.6 teeth
  CHECK(has(changed([](PairData& p) { p.x1 = Rational(3, 2); }), Kind::pointed));
  CHECK(has(changed([](PairData& p) { p.ha = 2, p.hf = Rational(5, 2); }), Kind::pointed));
  CHECK(has(changed([](PairData& p) { p.ha = Rational(1, 2); }), Kind::contact_ratio_below_one));
  CHECK(has(changed([](PairData& p) { p.z1 = 11; }), Kind::interference_approach));
  CHECK(has(changed([](PairData& p) { p.z1 = 22, p.z2 = 11; }), Kind::interference_recess));
  CHECK_FALSE(has(changed([](PairData& p) { p.z1 = 24, p.z2 = 12; }), Kind::interference_recess));
  CHECK(has(changed([](PairData& p) { p.hf = Rational(9, 10); }), Kind::negative_clearance));
  CHECK_FALSE(has(changed([](PairData& p) { p.hf = 1; }), Kind::negative_clearance));
  CHECK(has(changed([](PairData& p) { p.hf = 1 - exact_decimal("1e-30"); }), Kind::negative_clearance));
  CHECK(has(changed([](PairData& p) { p.rho = 1; }), Kind::pointed_cutter));
  CHECK(has(changed([](PairData& p) { p.alpha = degrees(45); }), Kind::pointed_cutter));
  CHECK(has(changed([](PairData& p) { p.kind = PairKind::internal, p.z2 = 22; }), Kind::tip_inside_base));
  CHECK(has(changed([](PairData& p) { p.kind = PairKind::internal, p.z2 = 40; }), Kind::contact_on_fillet));
  CHECK(kinds(changed([](PairData& p) { p.kind = PairKind::rack; })).empty());
  CHECK(has(changed([](PairData& p) { p.kind = PairKind::rack, p.z1 = 14; }), Kind::interference_approach));
}

TEST_CASE("gears: tip circles of a ring and its wheel that only touch", "[gears]") {
  // a = m, r_tip1 = 21 m, r_tip2 = 20 m: the circles touch at the back of the mesh, and the ring's lies inside.
  PairData behind = with_teeth(40, 20);
  behind.kind = PairKind::internal;
  behind.z2 = 42;
  CHECK(has(behind, Kind::tips_collide));
  // Both tip circles are the pitch circles, which touch in P0.
  PairData in_P0 = with_teeth(40, 45);
  in_P0.kind = PairKind::internal;
  in_P0.z2 = 42;
  in_P0.ha = in_P0.k = Rational(1, 10);
  CHECK_FALSE(has(in_P0, Kind::tips_collide));
}

TEST_CASE("gears: a single tooth without a working pressure angle is not the least", "[gears]") {
  PairData of = with_teeth(73, 45);
  of.z2 = 9;
  of.x2 = Rational(-23, 100);
  of.ha = Rational(1, 10);
  // 1 tooth in this ratio: inv 45° = 0.2146, less 0.46/1.123; 2 teeth: less 0.46/2.247.
  CHECK(minimum_teeth_of_pinion(of) == 2);
  CHECK(analytic::minimum_teeth_of_pinion(formulas_of(of)) == 2);
}

TEST_CASE("gears: where the shifts leave no working pressure angle", "[gears]") {
  PairData of = source();
  of.x1 = -1;
  of.x2 = Rational(1, 2);
  // inv 22° = 0.020054, less 2 tan 22° x/60: negative from -1.489 on.
  CHECK_NOTHROW(faults(of));
  of.x2 = Rational(-1, 2);
  CHECK_THROWS_AS(faults(of), Impossible);
}

TEST_CASE("gears: teeth fill the working pitch circle but for the backlash, in any pair", "[gears]") {
  Random random(seed());
  const Arithmetic<Deep> scope(160);
  for (int i = 0; i < 200; ++i) {
    PairData of{.z1 = 5 + random.up_to(200),
                .z2 = 0,
                .m = random.power_of_ten(-4, 0),
                .alpha = degrees(10 + random.up_to(30))};
    of.kind = random.up_to(2) == 0 ? PairKind::external : PairKind::internal;
    of.z2 = of.z1 + 5 + random.up_to(500);
    of.x1 = random.fraction() / 20;
    of.x2 = of.x1 + CGAL::abs(random.fraction()) / 2;  // a working pressure angle of either kind
    if (of.kind == PairKind::external) of.x1 = CGAL::abs(of.x1);
    of.j = of.m * random.power_of_ten(-6, -2);
    const GearPair<Deep> pair = gear_pair<Deep>(of);
    const Deep teeth = tooth_thickness(pair, 1, pair.wheel1.r_w, pair.alpha_w) +
                       tooth_thickness(pair, 2, pair.wheel2->r_w, pair.alpha_w) + from_rational<Deep>(of.j);
    const Deep pitch = quotient(Deep(2) * pi<Deep>() * pair.wheel1.r_w, from_rational<Deep>(Rational(of.z1)));
    CAPTURE(of.z1, of.z2, i);
    CHECK(is(quotient(teeth, pitch), Deep(1)));
  }
}
