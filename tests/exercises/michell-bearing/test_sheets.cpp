// The sheets of the Michell bearing, whatever is given, and what stands on them.
#include <map>
#include <set>
#include <tuple>

#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/michell-bearing/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("michell bearing: every sheet is drawn, whatever is given", "[michell-bearing][sheets]") {
  draws_every_sheet(bearing(), read_corpus(EPURE_CORPUS "/michell_bearing.txt"));
}

TEST_CASE("michell bearing: letters find room", "[michell-bearing][sheets]") {
  letters_find_room(bearing(), {{}, {"h_1=1.6"}, {"x_N=0.038"}, {"pads=6", "r_m=0.12"}});
  letters_find_room(bearing(), {{"h_1=0.32"}}, {"integration"});  // forty strips leave a step's number no room
}

TEST_CASE("michell bearing: the flat wall runs to the narrow end, the inclined one rests",
          "[michell-bearing][sheets]") {
  const DrawnSheet drawn = bearing().draw("pressures", {});
  const auto pad = ends_of(line(drawn, "h")), runner = ends_of(line(drawn, "runner"));
  const drawings::Arrow speed = arrow(drawn, "runner_speed");
  CHECK(pad.first.y > pad.second.y);
  CHECK(runner.first.y == runner.second.y);
  CHECK(speed.to.x > speed.from.x);
  CHECK(speed.to.y == speed.from.y);
  CHECK(speed.to.y < runner.first.y);
  // Hatched on its right from the outlet to the inlet: above.
  const std::vector<drawings::Ground> hatched = all_of<drawings::Ground>(drawn);
  REQUIRE(hatched.size() == 1);
  CHECK(hatched[0].from.x == Approx(pad.second.x));
  CHECK(hatched[0].to.y == Approx(pad.first.y));
}

TEST_CASE("michell bearing: how high the film is drawn, however high it is", "[michell-bearing][sheets]") {
  CHECK(tells(bearing().draw("pressures", {}), "times higher than long"));
  CHECK(tells(bearing().draw("pressures", {"h_1=400", "h_2=160"}), "times longer than high"));
  CHECK_FALSE(tells(bearing().draw("pressures", {"h_1=400", "h_2=160"}), " 0 times"));
  CHECK(tells(bearing().draw("pressures", {"h_1=0.0000004", "h_2=0.00000016"}), "more than a million times higher"));
}

TEST_CASE("michell bearing: a polygon that misses its end is not said to close nearly", "[michell-bearing][sheets]") {
  CHECK(tells(bearing().draw("integration", {}), "does not quite close"));
  const DrawnSheet coarse = bearing().draw("integration", {"h_1=160"});
  CHECK(tells(coarse, "too coarse"));
  CHECK_FALSE(tells(coarse, "does not quite close"));
}

TEST_CASE("michell bearing: tangents, sections without shear and the ratio of films are measured back",
          "[michell-bearing][sheets]") {
  for (const Assignments& assignments : {Assignments{}, Assignments{"h_1=0.8", "x_1=0.05"}}) {
    const CheckedExercise result = bearing().checked(assignments);
    CAPTURE(assignments, complaints(result));
    CHECK(result.passed());
    for (const char* name : {"inverse.tau_0_at_x_1", "inverse.tau_h_at_x_1", "inverse.tau_0_at_x_2",
                             "inverse.tau_h_at_x_2", "inverse.tau_0_at_x_3", "inverse.tau_h_at_x_3",
                             "inverse.x_shear_zero_fixed", "inverse.x_shear_zero_moving", "direct.n"}) {
      CAPTURE(name);
      CHECK_FALSE(find(result, name).on_sheets.empty());
    }
  }
}

TEST_CASE("michell bearing: both parts of a velocity are added head to tail, and what runs back is hatched",
          "[michell-bearing][sheets]") {
  const auto strokes = [](const DrawnSheet& drawn) {
    std::size_t count = 0;
    for (const drawings::Line& each : all_of<drawings::Line>(drawn))
      count += each.meaning == drawings::Meaning::velocity && each.name.empty() ? 1 : 0;
    return count;
  };
  const DrawnSheet forwards = bearing().draw("velocities", {});
  CHECK(strokes(forwards) == 0);
  CHECK(strokes(bearing().draw("velocities", {"h_1=0.8", "x_1=0.05"})) > 5);
  std::vector<drawings::Arrow> couette, poiseuille;
  for (const drawings::Arrow& each : all_of<drawings::Arrow>(forwards))
    (each.name == "couette_part" ? couette : poiseuille).push_back(each);
  REQUIRE(couette.size() == 17);  // 6, 5 and 3 depths, and three middles
  REQUIRE(poiseuille.size() == couette.size());
  for (std::size_t i = 0; i < couette.size(); ++i) {
    CHECK(couette[i].to.x == poiseuille[i].from.x);
    CHECK(couette[i].to.y == poiseuille[i].from.y);
  }
}

