// Vectors that would lie on one another stand beside each other.
#include <cmath>

#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/panels/tracks.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

double how_far(const Track& track) { return drawings::length(track.by); }

}  // namespace

TEST_CASE("a vector painted back over another stands aside, away from the middle", "[tracks]") {
  const auto found = tracks({{{0, 0}, {40, 0}}, {{40, 0}, {25, 0}}, {{25, 0}, {0, 30}}}, {20, 10});
  CHECK(how_far(found[0]) == 0);
  CHECK(found[1].by.y < -1);
  REQUIRE(found[1].letters);
  CHECK(found[1].letters->y == -1);
  CHECK(!found[0].letters);  // its middle is free: its letters may stand on either side
  CHECK(how_far(found[2]) == 0);
  CHECK(tracks({{{0, 0}, {40, 0}}, {{40, 0}, {25, 0}}}, {20, -10})[1].by.y > 1);
}

TEST_CASE("what covers another's middle takes that side for its letters", "[tracks]") {
  const auto found = tracks({{{0, 0}, {40, 0}}, {{40, 0}, {10, 0}}}, {20, 10});
  REQUIRE((found[0].letters && found[1].letters));
  CHECK(found[0].letters->y == -found[1].letters->y);
}

TEST_CASE("from what stays the construction goes on: what it would lie on moves aside", "[tracks]") {
  const auto found = tracks({{{0, 0}, {40, 0}}, {{40, 0}, {10, 0}}}, {20, 10}, LyingOver::of_a_polygon, {1});
  CHECK(how_far(found[0]) > 1);
  CHECK(how_far(found[1]) == 0);
}

TEST_CASE("each of several has a track of its own", "[tracks]") {
  const auto found = tracks({{{0, 0}, {40, 0}}, {{0, 0}, {40, 0}}, {{40, 0}, {0, 0}}, {{5, 0}, {30, 0}}}, {20, 0});
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) CHECK(drawings::distance(found[i].by, found[k].by) > 1);
}

TEST_CASE("what the eye tells apart stays in its place", "[tracks]") {
  const std::vector<VectorOnPaper> others{{{40, 0}, {60, 0}},     // goes on where the first ends
                                          {{0, 0}, {40, 4}},      // parts from it
                                          {{0, 2}, {40, 2}},      // beside it
                                          {{10, 0}, {12, 0}},     // a dot
                                          {{20, -20}, {20, 20}},  // across it
                                          {{0, 0}, {25, 0}},      // from where it starts, to a head of its own
                                          {{0, 0}, {0, 0}}};
  for (const VectorOnPaper& other : others) CHECK(how_far(tracks({{{0, 0}, {40, 0}}, other}, {20, 10})[1]) == 0);
}

TEST_CASE("what stands aside crosses no other so slimly that the eye does not tell which goes on where", "[tracks]") {
  const VectorOnPaper sum{{100, 0}, {0, 0}}, back{{0, 0}, {100, 0}}, part{{100, -3}, {0, 0}};
  CHECK(tracks({back, sum}, {50, 10})[1].by.y < -1);  // away from the middle
  CHECK(tracks({back, part, sum}, {50, 10})[2].by.y > 1);
}

TEST_CASE("a vector all but on another's line stands aside too", "[tracks]") {
  CHECK(how_far(tracks({{{0, 0}, {40, 0}}, {{0, 0.6}, {40, 0}}}, {20, 10})[1]) > 1);
}

// Equilibrium of (0, -4), (3, 0) and (-1, 0): the third goes back over the second.
TEST_CASE("a polygon's vector on its own track is as long, and joined to its corners", "[tracks]") {
  const VectorPolygon polygon{
      .meaning = drawings::Meaning::force,
      .unit = "N",
      .origin = "$O$",
      .left = {{.quantity = "s", .label = "$s$", .direction = "?", .magnitude = "?", .v = {-2, 4}}},
      .right = {{.quantity = "w", .label = "$w$", .direction = "↓", .magnitude = "4", .v = {0, -4}},
                {.quantity = "t", .label = "$t$", .direction = "→", .magnitude = "3", .v = {3, 0}},
                {.quantity = "f", .label = "$f$", .direction = "←", .magnitude = "1", .v = {-1, 0}}},
      .loop = true};
  DrawnSheet sheet;
  const Scale scale{.mm_per_unit = 10, .caption = "", .unit = "N"};
  Plot plot(sheet, {90, 90}, scale);
  draw_polygon(plot, polygon);
  const auto* back = [&]() -> const drawings::Arrow* {
    for (const drawings::Mark& mark : sheet.sheet.figure.marks)
      if (const auto* arrow = std::get_if<drawings::Arrow>(&mark); arrow && arrow->name == "f") return arrow;
    return nullptr;
  }();
  REQUIRE(back);
  CHECK(back->from.y < 50 - 1);
  CHECK(drawings::distance(back->from, back->to) == Approx(10));
  int joins = 0;
  for (const drawings::Mark& mark : sheet.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->path.pieces.size() == 1)
      for (const drawings::Point end : {back->from, back->to})
        joins += drawings::distance(line->path.pieces.front().end, end) < 1e-9 ? 1 : 0;
  CHECK(joins == 2);
  for (const Measurement& m : sheet.measurements)
    if (m.quantity == "f") CHECK(drawings::distance(m.from, back->from) < 1e-9);
  const std::vector<Place> numbers = places_of_steps(polygon, scale);
  CHECK(numbers[2].y * 10 + 90 == Approx(back->from.y));  // the step's number stands on it
}

// v = 4 to the right, 3 back, and from there a line upwards.
TEST_CASE("a vector at whose tip the next line starts stays, another beside it", "[tracks]") {
  const VectorPolygon polygon{
      .unit = "m/s",
      .origin = "$O$",
      .left = {{.quantity = "v", .label = "$v$", .direction = "∕", .magnitude = "?", .v = {1, 2}}},
      .right = {{.quantity = "p", .label = "$p$", .direction = "→", .magnitude = "4", .v = {4, 0}},
                {.quantity = "n", .label = "$n$", .direction = "←", .magnitude = "3", .v = {-3, 0}},
                {.quantity = "t", .label = "$t$", .direction = "↑", .magnitude = "?", .v = {0, 2}}}};
  DrawnSheet sheet;
  Plot plot(sheet, {90, 90}, {.mm_per_unit = 10, .caption = "", .unit = "m/s"});
  draw_polygon(plot, polygon);
  for (const drawings::Mark& mark : sheet.sheet.figure.marks)
    if (const auto* arrow = std::get_if<drawings::Arrow>(&mark)) {
      if (arrow->name == "n") CHECK(arrow->from.y == 90);
      if (arrow->name == "p") CHECK(std::abs(arrow->from.y - 90) > 1);
    }
}
