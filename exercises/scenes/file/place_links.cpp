#include "exercises/scenes/file/sections.h"

#include <algorithm>
#include <optional>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/file/refusals.h"
#include "exercises/scenes/scene_routes.h"
#include "geometry/linkages/carried_out.h"
#include "geometry/linkages/every_place.h"
#include "geometry/linkages/wheels_in_order.h"
#include "geometry/numbers/climb.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

// In which order the links are placed, and what the file leaves open.
class Placing : SectionReader {
 public:
  using SectionReader::SectionReader;

  void place() {
    try {
      built_.steps = assur_groups(built_.linkage);
    } catch (const NotPlaced& open) {
      if (!take_sides_from_drawing(open)) tell(open);
      place();
    }
  }
  // Forces are found in the reverse of an order in which each wheel follows one that it meshes with.
  void order_wheels() {
    if (!built_.loads) return;
    WheelsInOrder found = wheels_in_order(built_.linkage, built_.steps);
    if (!found.left.empty()) {
      std::vector<std::string> numbers;
      for (const int wheel : found.left) numbers.push_back(number(wheel));
      std::sort(numbers.begin(), numbers.end());
      refuse(
          section(root_.find("loads") ? "loads" : "masses"),
          format_words("links {} are held by forces in teeth that are found only together, and that is not done yet: "
                       "drive the link that carries the wheels, or one that meshes with a single other, and let "
                       "the couple that drives it now be a load",
                       "i membri {} sono tenuti da forze fra denti che si trovano solo insieme, e questo non si fa "
                       "ancora: muovere il membro che porta le ruote, o una che ingrana con una sola, e dare come "
                       "carico la coppia che ora la muove",
                       enumerated(numbers)));
    }
    built_.steps = std::move(found.steps);
  }
  // What other things are called is no name for a point: P23 is the instant centre of links 2 and 3.
  void demand_names_of_points() const {
    const auto& numbers = built_.letters.links;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (const LinkPoint& p : built_.linkage.links[i].points) {
        if (const std::vector<std::string> two = points_in(letter(p.point)); two.size() == 2)
          refuse(*of_.link_at[i], format_words("{} means {} seen from {}: name the point otherwise",
                                               "{} significa {} visto da {}: dare al punto un altro nome",
                                               letter(p.point), two[0], two[1]));
        for (std::size_t a = 0; a < numbers.size(); ++a)
          for (std::size_t b = a + 1; b < numbers.size(); ++b)
            if (letter(p.point) == instant_centre(numbers[a], numbers[b]).name)
              refuse(*of_.link_at[i],
                     format_words(
                         "{} is the instant centre of links {} and {}: name the point otherwise",
                         "{} è il centro di istantanea rotazione dei membri {} e {}: dare al punto un altro nome",
                         letter(p.point), numbers[a], numbers[b]));
      }
  }
  // A sheet is drawn in doubles: far from the origin they would part more than a pen does.
  void demand_near_origin() const {
    constexpr int most_sizes = 1'000'000'000;
    Rational far = 0, size = 0, lowest[2], highest[2];
    bool is_first = true;
    const auto far_off = [&](const Own& at) {
      far = std::max({far, Rational(CGAL::abs(at.x)), Rational(CGAL::abs(at.y))});
    };
    const auto fixed = [&](const Own& at) {
      far_off(at);
      for (const auto& [axis, x] : {std::pair(0, at.x), std::pair(1, at.y)}) {
        if (is_first || x < lowest[axis]) lowest[axis] = x;
        if (is_first || x > highest[axis]) highest[axis] = x;
        size = std::max<Rational>(size, highest[axis] - lowest[axis]);
      }
      is_first = false;
    };
    const auto moving = [&](const Own& at) { size = std::max<Rational>(size, CGAL::abs(at.x) + CGAL::abs(at.y)); };
    for (std::size_t i = 0; i < built_.linkage.links.size(); ++i) {
      for (const LinkPoint& point : built_.linkage.links[i].points) i == 0 ? fixed(point.at) : moving(point.at);
      // A line is as long as it needs to be: where the frame's is given through tells nothing of the size.
      for (const LinkLine& line : built_.linkage.links[i].lines)
        i == 0 ? far_off(line.through) : moving(line.through);
    }
    if (size != 0 && far > most_sizes * size)
      refuse(*root_.find("links"),
             format_words(
                 "the mechanism lies over {} times its size from the origin of link 1, too far to be drawn",
                 "il meccanismo sta oltre {} volte la sua grandezza dall'origine del membro 1, troppo per disegnarlo",
                 "1e9"));
  }
  // Not of a planet that gears keep from turning, as Ferguson's: wherever the drive is.
  void demand_polodes() const {
    for (const Step& step : built_.steps)
      if (const auto* wheel = std::get_if<GearedWheel>(&step);
          wheel && std::find(built_.polodes.begin(), built_.polodes.end(), wheel->link) != built_.polodes.end() &&
          std::all_of(wheel->turn.times.begin(), wheel->turn.times.end(), [](const Rational& x) { return x == 0; }))
        refuse(section("polodes"),
               format_words("the gears keep link {} from turning: its instant centre is at infinity in every place, "
                            "and it has no polodes",
                            "le ruote impediscono al membro {} di ruotare: il suo centro di istantanea rotazione è "
                            "all'infinito in ogni posizione, ed esso non ha polari",
                            number(wheel->link)));
  }
  void demand_paths_end() const {
    if (built_.paths.empty() && built_.polodes.empty()) return;
    try {
      EveryPlace(built_.linkage, built_.steps);
    } catch (const Impossible& endless) {
      refuse(section(built_.paths.empty() ? "polodes" : "paths"), endless.words());
    }
  }

