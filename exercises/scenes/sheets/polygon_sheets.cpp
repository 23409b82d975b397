#include "exercises/scenes/sheets/polygon_sheets.h"

#include <algorithm>
#include <utility>

#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/scenes/dyad_equations.h"
#include "exercises/scenes/links_alike.h"
#include "exercises/scenes/sheets/in_lines.h"
#include "exercises/scenes/sheets/scene_figure.h"

namespace epure::scenes {
namespace {

class Drawn {
 public:
  Drawn(const Solution& solution, const DyadEquation& equation, bool is_of_velocities)
      : s_(solution), equation_(equation), is_of_velocities_(is_of_velocities) {}

  VectorPolygon polygon() const {
    VectorPolygon drawn =
        (is_of_velocities_ ? velocity_polygon : acceleration_polygon)(sides(left()), sides(right()));
    // Unless it is a side of this polygon, alone.
    const auto is_side = [&](const std::string& X) {
      return left().size() == 1 && left().front().quantity.name == of(X).name;
    };
    for (const std::string& X : equation_.sums)
      if (!is_side(X)) drawn.images.push_back({.absolute = side(s_, of(X), {}, {}), .relative = {}, .explained = {}});
    for (const Image& image : equation_.images) {
      for (const std::string& corner : {image.first, image.base})
        if (!corner.empty()) drawn.images.push_back(edge(image, corner_at(drawn, corner)));
      drawn.images.push_back(
          {.absolute = side(s_, of(image.point), {}, {}, tip(image)), .relative = {}, .explained = explained(image)});
    }
    return drawn;
  }

  // The lengths of its sides that are no velocities or accelerations of points.
  std::vector<std::string> parts() const {
    std::vector<std::string> names;
    for (const auto* chain : {&right(), &left()})
      for (const Term& term : *chain)
        if (term.source && term.magnitude != "0") names.push_back(term.quantity.name);
    return names;
  }

  // Known ones that are nothing, as of a rod whose ends lie in one place.
  std::vector<Words> vanishing() const {
    std::vector<Words> all;
    for (const auto* chain : {&right(), &left()})
      for (const Term& term : *chain)
        if (term.source && term.magnitude != "0" && term.magnitude != "?" && s_.value(term.quantity.name) == 0.0)
          all.push_back(format_words("{} = 0: {} is no more than a point.", "{} = 0: la {} si riduce a un punto.",
                                     term.magnitude, term.quantity.arrow()));
    return all;
  }

  // The points of which the vectors come from other sheets.
  std::vector<std::string> found_before() const {
    std::vector<std::string> names;
    for (const auto* chain : {&right(), &left()})
      for (const Term& term : *chain)
        if (!term.found_before.empty()) names.push_back(term.found_before);
    return names;
  }

  // The rates of these links by which magnitudes are told.
  std::vector<std::string> known_rates(const std::vector<int>& links) const {
    std::vector<std::string> names;
    for (const int link : links) {
      const Quantity omega = angular_velocity(link), alpha = angular_acceleration(link);
      if (is_told_by(omega.symbol) || is_told_by("$ω^{2}_{" + std::to_string(link) + "}$"))
        names.push_back(omega.name);
      if (is_told_by(alpha.symbol)) names.push_back(alpha.name);
    }
    return names;
  }

  // The points whose vectors are read off the polygon.
  std::vector<std::string> vectors() const {
    std::vector<std::string> names;
    if (s_.has(of(equation_.joint).name)) names.push_back(equation_.joint);
    for (const Image& image : equation_.images) names.push_back(image.point);
    return names;
  }
  VectorQuantity of(const std::string& X) const { return is_of_velocities_ ? velocity(X) : acceleration(X); }

 private:
  const std::vector<Term>& left() const { return is_of_velocities_ ? equation_.v_left : equation_.a_left; }
  const std::vector<Term>& right() const { return is_of_velocities_ ? equation_.v_right : equation_.a_right; }
  bool is_told_by(const std::string& symbol) const {
    for (const auto* chain : {&right(), &left()})
      for (const Term& term : *chain)
        if (term.magnitude.find(symbol) != std::string::npos) return true;
    return false;
  }
  std::vector<PolygonSide> sides(const std::vector<Term>& terms) const {
    std::vector<PolygonSide> all;
    for (const Term& term : terms) {
      PolygonSide one = side(s_, term.quantity, term.direction, term.magnitude, term.tip);
      one.square = term.is_square;
      one.is_subtracted = term.is_subtracted;
      if (!term.along_line.empty()) one.along = s_.vector("along_" + term.along_line);
      if (!term.across_from.empty())
        one.along = geometry::quarter_turn(s_.place(term.across_to) - s_.place(term.across_from));
      all.push_back(std::move(one));
    }
    return all;
  }

