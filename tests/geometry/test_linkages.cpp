// Linkages of any kind: placed and moved group by group against the equations of all their joints.
#include "tests/geometry/linkage_routes.h"
#include "tests/support/catch.h"

#include <cmath>
#include <functional>
#include <numbers>

using namespace epure;
using namespace epure::geometry;

namespace {

Own own(const char* x, const char* y) { return {Rational(x), Rational(y)}; }
Angle degrees_of(const char* text) { return {Rational(text) / 360}; }
const Angle ten_rad_s{0, 10}, three_rad_s2{0, 3};

struct Named {
  const char* name;
  Linkage linkage;
};

// Points are numbered as they come: A0 0, B0 1, A 2, B 3, ...
Linkage four_bar() {
  return {.links = {{.points = {{0, own("0", "0")}, {1, own("4/10", "0")}}},
                    {.points = {{0, own("0", "0")}, {2, own("12/100", "0")}}},
                    {.points = {{2, own("0", "0")}, {3, own("35/100", "0")}, {4, own("175/1000", "1/10")}}},
                    {.points = {{1, own("0", "0")}, {3, own("28/100", "0")}}}},
          .drives = {TurnedLink{1, degrees_of("60"), ten_rad_s, three_rad_s2}},
          .chosen = {BesideLine{3, 2, 1, true}}};
}

// A block in an inclined, offset guide; the coupler's pin beside the block's own line.
Linkage slider_crank() {
  return {.links = {{.points = {{0, own("0", "0")}}, .lines = {{0, own("0", "-5/100"), Direction{degrees_of("20")}}}},
                    {.points = {{0, own("0", "0")}, {1, own("2/10", "0")}}},
                    {.points = {{1, own("0", "0")}, {2, own("8/10", "0")}}},
                    {.points = {{2, own("0", "3/100")}}, .lines = {{1, own("0", "0"), Direction{own("2", "1")}}}}},
          .blocks = {{1, 0}},
          .drives = {TurnedLink{1, degrees_of("75"), ten_rad_s, three_rad_s2}},
          .chosen = {OnGuide{2, true}}};
}

// Crank, slotted lever, connecting rod, with the pin of the crank in the slot (or a block there).
Linkage quick_return(bool has_block) {
  Linkage of{.links = {{.points = {{0, own("0", "0")}, {1, own("0", "3/10")}},
                        .lines = {{0, own("0", "65/100"), Direction{own("1", "0")}}}},
                       {.points = {{1, own("0", "0")}, {2, own("175/1000", "0")}}},
                       {.points = {{0, own("0", "1/50")}, {3, own("7/10", "0")}},
                        .lines = {{1, own("0", "0"), Direction{own("1", "0")}}}},
                       {.points = {{3, own("0", "0")}, {4, own("8/10", "0")}}}},
             .pins = {{4, 0}},
             .drives = {TurnedLink{1, degrees_of("-75"), ten_rad_s, three_rad_s2}},
             .chosen = {SlotPoints{1, true}, OnGuide{4, true}}};
  if (!has_block) {
    of.pins.push_back({2, 1});
    return of;
  }
  of.links.push_back({.points = {{2, own("0", "1/100")}}, .lines = {{2, own("0", "0"), Direction{own("3", "4")}}}});
  of.blocks.push_back({2, 1});
  return of;
}

Linkage scotch_yoke_at(const Rational& turns) {
  return {.links = {{.points = {{0, own("0", "0")}}, .lines = {{0, own("0", "0"), Direction{own("1", "0")}}}},
                    {.points = {{0, own("0", "0")}, {1, own("1/10", "0")}}},
                    {.points = {{2, own("1/2", "0")}},
                     .lines = {{1, own("0", "0"), Direction{own("1", "0")}},
                               {2, own("0", "0"), Direction{degrees_of("60")}}}}},
          .pins = {{1, 2}},
          .blocks = {{1, 0}},
          .drives = {TurnedLink{1, Angle{turns}, ten_rad_s, three_rad_s2}}};
}
Linkage scotch_yoke() { return scotch_yoke_at(Rational(35, 360)); }

// Oldham's coupling: a cross between two shafts out of line.
Linkage oldham() {
  return {.links = {{.points = {{0, own("0", "0")}, {1, own("1/10", "1/20")}}},
                    {.points = {{0, own("0", "0")}}, .lines = {{0, own("0", "0"), Direction{own("1", "0")}}}},
                    {.points = {{2, own("0", "0")}},
                     .lines = {{1, own("0", "0"), Direction{own("1", "0")}},
                               {2, own("0", "0"), Direction{own("0", "1")}}}},
                    {.points = {{1, own("0", "0")}}, .lines = {{3, own("0", "0"), Direction{own("0", "1")}}}}},
          .blocks = {{1, 0}, {2, 3}},
          .drives = {TurnedLink{1, degrees_of("25"), ten_rad_s, three_rad_s2}}};
}

// A ladder whose foot is drawn along: pins in two guides.
Linkage ladder() {
  return {.links = {{.lines = {{0, own("0", "0"), Direction{own("1", "0")}},
                               {1, own("0", "0"), Direction{own("0", "1")}}}},
                    {.points = {{0, own("0", "0")}, {1, own("1", "0")}, {2, own("1/3", "1/7")}}}},
          .pins = {{0, 0}, {1, 1}},
          .drives = {SlidPoint{0, 0, Rational("6/10"), Rational("2"), Rational("-3")}},
          .chosen = {OnGuide{1, true}}};
}

// An arm lifted by a cylinder, with a second one on it.
Linkage excavator() {
  return {.links = {{.points = {{0, own("0", "0")}, {1, own("1/2", "-1/5")}}},
                    {.points = {{0, own("0", "0")}, {2, own("2", "1/3")}, {3, own("4", "0")}}},
                    {.points = {{3, own("0", "0")}, {4, own("-1", "1/4")}, {5, own("2", "0")}}}},
          .drives = {Stretched{1, 2, Rational("18/10"), Rational("1/5"), Rational("1/7")},
                     Stretched{2, 4, Rational("14/10"), Rational("-1/9"), Rational("1/3")}},
          .chosen = {BesideLine{2, 0, 1, true}, BesideLine{4, 2, 3, true}}};
}

// A block on a guide, driven, that carries a hinged bar turned by itself, and a link in a guide over its pin.
Linkage driven_twice() {
  return {.links = {{.lines = {{0, own("0", "1"), Direction{own("3", "4")}},
                               {1, own("5", "0"), Direction{own("0", "1")}}}},
                    {.points = {{0, own("1/10", "1/5")}}, .lines = {{2, own("0", "0"), Direction{own("1", "0")}}}},
                    {.points = {{0, own("0", "0")}, {1, own("8/10", "0")}}},
                    {.points = {{2, own("1", "1")}},
                     .lines = {{3, own("0", "0"), Direction{own("1", "0")}},
                               {4, own("1/2", "0"), Direction{own("1", "3")}}}}},
          .pins = {{1, 4}},
          .blocks = {{2, 0}, {3, 1}},
          .drives = {SlidPoint{0, 0, Rational("2"), Rational("12"), Rational("9/2")},
                     TurnedLink{2, degrees_of("45"), ten_rad_s, three_rad_s2}}};
}

// A block in a guide of the crank, with a slot that runs over a pin of the frame: all of it turns.
Linkage yoke_on_a_crank() {
  return {.links = {{.points = {{0, own("0", "0")}, {1, own("1/2", "1/3")}}},
                    {.points = {{0, own("0", "0")}}, .lines = {{0, own("0", "1/10"), Direction{own("1", "0")}}}},
                    {.points = {{2, own("1/7", "1/9")}},
                     .lines = {{1, own("0", "0"), Direction{own("1", "0")}},
                               {2, own("1/20", "0"), Direction{degrees_of("70")}}}}},
          .pins = {{1, 2}},
          .blocks = {{1, 0}},
          .drives = {TurnedLink{1, degrees_of("25"), ten_rad_s, three_rad_s2}}};
}

// A block driven along a guide of a turning crank, and a bar from there to the frame's guide.
Linkage slid_on_a_crank() {
  return {.links = {{.points = {{0, own("0", "0")}}, .lines = {{0, own("0", "-1/2"), Direction{own("1", "0")}}}},
                    {.points = {{0, own("0", "0")}}, .lines = {{1, own("0", "1/10"), Direction{own("4", "3")}}}},
                    {.points = {{1, own("0", "1/30")}}, .lines = {{2, own("0", "0"), Direction{own("1", "0")}}}},
                    {.points = {{1, own("0", "0")}, {2, own("2", "0")}}}},
          .pins = {{2, 0}},
          .blocks = {{2, 1}},
          .drives = {TurnedLink{1, degrees_of("25"), ten_rad_s, three_rad_s2},
                     SlidPoint{1, 1, Rational("3/10"), Rational("2"), Rational("5")}},
          .chosen = {OnGuide{2, true}}};
}

// A lever whose slot runs over the pin of a crank.
Linkage lever() {
  return {.links = {{.points = {{0, own("0", "0")}, {1, own("0", "3/10")}}},
                    {.points = {{1, own("0", "0")}, {2, own("175/1000", "0")}}},
                    {.points = {{0, own("0", "1/50")}}, .lines = {{0, own("0", "0"), Direction{own("1", "0")}}}}},
          .pins = {{2, 0}},
          .drives = {TurnedLink{1, degrees_of("-75"), ten_rad_s, three_rad_s2}},
          .chosen = {SlotPoints{0, true}}};
}

// Ring, carrier, planet with a point, sun: what is driven is the sun, so that the gears tell the carrier's angle.
Linkage planetary() {
  return {
      .links = {{.points = {{0, own("0", "0")}}},
                {.points = {{0, own("0", "0")}, {1, own("2/10", "0")}}},
                {.points = {{1, own("0", "0")}, {2, own("1/20", "1/30")}}},
                {.points = {{0, own("0", "0")}}}},
      .gears =
          {{.first = 0, .second = 2, .carrier = 1, .first_teeth = 70, .second_teeth = 20, .is_inside = true},
           {.first = 2, .second = 3, .carrier = 1, .first_teeth = 20, .second_teeth = 30, .phase = degrees_of("20")}},
      .drives = {TurnedLink{3, degrees_of("200"), ten_rad_s, three_rad_s2}}};
}

// Two cranks that gears hold together, and two rods.
Linkage geared_five_bar() {
  return {
      .links = {{.points = {{0, own("0", "0")}, {1, own("12/100", "0")}}},
                {.points = {{0, own("0", "0")}, {2, own("5/100", "0")}}},
                {.points = {{2, own("0", "0")}, {4, own("14/100", "0")}}},
                {.points = {{3, own("0", "0")}, {4, own("12/100", "0")}}},
                {.points = {{1, own("0", "0")}, {3, own("3/100", "0")}}}},
      .gears =
          {{.first = 1, .second = 4, .carrier = 0, .first_teeth = 40, .second_teeth = 30, .phase = degrees_of("60")}},
      .drives = {TurnedLink{1, degrees_of("500"), ten_rad_s, three_rad_s2}},
      .chosen = {BesideLine{4, 2, 3, true}}};
}

Linkage watt() {
  Linkage of = four_bar();
  of.links[3].points.push_back({5, own("1/10", "2/10")});
  of.links.push_back({.points = {{4, own("0", "0")}, {6, own("3/10", "0")}}});
  of.links.push_back({.points = {{5, own("0", "0")}, {6, own("35/100", "0")}}});
  of.chosen.push_back(BesideLine{6, 4, 5, true});
  return of;
}

std::vector<Named> all_linkages() {
  return {{"four-bar", four_bar()},
          {"slider-crank", slider_crank()},
          {"quick return", quick_return(false)},
          {"quick return with a block", quick_return(true)},
          {"Scotch yoke", scotch_yoke()},
          {"Oldham", oldham()},
          {"ladder", ladder()},
          {"excavator", excavator()},
          {"driven twice", driven_twice()},
          {"yoke on a crank", yoke_on_a_crank()},
          {"slid on a crank", slid_on_a_crank()},
          {"planetary gear", planetary()},
          {"geared five-bar", geared_five_bar()},
          {"Watt", watt()}};
}

template <class T>
void check_overlap(const std::string& what, const T& one, const T& other) {
  INFO(what << ": " << enclosure(one).value << " and " << enclosure(other).value);
  const Sign apart = sign(one - other);
  CHECK((apart == Sign::zero || apart == Sign::undecided));
  CHECK(enclosure(other).upper - enclosure(other).lower < 1e-6 * (1 + std::abs(enclosure(other).value)));
}

template <class T>
void check_both_routes(const Named& named) {
  const std::vector<Step> steps = assur_groups(named.linkage);
  tests::compare_routes<T>(named.linkage, steps, tests::beginning<T>(named.linkage, steps),
                           [&](const std::string& what, const T& one, const T& other) {
                             check_overlap<T>(std::string(named.name) + ", " + what, one, other);
                           });
}

// What is constructed, as the equations of the joints have it.
template <class T>
std::vector<analytic::LinkState<T>> constructed(const Linkage& linkage) {
  const std::vector<Step> steps = assur_groups(linkage);
  const CarriedOut<T> carried_out(linkage, steps);
  const LinkagePosition<T> at = carried_out.position();
  const LinkageMotion<T> motion = carried_out.motion(at, carried_out.rates());
  const auto complex = [](const Vector<T>& v) { return analytic::Complex<T>{v.x, v.y}; };
  std::vector<analytic::LinkState<T>> states;
  for (std::size_t i = 0; i < at.links.size(); ++i) {
    const Point<T>& O = at.links[i].O;
    const Vector<T>& x = at.links[i].x;
    states.push_back({{O.x, O.y},
                      complex(motion.links[i].velocity(O)),
                      complex(motion.links[i].acceleration(O)),
                      T(0),
                      motion.links[i].omega,
                      motion.links[i].alpha,
                      complex(x)});
  }
  return states;
}

// In line, each turned by 0° or 180°, their origins on the x axis.
std::vector<analytic::LinkState<Deep>> in_line(const std::vector<std::pair<const char*, int>>& links) {
  std::vector<analytic::LinkState<Deep>> states;
  const analytic::Complex<Deep> none{Deep(0), Deep(0)};
  for (const auto& [x, way] : links)
    states.push_back(
        {{from_rational<Deep>(Rational(x)), Deep(0)}, none, none, Deep(0), Deep(0), Deep(0), {Deep(way), Deep(0)}});
  return states;
}

template <class Number>
void demand_exactly(const Linkage& of, const std::function<void(std::vector<analytic::LinkState<Number>>&)>& change) {
  const Arithmetic<Number> scope;
  const Linkage linkage = with_sides_in_full(of, assur_groups(of));
  std::vector<analytic::LinkState<Number>> states = constructed<Number>(linkage);
  change(states);
  using analytic::UpTo;
  for (const UpTo order : {UpTo::place, UpTo::velocity, UpTo::acceleration})
    analytic::demand_joints(linkage, states, order, analytic::all_links(linkage));
}

// Places, velocities and accelerations of all points, and the rates of all links.
template <class T, class Compare>
void compare_found(const LinkagePosition<T>& at, const LinkageMotion<T>& moving, const LinkagePosition<T>& other_at,
                   const LinkageMotion<T>& other_moving, const Compare& compare) {
  for (std::size_t i = 0; i < at.points.size(); ++i) {
    const std::string point = "point " + std::to_string(i);
    const Pin<T>&one = moving.points[i], &other = other_moving.points[i];
    compare(point + ", x", at.points[i].x, other_at.points[i].x);
    compare(point + ", y", at.points[i].y, other_at.points[i].y);
    compare(point + ", v_x", one.v.x, other.v.x);
    compare(point + ", v_y", one.v.y, other.v.y);
    compare(point + ", a_x", one.a.x, other.a.x);
    compare(point + ", a_y", one.a.y, other.a.y);
  }
  for (std::size_t i = 0; i < at.links.size(); ++i) {
    const std::string link = "link " + std::to_string(i + 1);
    compare(link + ", omega", moving.links[i].omega, other_moving.links[i].omega);
    compare(link + ", alpha", moving.links[i].alpha, other_moving.links[i].alpha);
  }
}

// All drives where the linkage says, but the first: in a direction, or so far along.
DriveAt<Bounded> drive_at(const Rational& x, const Rational& y, const Rational& way) {
  const auto number = from_rational<Bounded>;
  return {0, {number(x), number(y)}, number(way)};
}

}  // namespace