 private:
  // A drawing tells on which side of two pins a joint lies, and where on its lines; what the file says of it comes
  // first.
  bool take_sides_from_drawing(const NotPlaced& open) {
    bool are_all = open.why == NotPlaced::Why::open_sides;
    for (const OpenSide& side : open.sides) {
      const std::optional<Chosen> chosen = drawn(side);
      are_all = are_all && chosen;
      if (!chosen) continue;
      of_.chosen_at.push_back(&section("points"));
      built_.linkage.chosen.push_back(*chosen);
    }
    return are_all;
  }
  std::optional<Chosen> drawn(const OpenSide& side) const {
    const Own *joint = drawn_point(side.joint), *from = drawn_point(side.from), *to = drawn_point(side.to);
    if (side.kind == OpenSide::Kind::beside_line) {
      const Rational left = joint && from && to ? left_of(*joint, *from, *to) : Rational(0);
      if (left == 0) return {};
      return BesideLine{side.joint, side.from, side.to, left > 0};
    }
    const bool is_on_guide = side.kind == OpenSide::Kind::on_guide;
    const Own* end = is_on_guide ? joint : to;
    const auto line = of_.drawn_lines.find(built_.letters.lines[index(side.line)]);
    if (!from || !end || line == of_.drawn_lines.end()) return {};
    const Sign ahead = sign_along(line->second.along, {end->x - from->x, end->y - from->y});
    if (ahead != Sign::positive && ahead != Sign::negative) return {};
    if (is_on_guide) return OnGuide{side.joint, ahead == Sign::positive, side.line, side.from};
    return SlotPoints{side.line, ahead == Sign::positive, side.from, side.to};
  }
  // nullptr: the drawing has none.
  const Own* drawn_point(int point) const {
    const auto found = of_.drawn.find(point == nothing ? "" : letter(point));
    return found == of_.drawn.end() ? nullptr : &found->second;
  }
  static Sign sign_along(const Direction& direction, const Own& way) {
    return decide([&]<class T>() {
             const Vector<T> along = linkages::unit_vector<T>(direction);
             return along.x * from_rational<T>(way.x) + along.y * from_rational<T>(way.y);
           })
        .sign;
  }
  // X of P -> Q.
  static Rational left_of(const Own& X, const Own& P, const Own& Q) {
    return (Q.x - P.x) * (X.y - P.y) - (Q.y - P.y) * (X.x - P.x);
  }
  [[noreturn]] void tell(const NotPlaced& open) const {
    using Why = NotPlaced::Why;
    if (open.why == Why::contradicting_side) {
      const Tree& at = *of_.chosen_at.at(open.chosen);
      refuse(at, format_words("nothing is open of {} here: leave the line out, or name the points its links hang on",
                              "di {} qui nulla è aperto: togliere la riga, o nominare i punti a cui i membri pendono",
                              at.text));
    }
    if (open.why == Why::open_sides) {
      // What the drawing says of the others need not be written.
      NotPlaced rest(Why::open_sides);
      try {
        assur_groups(built_.linkage);
      } catch (const NotPlaced& still_open) {
        rest.sides = still_open.sides;
      }
      refuse(section("assembly"), in_words(rest, built_));
    }
    refuse(*of_.link_at.at(static_cast<std::size_t>(open.links.front())), in_words(open, built_));
  }
};

}  // namespace

void demand_names_of_points(FileReading& of) { Placing(of).demand_names_of_points(); }

void place_links(FileReading& of) {
  Placing placing(of);
  placing.demand_near_origin();
  placing.place();
  placing.order_wheels();
  of.built.linkage = with_sides_in_full(std::move(of.built.linkage), of.built.steps);
  placing.demand_polodes();
  placing.demand_paths_end();
}

}  // namespace epure::scenes