  static std::string tip(const Image& image) { return in_mathematics(image.last); }
  // Where the polygon has the corner with these letters.
  static Arrow2 corner_at(const VectorPolygon& polygon, const std::string& letters) {
    const std::string tip = in_mathematics(letters);
    for (const auto* chain : {&polygon.right, &polygon.left}) {
      Arrow2 at{0, 0};
      for (const PolygonSide& side : *chain) {
        if (side.is_drawn()) at = side.is_subtracted ? at - side.v : at + side.v;
        if (side.tip == tip) return at;
      }
    }
    for (const PolygonImage& image : polygon.images)
      if (image.absolute.tip == tip) return image.absolute.v;
    return {0, 0};
  }
  // Of the triangle by which the image is found.
  PolygonImage edge(const Image& image, const Arrow2& from) const {
    const Arrow2 to = s_.vector(of(image.point).name);
    return {.absolute = {.v = to}, .relative = {.v = to - from}, .explained = {}, .closes_triangle = true};
  }
  Words explained(const Image& image) const {
    const std::string origin = is_of_velocities_ ? "O_{v}" : "O_{a}";
    const std::string images = in_mathematics((image.first.empty() ? origin : image.first) + image.base + image.last);
    const std::string body = in_mathematics(image.body);
    if (image.is_in_line)
      return format_words("{}: {} lie in line, in the proportion of {}.",
                          "{}: {} stanno in linea, nella proporzione di {}.", tip(image), images, body);
    return format_words("{}: {} is similar to {}, in the same sense.", "{}: {} è simile a {}, nello stesso verso.",
                        tip(image), images, body);
  }