// What is kept has stood elsewhere before.
TEST_CASE("A linkage written into what the caller keeps is where it is anew, points alone too") {
  const Arithmetic<Bounded> scope;
  for (const Named& named : all_linkages()) {
    CAPTURE(named.name);
    const std::vector<Step> steps = assur_groups(named.linkage);
    const CarriedOut<Bounded> carried_out(named.linkage, steps);
    const std::vector<DriveRates<Bounded>> rates = carried_out.rates();
    const LinkagePosition<Bounded> at = carried_out.position();
    const LinkageMotion<Bounded> motion = carried_out.motion(at, rates);
    for (const Wanted wanted : {Wanted::links, Wanted::points}) {
      LinkagePosition<Bounded> kept = carried_out.position_before(0);
      kept.wanted = wanted;
      LinkageMotion<Bounded> moving = carried_out.at_rest(kept);
      if (std::holds_alternative<TurnedLink>(named.linkage.drives[0]) && named.linkage.gears.empty()) {
        kept.elsewhere = drive_at(Rational(12, 13), Rational(5, 13), 0);
        carried_out.place_all(kept);
        carried_out.move_all(moving, kept, rates);
        CHECK(moving.steps.empty());
        kept.elsewhere.reset();
      }
      carried_out.place_all(kept);
      carried_out.move_all(moving, kept, rates);
      compare_found(kept, moving, at, motion, [&](const std::string& what, const Bounded& one, const Bounded& other) {
        if (wanted == Wanted::points) return check_overlap<Bounded>(what, one, other);
        INFO(what);
        CHECK(one.inf() == other.inf());
        CHECK(one.sup() == other.sup());
      });
    }
  }
}