TEST_CASE("michell bearing: the load stands as an arrow, and its strips above their lines of action",
          "[michell-bearing][sheets]") {
  CHECK(arrow(bearing().draw("pressures", {}), "N").to.y > arrow(bearing().draw("pressures", {}), "N").from.y);
  const DrawnSheet drawn = bearing().draw("load", {});
  const drawings::Arrow sum = arrow(drawn, "N_funicular");
  CHECK(sum.from.x == sum.to.x);
  // The curve of the pressures is as long as the slider below it.
  const auto curve = ends_of(line(drawn, "pressure"));
  const auto slider = all_of<drawings::Ground>(drawn).front();
  CHECK(curve.first.x == Approx(slider.to.x));
  CHECK(curve.second.x == Approx(slider.from.x));
}

TEST_CASE("michell bearing: every fifth of forty strips is numbered, and its ray", "[michell-bearing][sheets]") {
  std::multiset<std::string> numbers;
  for (const drawings::Writing& each : all_of<drawings::Writing>(bearing().draw("integration", {})))
    numbers.insert(each.text);
  for (const char* strip : {"3", "7", "39"}) CHECK(numbers.count(strip) == 0);
  for (const char* both : {"35", "40"}) CHECK(numbers.count(both) == 2);
  CHECK(numbers.count("5") >= 1);
}

TEST_CASE("michell bearing: a unit of several words stays with its number", "[michell-bearing][sheets]") {
  CHECK(tells(bearing().draw("direct", {}), "0.035\u00a0Pa\u00a0s"));
}

TEST_CASE("michell bearing: the misprinted length is told beside the formula it stands in",
          "[michell-bearing][sheets]") {
  CHECK(tells(bearing().draw("direct", {}), "prints 0.0375"));
  CHECK_FALSE(tells(bearing().draw("direct", {"P=70000"}), "0.0375"));
}

TEST_CASE("michell bearing: charts and table of the pressures have one unit", "[michell-bearing][sheets]") {
  const DrawnSheet drawn = bearing().draw("pressures", {});
  const auto writes = [&](const std::string& title) {
    for (const drawings::Writing& each : all_of<drawings::Writing>(drawn))
      if (each.text.find(title) != std::string::npos) return true;
    return false;
  };
  CHECK(writes("MPa/m"));
  CHECK_FALSE(writes("}$ Pa"));  // a power of ten before Pa, or Pa/m
}

TEST_CASE("michell bearing: one pad around the whole ring is round", "[michell-bearing][sheets]") {
  const DrawnSheet drawn = bearing().draw("bearing", {"pads=1", "l_pad=0.6", "x_N=0.36"});
  std::size_t corners = 0;
  for (const drawings::Line& each : all_of<drawings::Line>(drawn))
    if (each.meaning == drawings::Meaning::link) corners = std::max(corners, each.path.pieces.size());
  CHECK(corners > 300);
}

// Both bearings.
TEST_CASE("michell bearing: the ring's sheet has a section through pad and runner", "[michell-bearing][sheets]") {
  const Tried thrust("michell-thrust");
  for (const auto& [tried, sheet, film] :
       {std::tuple(&bearing(), "bearing", "direct."), std::tuple(&thrust, "forces", "theory.")}) {
    const DrawnSheet drawn = tried->draw(sheet, {});
    CAPTURE(sheet);
    const drawings::Arrow speed = arrow(drawn, "runner_speed");
    const auto runner = ends_of(line(drawn, "runner"));
    CHECK(speed.to.x > speed.from.x);
    CHECK(speed.to.y < runner.first.y);
    // Its narrow end lies where the runner goes to.
    std::map<std::string, Measurement> measured;
    for (const Measurement& each : drawn.measurements) measured[each.quantity] = each;
    const Measurement &inlet = measured.at(film + std::string("h_1")),
                      &outlet = measured.at(film + std::string("h_2"));
    CHECK(inlet.from.y == runner.first.y);
    CHECK(outlet.from.x > inlet.from.x);
    CHECK(inlet.to.y > outlet.to.y);
    CHECK(tells(drawn, "times higher than long"));
    const CheckedExercise result = tried->checked({});
    for (const char* name : {"h_1", "h_2"}) {
      const auto& sheets = find(result, film + std::string(name)).on_sheets;
      CHECK(std::any_of(sheets.begin(), sheets.end(), [&](const OnSheet& each) { return each.sheet == sheet; }));
    }
  }
}

TEST_CASE("michell bearing: three pads have their dimensions, and a wide gap one of its own",
          "[michell-bearing][sheets]") {
  const auto letters = [](const Assignments& given) {
    const DrawnSheet drawn = bearing().draw("bearing", given);
    std::multiset<std::string> all;
    for (const drawings::Label& each : drawn.sheet.figure.labels) all.insert(each.text);
    for (const drawings::Dimension& each : all_of<drawings::Dimension>(drawn)) all.insert(each.text);
    return all;
  };
  const auto usual = letters({});
  for (const char* each : {"$b$", "$p_{c}$", "$d$"}) {
    CAPTURE(each);
    CHECK(usual.count(each) == 1);
    CHECK(letters({"pads=3"}).count(each) == 1);
  }
}
