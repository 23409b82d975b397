// Mechanisms that nobody drew: up to twelve links, put together at random of all groups of links, by both routes.
// They agree, or one of them says why it cannot tell.
#include <array>
#include <random>

#include "geometry/numbers/rational_field.h"
#include "tests/geometry/linkage_routes.h"
#include "tests/support/catch.h"

using namespace epure;
using namespace epure::geometry;

namespace {

// Adds group after group to a crank; what does not close is left out again.
class Assembling {
 public:
  explicit Assembling(unsigned seed) : chance_(seed) {
    linkage_.links.resize(2);
    point_on(0, {0, 0});
    point_on(0, own_place());
    share(0, 1, {0, 0});
    point_on(1, {thousandths(0.3, 1), 0});
    linkage_.drives.push_back(TurnedLink{1, {thousandths(0, 1)}, {0, thousandths(-5, 5)}, {0, thousandths(-5, 5)}});
  }

  Linkage grown() {
    const int most = chosen(3, 12);
    for (int tries = 0; tries < 40 && static_cast<int>(linkage_.links.size()) < most; ++tries) {
      const Linkage before = linkage_;
      const int points = points_, lines = lines_;
      add();
      if (closes() && static_cast<int>(linkage_.links.size()) <= most) continue;
      linkage_ = before;
      points_ = points;
      lines_ = lines;
    }
    return linkage_;
  }

 private:
  // --- chance ------------------------------------------------------------------------------------------------------
  int chosen(int from, int to) { return std::uniform_int_distribution<int>(from, to)(chance_); }
  bool heads() { return chosen(0, 1) == 1; }
  Rational thousandths(double from, double to) {
    return Rational(chosen(static_cast<int>(1000 * from), static_cast<int>(1000 * to)), 1000);
  }
  Own own_place() { return {thousandths(-1, 1), thousandths(-1, 1)}; }
  Direction direction() {
    if (heads()) return Angle{thousandths(0, 1)};
    return Own{chosen(1, 4), chosen(-4, 4)};
  }
  int any_link() { return chosen(0, static_cast<int>(linkage_.links.size()) - 1); }
  int any_point() { return chosen(0, points_ - 1); }
  bool share_a_link(int P, int Q) const {
    for (const int one : linkage_.links_at(P))
      for (const int other : linkage_.links_at(Q))
        if (one == other) return true;
    return false;
  }

  // --- parts -------------------------------------------------------------------------------------------------------
  Link& link(int i) { return linkage_.links[static_cast<std::size_t>(i)]; }
  int new_link() {
    linkage_.links.emplace_back();
    return static_cast<int>(linkage_.links.size()) - 1;
  }
  int point_on(int i, const Own& at) {
    link(i).points.push_back({points_, at});
    return points_++;
  }
  void share(int P, int i, const Own& at) { link(i).points.push_back({P, at}); }
  int line_on(int i, const Own& through, const Direction& along) {
    link(i).lines.push_back({lines_, through, along});
    return lines_++;
  }
  void perhaps_a_point(int i) {
    if (heads()) point_on(i, own_place());
  }