TEST_CASE("A drive that is elsewhere moves a linkage as if it stood there") {
  const Arithmetic<Bounded> scope;
  for (const auto& [named, way] :
       {std::pair(Named{"excavator", excavator()}, Rational(19, 10)), {Named{"ladder", ladder()}, Rational(1, 2)}}) {
    CAPTURE(named.name);
    Linkage there = named.linkage;
    const auto put = [to = way](auto& drive) {
      using Kind = std::decay_t<decltype(drive)>;
      if constexpr (std::is_same_v<Kind, Stretched>) drive.length = to;
      if constexpr (std::is_same_v<Kind, SlidPoint>) drive.at = to;
    };
    std::visit(put, there.drives[0]);
    const std::vector<Step> steps = assur_groups(there);
    const CarriedOut<Bounded> as_stated(there, steps), moved(named.linkage, steps);
    const LinkagePosition<Bounded> at = as_stated.position(), elsewhere = moved.position(drive_at(1, 0, way));
    compare_found(elsewhere, moved.motion(elsewhere, moved.rates()), at, as_stated.motion(at, as_stated.rates()),
                  check_overlap<Bounded>);
  }
}

// The angle of a crank is told from 0 to 360°, and beyond; where a link is, from -180° to 180°.
TEST_CASE("A linkage is found by both routes all round a turn") {
  const Arithmetic<Bounded> scope;
  for (const char* degrees : {"-170", "10", "100", "181", "200", "240", "300", "345", "700", "-3000"}) {
    Linkage of = four_bar();
    std::get<TurnedLink>(of.drives[0]).angle = degrees_of(degrees);
    CAPTURE(degrees);
    check_both_routes<Bounded>({"four-bar", of});
  }
}

