// Panels find their places: pictures of a known size, which grows with the scale, and letters, which do not.
#include "exercises/kit/panels/layout_search.h"

#include <cmath>
#include <ctime>

#include "tests/support/catch.h"

using namespace epure;

namespace {

struct Picture : Panel {
  double width, height, letters;  // metres, metres, mm
  Picture(double w, double h, double l = 10) : width(w), height(h), letters(l) {}
  double reach() const override { return width; }
  drawings::Box extent(const Scale& lengths, const Scale&) const override {
    return {{0, 0}, {lengths.mm_per_unit * width + letters, lengths.mm_per_unit * height + letters}};
  }
  std::vector<drawings::Block> draw(Plot&, const drawings::Box&, Language) const override { return {}; }
};

struct Diagram : Panel {
  double longest;  // m/s
  explicit Diagram(double l) : longest(l) {}
  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override { return {"m/s", longest}; }
  drawings::Box extent(const Scale&, const Scale& vectors) const override {
    return {{0, 0}, {vectors.mm_per_unit * longest + 10, vectors.mm_per_unit * longest / 2 + 10}};
  }
  std::vector<drawings::Block> draw(Plot&, const drawings::Box&, Language) const override { return {}; }
};

constexpr drawings::Box room{{10, 30}, {200, 200}};

drawings::Box extent_of(const PlacedPanel& placed) { return placed.panel->extent(placed.lengths, placed.vectors); }

}  // namespace

TEST_CASE("layout: each panel stands in a room of its own, large enough for it") {
  const Panels three = panels(Picture(1, 1), Diagram(12), Picture(0.5, 2));
  const auto placed = laid_out(three, room, {});
  REQUIRE(placed.size() == 3);
  for (const PlacedPanel& a : placed) {
    CHECK(a.room.low.x >= room.low.x - 1e-9);
    CHECK(a.room.high.y <= room.high.y + 1e-9);
    CHECK(extent_of(a).width() <= a.room.width() + 1e-9);
    CHECK(extent_of(a).height() <= a.room.height() + 1e-9);
    for (const PlacedPanel& b : placed)
      if (&a != &b)
        CHECK((a.room.high.x <= b.room.low.x || b.room.high.x <= a.room.low.x || a.room.high.y <= b.room.low.y ||
               b.room.high.y <= a.room.low.y));
  }
}

TEST_CASE("layout: tall pictures stand side by side, wide ones one below the other") {
  const auto tall = laid_out(panels(Picture(0.2, 1), Picture(0.2, 1)), room, {}),
             wide = laid_out(panels(Picture(1, 0.2), Picture(1, 0.2)), room, {});
  CHECK(tall[0].room.high.x <= tall[1].room.low.x);
  CHECK(wide[0].room.low.y >= wide[1].room.high.y);
}

// 170 mm of height for 1 m at 1 : 10 and its letters; at 1 : 5 it would be 210.
TEST_CASE("layout: the largest standard scale that fits, or the one asked for") {
  CHECK(laid_out(panels(Picture(1, 1)), room, {}).front().lengths.caption == "1 : 10");
  CHECK(laid_out(panels(Picture(1, 1)), room, {.scale = Rational(1, 20)}).front().lengths.caption == "1 : 20");
  CHECK_THROWS_WITH(laid_out(panels(Picture(1, 1)), room, {.scale = Rational(1, 5)}), Contains("1 : 10 would fit"));
  CHECK_THROWS_AS(laid_out(panels(Picture(1, 1, 300)), room, {}), DoesNotFit);
  const auto two = laid_out(panels(Picture(1, 1), Picture(1, 1)), room, {.scale = Rational(1, 50)});
  CHECK(two[0].lengths.caption == "1 : 50");
  CHECK(two[1].lengths.caption != "1 : 50");
}

TEST_CASE("layout: vectors of one unit have one scale") {
  const auto placed = laid_out(panels(Diagram(12), Diagram(3)), room, {});
  CHECK(placed[0].vectors.caption == placed[1].vectors.caption);
}

TEST_CASE("layout: no scale could be the next larger one") {
  const Panels shown = panels(Picture(1, 0.7), Picture(0.3, 0.4), Diagram(7));
  const auto placed = laid_out(shown, room, {});
  // Alone in the whole room each could be larger: the room is used up by all of them, not by fixed shares.
  double area = 0;
  for (const PlacedPanel& each : placed) area += extent_of(each).width() * extent_of(each).height();
  CHECK(area > 0.3 * room.width() * room.height());
}

// A thousand divisions, most of which letters alone make too wide. (More than ten seconds, when each was tried down
// to the smallest scale.)
TEST_CASE("layout: seven panels find their places soon, or are refused soon") {
  const Panels seven = panels(Picture(1, 1), Diagram(12), Picture(0.5, 2), Picture(1, 2), Diagram(3), Picture(2, 1),
                              Picture(1, 1, 20));
  const std::clock_t begin = std::clock();
  CHECK(laid_out(seven, {{0, 0}, {90, 90}}, {}).size() == 7);
  CHECK_THROWS_AS(laid_out(seven, {{0, 0}, {30, 30}}, {}), DoesNotFit);
  CHECK(std::clock() - begin < 2 * CLOCKS_PER_SEC);
}