  void add() {
    switch (chosen(0, 7)) {
      case 0:
      case 1:
        return two_rods();
      case 2:
        return rod_and_pin_on_line();
      case 3:
        return rod_and_block();
      case 4:
        return slot_on_pin(false);
      case 5:
        return slot_on_pin(true);
      case 6:
        return heads() ? block_on_pin() : block_and_pin_on_line();
      default:
        return crossed_block();
    }
  }
  void two_rods() {
    const int P = any_point(), Q = any_point();
    if (P == Q || share_a_link(P, Q)) return;
    const int i = new_link(), j = new_link();
    share(P, i, {0, 0});
    const int X = point_on(i, {thousandths(0.2, 1.5), 0});
    share(Q, j, {0, 0});
    share(X, j, {thousandths(0.2, 1.5), thousandths(0, 0.2)});
    perhaps_a_point(i);
    linkage_.chosen.push_back(BesideLine{X, P, Q, heads()});
  }
  void rod_and_pin_on_line() {
    const int P = any_point(), on = any_link();
    if (link_has(on, P)) return;
    const int g = line_on(on, own_place(), direction()), i = new_link();
    share(P, i, {0, 0});
    const int X = point_on(i, {thousandths(0.3, 2), 0});
    perhaps_a_point(i);
    linkage_.pins.push_back({X, g});
    linkage_.chosen.push_back(OnGuide{X, heads()});
  }
  void rod_and_block() {
    const int P = any_point(), on = any_link();
    if (link_has(on, P)) return;
    const int g = line_on(on, own_place(), direction()), i = new_link(), j = new_link();
    share(P, i, {0, 0});
    const int X = point_on(i, {thousandths(0.3, 2), 0});
    share(X, j, {thousandths(-0.1, 0.1), thousandths(-0.1, 0.1)});
    linkage_.blocks.push_back({line_on(j, {0, 0}, direction()), g});
    perhaps_a_point(j);
    linkage_.chosen.push_back(OnGuide{X, heads()});
  }
  void slot_on_pin(bool has_block) {
    const int P = any_point(), Q = any_point();
    if (P == Q || share_a_link(P, Q)) return;
    const int i = new_link();
    share(Q, i, {0, thousandths(-0.1, 0.1)});
    const int s = line_on(i, {0, 0}, direction());
    perhaps_a_point(i);
    if (has_block) {
      const int block = new_link();
      share(P, block, {0, thousandths(-0.1, 0.1)});
      linkage_.blocks.push_back({line_on(block, {0, 0}, direction()), s});
    } else {
      linkage_.pins.push_back({P, s});
    }
    linkage_.chosen.push_back(SlotPoints{s, heads()});
  }
  void block_on_pin() {
    const int P = any_point(), on = any_link();
    if (link_has(on, P)) return;
    const int g = line_on(on, own_place(), direction()), i = new_link();
    linkage_.blocks.push_back({line_on(i, {0, 0}, Own{1, 0}), g});
    linkage_.pins.push_back({P, line_on(i, own_place(), Own{1, chosen(1, 5)})});
    point_on(i, own_place());
  }
  void block_and_pin_on_line() {
    const int on = any_link(), other = any_link();
    if (on == other) return;
    const int g = line_on(on, own_place(), direction()), h = line_on(other, own_place(), direction()), i = new_link();
    linkage_.blocks.push_back({line_on(i, {0, 0}, Own{1, 0}), g});
    linkage_.pins.push_back({point_on(i, own_place()), h});
  }
  void crossed_block() {
    const int Q = any_point(), on = any_link();
    if (link_has(on, Q)) return;
    const int g = line_on(on, own_place(), direction()), i = new_link(), block = new_link();
    share(Q, i, own_place());
    point_on(i, own_place());
    linkage_.blocks.push_back({line_on(block, {0, 0}, Own{1, 0}), g});
    linkage_.blocks.push_back({line_on(block, own_place(), Own{1, chosen(1, 5)}), line_on(i, {0, 0}, direction())});
    point_on(block, own_place());
  }

  bool link_has(int i, int P) const {
    const std::vector<int> there = linkage_.links_at(P);
    return std::find(there.begin(), there.end(), i) != there.end();
  }
  bool closes() const {
    const Arithmetic<Fast> scope;
    try {
      const std::vector<Step> steps = assur_groups(linkage_);
      CarriedOut<Fast>(linkage_, steps).position();
      return true;
    } catch (const NotPlaced&) {
    } catch (const Impossible&) {
    } catch (const Undecided&) {
    }
    return false;
  }

  std::mt19937 chance_;
  Linkage linkage_;
  int points_ = 0, lines_ = 0;
};

struct Counted {
  int mechanisms = 0, compared = 0, at_limits = 0, undecided = 0;
  std::array<int, 13> with_links = {};
};

// What became of them, in words.
std::string run(unsigned first, unsigned count) {
  const Arithmetic<Bounded> scope;
  Counted counted;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const Linkage linkage = Assembling(seed).grown();
    const std::vector<Step> steps = assur_groups(linkage);
    ++counted.mechanisms;
    ++counted.with_links.at(linkage.links.size());
    INFO("seed " << seed << ", " << linkage.links.size() << " links");
    try {
      tests::compare_routes<Bounded>(
          linkage, steps, tests::beginning<Bounded>(linkage, steps),
          [](const std::string& what, const Bounded& one, const Bounded& other) {
            const Sign apart = sign(one - other);
            if (apart == Sign::zero || apart == Sign::undecided) return;
            FAIL(what << ": " << enclosure(one).value << " and " << enclosure(other).value);
          });
      ++counted.compared;
    } catch (const Impossible& why) {
      REQUIRE_FALSE(why.words().italian.empty());
      ++counted.at_limits;
    } catch (const Undecided& why) {
      REQUIRE_FALSE(why.words().italian.empty());
      ++counted.undecided;
    }
  }
  std::string sizes;
  for (const int n : counted.with_links) sizes += " " + std::to_string(n);
  CHECK(counted.compared > 9 * counted.mechanisms / 10);
  return std::to_string(counted.mechanisms) + " mechanisms, " + std::to_string(counted.compared) + " agree, " +
         std::to_string(counted.at_limits) + " at a limit, " + std::to_string(counted.undecided) +
         " undecided; by number of links:" + sizes;
}

}  // namespace

TEST_CASE("Random mechanisms move by both routes alike", "[random]") { run(1, 300); }
// By hand: a minute.
TEST_CASE("Ten thousand random mechanisms move by both routes alike", "[.][ten thousand]") {
  WARN(run(1000, 10'000));
}