TEST_CASE("A linkage placed group by group moves as the equations of all its joints say") {
  for (const Named& named : all_linkages()) {
    REQUIRE(named.linkage.freedom() == 0);
    SECTION(named.name) {
      {
        const Arithmetic<Bounded> scope;
        check_both_routes<Bounded>(named);
      }
      const Arithmetic<Deep> scope(192);
      check_both_routes<Deep>(named);
    }
  }
}

// Willis: ring fixed, the sun makes 1 + ring/sun turns for each of the carrier, the planet 1 - ring/planet.
TEST_CASE("Gears tell the angles of links that no drive turns") {
  const Linkage linkage = planetary();
  const std::vector<Step> steps = assur_groups(linkage);
  const auto turn_of = [&](int link) {
    for (const Step& step : steps)
      if (const auto* wheel = std::get_if<GearedWheel>(&step); wheel && wheel->link == link) return wheel->turn;
    FAIL("no gears turn link " << link);
    return GearedTurn{};
  };
  const GearedTurn carrier = turn_of(1), planet = turn_of(2);
  CHECK(carrier.times.at(0) == Rational(3, 10));
  CHECK(planet.times.at(0) == Rational(3, 10) * (1 - Rational(7, 2)));
  // The sun stands at the phase where carrier and planet are in line with the frame.
  Linkage at_phase = linkage;
  std::get<TurnedLink>(at_phase.drives[0]).angle = degrees_of("20");
  CHECK(is_zero(angle_of(carrier, at_phase)));
  CHECK(is_zero(angle_of(planet, at_phase)));
  // Gears between two driven cranks.
  Linkage twice = geared_five_bar();
  twice.drives.push_back(TurnedLink{4, degrees_of("10"), ten_rad_s, three_rad_s2});
  try {
    assur_groups(twice);
    FAIL("a gear too many");
  } catch (const NotPlaced& refused) {
    CHECK(refused.why == NotPlaced::Why::overconstrained);
  }
}

