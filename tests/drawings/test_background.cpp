#include "drawings/marks/background.h"

#include <array>

#include "drawings/marks/style.h"
#include "drawings/paths/vectors.h"
#include "probe.h"
#include "tests/support/catch.h"

using namespace epure::drawings;

namespace {

Colour grey_level(int level) { return {level / 255.0, level / 255.0, level / 255.0, 1}; }

const std::array meanings{Meaning::link,         Meaning::ground,       Meaning::plate, Meaning::axis,
                          Meaning::construction, Meaning::alternative,  Meaning::locus, Meaning::second_locus,
                          Meaning::velocity,     Meaning::acceleration, Meaning::force, Meaning::dimension,
                          Meaning::text};

// A page with a stroke, a light area and letters in each ink, and a white area.
Page page_of_all_inks() {
  Page page{"demo", "t", "d", {{0, 0}, {100, 50}}, epure::Language::english, {}, true};
  for (const Meaning meaning : meanings) {
    page.primitives.emplace_back(Stroke{segment({1, 1}, {9, 9}), 0.2, {}, ink(meaning), {}, {}});
    page.primitives.emplace_back(Fill{circle({5, 5}, 2), tint(meaning), {}, {}});
    page.primitives.emplace_back(PlacedText{"a", {1, 1}, 3, ink(meaning), Weight::regular});
  }
  page.primitives.emplace_back(Fill{circle({5, 5}, 1), white, {}, "joint"});
  return page;
}

double least_contrast_of_letters(const Page& page, const Colour& ground) {
  double least = 21;
  for (const PlacedText& text : probe::all<PlacedText>(page)) least = std::min(least, contrast(text.colour, ground));
  return least;
}

}  // namespace

// Numbers that WebAIM's checker and W3C's own examples give.
TEST_CASE("contrast is that of WCAG") {
  CHECK(contrast(black, white) == Approx(21));
  CHECK(contrast(white, black) == Approx(21));
  CHECK(contrast(grey_level(0x77), white) == Approx(4.48).margin(0.005));
  CHECK(contrast(grey_level(0x76), white) == Approx(4.54).margin(0.005));
  CHECK(contrast({1, 0, 0, 1}, white) == Approx(4.0).margin(0.005));
  CHECK(contrast({0, 0, 1, 1}, white) == Approx(8.59).margin(0.005));
}

TEST_CASE("on white nothing changes but that the page is painted") {
  const Page page = page_of_all_inks(), white_one = on_background(page, {white, Inks::dark});
  CHECK_FALSE(white_one.is_paper);
  REQUIRE(white_one.primitives.size() == page.primitives.size() + 1);
  const Fill& painted = std::get<Fill>(white_one.primitives.front());
  CHECK(painted.colour == white);
  CHECK(contains(Box{painted.path.start, painted.path.pieces[1].end}, page.extent));
  const auto strokes = probe::all<Stroke>(page), same = probe::all<Stroke>(white_one);
  for (std::size_t i = 0; i < strokes.size(); ++i) CHECK(strokes[i].colour == same[i].colour);
  CHECK(probe::named<Fill>(white_one, "joint").front().colour == white);
}

TEST_CASE("none takes the paper away and paints nothing") {
  const Page page = page_of_all_inks(), clear = on_background(page, {{}, Inks::dark});
  CHECK_FALSE(clear.is_paper);
  CHECK(clear.primitives.size() == page.primitives.size());
}

TEST_CASE("light inks are legible on every ground as dark as #333, by themselves") {
  for (const int level : {0, 0x0d, 0x1a, 0x33}) {
    const Page page = on_background(page_of_all_inks(), {grey_level(level), Inks::light});
    CHECK(least_contrast_of_letters(page, grey_level(level)) >= legible);
    // The inks stay apart: none had to be made lighter, as then all would become white.
    for (const PlacedText& text : probe::all<PlacedText>(page)) {
      const bool is_of_table = std::any_of(meanings.begin(), meanings.end(),
                                           [&](Meaning each) { return light_ink(ink(each)) == text.colour; });
      CHECK(is_of_table);
    }
  }
}

TEST_CASE("letters are legible on any ground, as they are on white paper where that asks less") {
  for (int r = 0; r < 256; r += 51)
    for (int g = 0; g < 256; g += 51)
      for (int b = 0; b < 256; b += 51) {
        const Colour ground{r / 255.0, g / 255.0, b / 255.0, 1};
        const Inks inks = inks_for(ground);
        CAPTURE(r, g, b, inks == Inks::light);
        const Page before = page_of_all_inks(), page = on_background(before, {ground, inks});
        const auto was = probe::all<PlacedText>(before), is = probe::all<PlacedText>(page);
        for (std::size_t i = 0; i < is.size(); ++i) {
          const double asked = inks == Inks::light ? legible : std::min(legible, contrast(was[i].colour, white));
          CHECK(contrast(is[i].colour, ground) >= asked);
        }
        CHECK(probe::named<Fill>(page, "joint").front().colour == ground);
      }
}

TEST_CASE("light areas stay as light, in the new ink") {
  const Page page = on_background(page_of_all_inks(), {{}, Inks::light});
  int seen = 0;
  for (const Fill& fill : probe::all<Fill>(page)) {
    if (fill.name == "joint") continue;
    CHECK((fill.colour.opacity == 0.07 || fill.colour.opacity == 0.12));
    CHECK(contrast({fill.colour.red, fill.colour.green, fill.colour.blue, 1}, black) > 5);
    ++seen;
  }
  CHECK(seen == static_cast<int>(meanings.size()));
  CHECK(probe::named<Fill>(page, "joint").front().colour == dark_background);
}
