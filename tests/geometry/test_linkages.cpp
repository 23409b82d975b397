// Linkages of any kind: placed and moved group by group against the equations of all their joints.
#include "geometry/analytic/joint_equations.h"
#include "geometry/linkages/carried_out.h"
#include "tests/support/catch.h"

#include <cmath>
#include <functional>

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

Linkage scotch_yoke() {
  return {.links = {{.points = {{0, own("0", "0")}}, .lines = {{0, own("0", "0"), Direction{own("1", "0")}}}},
                    {.points = {{0, own("0", "0")}, {1, own("1/10", "0")}}},
                    {.points = {{2, own("1/2", "0")}},
                     .lines = {{1, own("0", "0"), Direction{own("1", "0")}},
                               {2, own("0", "0"), Direction{degrees_of("80")}}}}},
          .pins = {{1, 2}},
          .blocks = {{1, 0}},
          .drives = {TurnedLink{1, degrees_of("35"), ten_rad_s, three_rad_s2}}};
}

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

Linkage watt() {
  Linkage of = four_bar();
  of.links[3].points.push_back({5, own("1/10", "2/10")});
  of.links.push_back({.points = {{4, own("0", "0")}, {6, own("3/10", "0")}}});
  of.links.push_back({.points = {{5, own("0", "0")}, {6, own("35/100", "0")}}});
  of.chosen.push_back(BesideLine{6, 4, 5, true});
  return of;
}

std::vector<Named> twelve_linkages() {
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
          {"Watt", watt()}};
}

// Where the placed links are, to a hundredth.
analytic::Beginning beginning(const Linkage& linkage) {
  const Arithmetic<Fast> scope;
  const std::vector<Step> steps = assur_groups(linkage);
  analytic::Beginning q;
  for (const PlacedLink<Fast>& link : CarriedOut<Fast>(linkage, steps).position().links)
    for (const double x : {link.O.x, link.O.y, std::atan2(link.x.y, link.x.x)})
      q.push_back(std::round(x * 100) / 100);
  return q;
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
  const Linkage& linkage = named.linkage;
  const std::vector<Step> steps = assur_groups(linkage);
  const CarriedOut<T> carried_out(linkage, steps);
  const LinkagePosition<T> at = carried_out.position();
  const LinkageMotion<T> motion = carried_out.motion(at, carried_out.rates());
  const std::vector<analytic::LinkState<T>> states = analytic::solve_joints<T>(linkage, beginning(linkage));
  for (std::size_t i = 0; i < linkage.links.size(); ++i) {
    const std::string link = std::string(named.name) + ", link " + std::to_string(i + 1);
    check_overlap<T>(link + ", omega", motion.links[i].omega, states[i].omega);
    check_overlap<T>(link + ", alpha", motion.links[i].alpha, states[i].alpha);
    for (const LinkPoint& p : linkage.links[i].points) {
      const auto k = static_cast<std::size_t>(p.point);
      const analytic::PointState<T> point = analytic::point_of(states[i], p.at);
      const std::string name = link + ", point " + std::to_string(p.point);
      check_overlap<T>(name + ", x", at.points[k].x, point.z.re);
      check_overlap<T>(name + ", y", at.points[k].y, point.z.im);
      check_overlap<T>(name + ", v_x", motion.points[k].v.x, point.v.re);
      check_overlap<T>(name + ", v_y", motion.points[k].v.y, point.v.im);
      check_overlap<T>(name + ", a_x", motion.points[k].a.x, point.a.re);
      check_overlap<T>(name + ", a_y", motion.points[k].a.y, point.a.im);
    }
  }
}

}  // namespace

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
  for (const Named& named : twelve_linkages()) {
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