TEST_CASE("What is constructed satisfies the equations of all joints exactly, and nothing beside it does") {
  using States = std::vector<analytic::LinkState<Exact>>;
  Linkage geared = planetary();
  std::get<TurnedLink>(geared.drives[0]).angle = degrees_of("120");  // the carrier then at 30°, the planet at -75°
  for (const Linkage& linkage : {four_bar(), ladder(), scotch_yoke_at(Rational(1, 12)), geared}) {
    CHECK_NOTHROW(demand_exactly<Exact>(linkage, [](States&) {}));
    for (const std::function<void(States&)>& change : std::vector<std::function<void(States&)>>{
             [](States& s) { s.back().O.re += Exact(Rational(1, 1'000'000)); },
             [](States& s) { s.back().x = -s.back().x; }, [](States& s) { s[1].x = Exact(2) * s[1].x; },
             [](States& s) { s.back().omega += Exact(Rational(1, 1'000'000)); },
             [](States& s) { s.back().v.im += Exact(1); }, [](States& s) { s[1].alpha += Exact(1); },
             [](States& s) { s.back().a.re -= Exact(1); }})
      CHECK_THROWS_AS(demand_exactly<Exact>(linkage, change), Impossible);
  }
}

TEST_CASE("Links are placed one after another, wheels together where each has its angle by another one's") {
  const auto hung = [](const Linkage& linkage, const std::vector<std::vector<int>>& order) {
    std::vector<std::vector<int>> on;
    for (const analytic::Hanging& each : analytic::one_after_another(linkage, order)) on.push_back(each.on);
    return on;
  };
  using On = std::vector<std::vector<int>>;
  CHECK(hung(four_bar(), {{1}, {2, 3}}) == On{{}, {1}});
  CHECK(hung(geared_five_bar(), {{1}, {4}, {2, 3}}) == On{{}, {1}, {1, 4}});
  CHECK(hung(planetary(), {{3}, {1}, {2}}) == On{{}, {3}});
  CHECK(hung(planetary(), {{1}, {2}, {3}}) == On{{}});
}