  const Solution& s_;
  const DyadEquation& equation_;
  bool is_of_velocities_;
};

// Where the vector of a point was found that an equation starts from.
Words sheet_that_finds(const std::vector<DyadEquation>& equations, const std::string& point, bool is_of_velocities,
                       const SheetNumbers& numbers) {
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const std::vector<Image>& images = equations[i].images;
    if ((equations[i].is_joint_found && equations[i].joint == point) ||
        std::any_of(images.begin(), images.end(), [&](const Image& image) { return image.point == point; }))
      return numbers.of(name_of_polygon(equations, i, is_of_velocities));
  }
  return numbers.of(is_of_velocities ? "velocities" : "accelerations");
}

// The vectors that one of the equations starts from, and the sheets that they are from, in this order.
std::vector<Section> found_on_other_sheets(const Drawn& drawn, const std::vector<DyadEquation>& equations,
                                           bool is_of_velocities, const SheetNumbers& numbers) {
  Section found;
  std::vector<Words> sheets;
  for (const std::string& X : drawn.found_before()) {
    const Words sheet = sheet_that_finds(equations, X, is_of_velocities, numbers);
    if (sheet.empty()) continue;
    if (std::find(sheets.begin(), sheets.end(), sheet) == sheets.end()) sheets.push_back(sheet);
    found.lines.push_back(components(drawn.of(X)));
  }
  if (found.lines.empty()) return {};
  for (const Words& sheet : sheets)
    found.heading =
        found.heading + (found.heading.empty() ? Words{"From ", "Dalla "} : Words{" and ", " e dalla "}) + sheet;
  return {found};
}

// The arc of the drive is so near to this pin that another about it would run into that.
bool is_on_short_crank(const Built& built, const Mechanism& figure, const std::string& pin) {
  constexpr double is_short = 0.3;  // of the whole
  const auto name = [&](const geometry::LinkPoint& p) { return built.letters.points[index(p.point)]; };
  for (const geometry::Drive& drive : built.linkage.drives) {
    const auto* turned = std::get_if<geometry::TurnedLink>(&drive);
    if (!turned) continue;
    const auto& points = built.linkage.links[index(turned->link)].points;
    if (std::any_of(points.begin(), points.end(), [&](const auto& p) { return name(p) == pin; }) &&
        distance(figure.at(name(points.front())), figure.at(pin)) < is_short * figure.reach())
      return true;
  }
  return false;
}

// How the links turn that the polygon is of, or how their rotation grows.
std::shared_ptr<const Mechanism> with_rates(Mechanism figure, const Solution& s, const Built& built,
                                            const DyadEquation& equation, bool is_of_velocities) {
  for (const auto& [link, from, to] : equation.rods) {
    const Quantity rate = (is_of_velocities ? angular_velocity : angular_acceleration)(link);
    const bool is_crowded = is_on_short_crank(built, figure, from);
    figure.turning_found(is_crowded ? to : from, is_crowded ? from : to, s.value(rate.name).value_or(0), rate.symbol);
  }
  return std::make_shared<const Mechanism>(std::move(figure));
}

// "ω₄ = ω₃ = ω₂. ": of links that turn as another moving one does, where no vector tells how.
std::string turning_alike(const Built& built, const DyadEquation& equation, bool is_of_velocities) {
  const LinksAlike alike(built);
  const auto is_untold = [&](std::size_t i) {
    const int link = built.letters.links[i];
    return std::find(equation.links.begin(), equation.links.end(), link) != equation.links.end() &&
           std::none_of(equation.rods.begin(), equation.rods.end(),
                        [&](const auto& rod) { return rod.link == link; });
  };
  const auto rate = [&](std::size_t i) {
    return (is_of_velocities ? angular_velocity : angular_acceleration)(built.letters.links[i]).symbol;
  };
  std::string all;
  std::vector<std::size_t> leading{0};  // one of those that turn alike; the frame does not turn
  for (std::size_t i = 1; i < built.linkage.links.size(); ++i) {
    const auto is_as = [&](std::size_t other) { return alike.turn_alike(i, other); };
    if (is_untold(i) || std::any_of(leading.begin(), leading.end(), is_as)) continue;
    leading.push_back(i);
    std::string as_it;
    for (std::size_t j = built.linkage.links.size(); --j > 0;)
      if (is_untold(j) && is_as(j)) as_it += rate(j) + " = ";
    if (!as_it.empty()) all += as_it + rate(i) + ". ";
  }
  return all;
}

PanelSheet polygon_sheet(const Scene& scene, const Solution& s, std::size_t which, bool is_of_velocities,
                         const SheetNumbers& numbers, Language language) {
  const Built built = scene.built(s.givens());
  const std::vector<DyadEquation> equations = dyad_equations(built);
  const DyadEquation& equation = equations.at(which);
  const Drawn drawn(s, equation, is_of_velocities);
  PanelSheet sheet{.panels =
                       panels(MechanismPanel(with_rates(figure_of(built, s), s, built, equation, is_of_velocities)),
                              PolygonPanel(s, drawn.polygon()))};
  sheet.first = found_on_other_sheets(drawn, equations, is_of_velocities, numbers);
  const std::vector<std::string> known = drawn.known_rates(built.letters.links);
  add_in_lines(sheet, known, 2);
  for (const std::string& X : drawn.vectors()) {
    sheet.results.push_back(components(drawn.of(X)));
    sheet.told.push_back(drawn.of(X).name);
  }
  add_in_lines(sheet, drawn.parts(), 2);
  for (const Words& each : drawn.vanishing()) sheet.results.push_back(remark(each.in(language)));
  std::string how;
  for (const std::string& rate :
       is_of_velocities ? equation.rates_from_velocities : equation.rates_from_accelerations)
    how += rate + ". ";
  how += turning_alike(built, equation, is_of_velocities);
  std::vector<std::string> rates;
  for (const int link : equation.links)
    if (const std::string name = (is_of_velocities ? angular_velocity : angular_acceleration)(link).name;
        std::find(known.begin(), known.end(), name) == known.end())
      rates.push_back(name);
  if (!how.empty() || !rates.empty()) sheet.results.push_back(remark(how + positive_rates.in(language)));
  sheet.results.push_back(values(rates));
  sheet.told.insert(sheet.told.end(), rates.begin(), rates.end());
  sheet.seen = is_of_velocities
                   ? format_words("The mechanism, and the polygon of the velocities of {}",
                                  "Il meccanismo, e il poligono delle velocità di {}", equation.joint)
                   : format_words("The mechanism, and the polygon of the accelerations of {}",
                                  "Il meccanismo, e il poligono delle accelerazioni di {}", equation.joint);
  return sheet;
}

// What tells a group's sheets from those of the others: nothing where it is alone, its joint, and where others have
// that too, as a pin that leads several slotted links, the links that it places.
struct GroupName {
  std::string in_name;
  Words in_title;
};
GroupName name_of(const std::vector<DyadEquation>& equations, std::size_t which) {
  if (equations.size() == 1) return {};
  const DyadEquation& own = equations[which];
  GroupName name{"-" + own.joint, format_words(" of {}", " di {}", "$" + point_letters(own.joint) + "$")};
  const auto is_of_joint = [&](const DyadEquation& each) { return each.joint == own.joint; };
  if (std::count_if(equations.begin(), equations.end(), is_of_joint) == 1) return name;
  std::string links;
  for (const int link : own.links) {
    name.in_name += "-" + std::to_string(link);
    links += (links.empty() ? "" : ", ") + std::to_string(link);
  }
  name.in_title = name.in_title + (own.links.size() == 1 ? format_words(", link {}", ", membro {}", links)
                                                         : format_words(", links {}", ", membri {}", links));
  return name;
}

}  // namespace

std::string name_of_polygon(const std::vector<DyadEquation>& equations, std::size_t which, bool is_of_velocities) {
  return (is_of_velocities ? "velocity-polygon" : "acceleration-polygon") + name_of(equations, which).in_name;
}

std::vector<SheetMaker> polygon_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers) {
  const std::vector<DyadEquation> equations = dyad_equations(scene->built(Givens(scene->givens())));
  std::vector<SheetMaker> sheets;
  for (const bool is_of_velocities : {true, false})
    for (std::size_t i = 0; i < equations.size(); ++i) {
      const GroupName group = name_of(equations, i);
      const Words title = (is_of_velocities ? Words{"Velocity polygon", "Poligono delle velocità"}
                                            : Words{"Acceleration polygon", "Poligono delle accelerazioni"}) +
                          group.in_title;
      sheets.push_back({{name_of_polygon(equations, i, is_of_velocities), title},
                        [scene, i, is_of_velocities, numbers](const Solution& s, Language language) {
                          return polygon_sheet(*scene, s, i, is_of_velocities, numbers, language);
                        }});
    }
  return sheets;
}

}  // namespace epure::scenes