// Begun at the other place of a joint, the iteration ends there, and that is not what was meant.
TEST_CASE("The equations of all joints prove on which side each joint lies") {
  const auto all = []<class T>() {
    const Arithmetic<T> scope;
    for (const Linkage& linkage : {four_bar(), slider_crank(), ladder(), lever()}) {
      Linkage other = linkage;
      if (auto* beside = std::get_if<BesideLine>(&other.chosen[0])) beside->is_left = !beside->is_left;
      if (auto* on = std::get_if<OnGuide>(&other.chosen[0])) on->is_ahead = !on->is_ahead;
      if (auto* slot = std::get_if<SlotPoints>(&other.chosen[0])) slot->is_towards_pin = !slot->is_towards_pin;
      const std::vector<Step> steps = assur_groups(linkage), other_steps = assur_groups(other);
      const analytic::Beginning<T> start = tests::beginning<T>(other, other_steps);
      CHECK_NOTHROW(analytic::solve_joints<T>(with_sides_in_full(other, other_steps), start));
      CHECK_THROWS_AS(analytic::solve_joints<T>(with_sides_in_full(linkage, steps), start), Impossible);
    }
    // The block turned round in its guide.
    const std::vector<Step> steps = assur_groups(slider_crank());
    const Linkage full = with_sides_in_full(slider_crank(), steps);
    analytic::Beginning<T> start = tests::beginning<T>(slider_crank(), steps);
    CHECK_NOTHROW(analytic::solve_joints<T>(full, start));
    start.back().x = -start.back().x;
    CHECK_THROWS_AS(analytic::solve_joints<T>(full, start), Impossible);
    // Of which the bar's other end is not told.
    CHECK_THROWS_AS(analytic::solve_joints<T>(slider_crank(), tests::beginning<T>(slider_crank(), steps)), Undecided);
  };
  all.operator()<Fast>();
  all.operator()<Bounded>();
}

// Begun on the right side, though nearer to the other place, or far from both.
TEST_CASE("An iteration that comes to the other place of a joint proves nothing of the linkage") {
  int astray = 0;
  const auto from = [&]<class T, class... Bits>(double theta, Bits... bits) {
    const Arithmetic<T> scope(bits...);
    const Linkage linkage = with_sides_in_full(ladder(), assur_groups(ladder()));
    const double at = 0.6;  // the pin in the horizontal guide
    const analytic::Beginning<T> start{tests::link_at<T>(0, 0, 0), tests::link_at<T>(at, 0, theta)};
    try {
      const T theta_found = analytic::solve_joints<T>(linkage, start)[1].theta;
      CHECK(std::sin(enclosure(theta_found).value) == Approx(0.8));
    } catch (const Undecided&) {
      ++astray;
    }
  };
  for (int degrees = 2; degrees < 180; degrees += 2) {
    CAPTURE(degrees);
    const double theta = degrees * std::numbers::pi / 180;
    from.operator()<Bounded>(theta);
    from.operator()<Deep>(theta, 256L);
  }
  CHECK(astray > 0);
  CHECK(astray < 60);
}

// A0A and AB in line, and B0B with them: stretched out, the two bars can still go either way. Folded otherwise they
// cannot.
TEST_CASE("The equations of all joints are independent, but for a group at its limit") {
  const Arithmetic<Deep> scope(256);
  Linkage linkage = four_bar();
  linkage.links[2].points[1].at = own("16/100", "0");
  linkage.links[3].points[1].at = own("12/100", "0");
  CHECK_THROWS_AS(analytic::demand_independent(linkage, in_line({{"0", 1}, {"0", 1}, {"12/100", 1}, {"4/10", -1}})),
                  Undecided);
  const std::vector<analytic::LinkState<Deep>> bent = constructed<Deep>(four_bar());
  CHECK_NOTHROW(analytic::demand_independent(four_bar(), bent));
}
