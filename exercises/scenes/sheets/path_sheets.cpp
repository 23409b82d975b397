#include "exercises/scenes/sheets/path_sheets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/linkages/second_order_quantities.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/locus_panel.h"
#include "exercises/scenes/drive_way.h"
#include "exercises/scenes/dyad_equations.h"
#include "exercises/scenes/file/refusals.h"
#include "exercises/scenes/kept_by_givens.h"
#include "exercises/scenes/reached.h"
#include "exercises/scenes/sheets/scene_figure.h"
#include "geometry/linkages/assur_groups.h"
#include "geometry/linkages/every_place.h"

namespace epure::scenes {
namespace {

using geometry::Fast;
using geometry::LinkPoint;
using geometry::Stretched;
using geometry::TurnedLink;

class PathOfScene {
 public:
  PathOfScene(std::shared_ptr<const Built> built, int point)
      : built_(std::move(built)),
        point_(point),
        carrier_(carrier()),
        driven_(driven()),
        pins_(pins()),
        found_(found_before()),
        drawn_(drawn()),
        way_(*built_),
        places_(built_->linkage, built_->steps),
        reached_(reached(*built_, point_)) {
    const geometry::Arithmetic<Fast> scope;
    find_positions();
  }

  const std::string& name() const { return letter(point_); }
  const std::vector<LocusPanel::Position>& positions() const { return positions_; }

  LocusPanel::DrawCurve curve() const {
    return [built = built_, point = point_, reached = reached_, name = "path_of_" + name()](
               Plot& plot, const drawings::Box& room) {
      geometry::Trace trace = geometry::EveryPlace(built->linkage, built->steps)
                                  .path(point, frame_of(plot, room), curve_tolerance_mm / plot.scale().mm_per_unit);
      reached.leave_in(trace);
      draw_branches(plot, trace, Meaning::locus, name);
      return trace;
    };
  }

  std::vector<PanelStep> steps(const Solution& s) const {
    const auto place = [&](std::size_t share, Meaning ink) -> std::optional<Place> {
      if (positions_.empty()) return {};
      const auto& points = positions_[positions_.size() * share / shown_directions].points;
      const auto one = std::find_if(points.begin(), points.end(),
                                    [&](const LocusPanel::Numbered& each) { return each.ink == ink; });
      return (one == points.end() ? points.front() : *one).at;
    };
    std::vector<PanelStep> all{{drive_in_words(), place(7, Meaning::construction)}};
    if (const Words between = joints_in_words(); !between.empty()) all.push_back({between, place(2, Meaning::locus)});
    all.push_back({format_words("The curve through the points: the path of {}.",
                                "La curva per i punti: la traiettoria di {}.", written(point_)),
                   place(5, Meaning::locus)});
    all.push_back({centre_in_words(s), s.point(centre_of_curvature(name()).name)});
    return all;
  }

  // Of a turned link, where it cannot turn fully.
  Words range_in_words() const {
    if (reached_.is_whole() || !std::holds_alternative<TurnedLink>(drive())) return {};
    return {"The drive cannot go all round: where the curve ends the mechanism closes no further.",
            "Il movente non fa il giro completo: dove la curva finisce il meccanismo non si chiude oltre."};
  }

 private:
  const geometry::Linkage& linkage() const { return built_->linkage; }
  const geometry::Drive& drive() const { return linkage().drives.front(); }
  const std::string& letter(int p) const { return built_->letters.points[index(p)]; }
  std::string written(int p) const { return "$" + point_letters(letter(p)) + "$"; }

  // The link that carries the point: of several the one that has most of it, and not the driven one if there is
  // another.
  int carrier() const {
    const auto* turned = std::get_if<TurnedLink>(&drive());
    const auto worth = [&](int link) {
      return std::pair(!turned || turned->link != link, linkage().links[index(link)].points.size());
    };
    const std::vector<int> links = linkage().links_at(point_);
    return *std::max_element(links.begin(), links.end(), [&](int a, int b) { return worth(a) < worth(b); });
  }
  // The drives and gears alone tell where the carrier is.
  bool is_carried_by_drive() const {
    const std::vector<DyadEquation> equations = dyad_equations(*built_);
    const int number = built_->letters.links[index(carrier_)];
    return std::none_of(equations.begin(), equations.end(), [&](const DyadEquation& equation) {
      return std::find(equation.links.begin(), equation.links.end(), number) != equation.links.end();
    });
  }
  // What the drive moves and can be numbered: the pin of a turned link, the slid point, the end of a cylinder.
  std::optional<int> driven() const {
    if (const auto* turned = std::get_if<TurnedLink>(&drive())) {
      for (const LinkPoint& p : linkage().links[index(turned->link)].points)
        if (linkage().links_at(p.point).front() != 0) return p.point;
      return {};
    }
    if (const auto* slid = std::get_if<geometry::SlidPoint>(&drive())) return slid->point;
    const auto& cylinder = std::get<Stretched>(drive());
    return linkage().links_at(cylinder.to).front() != 0 ? cylinder.to : cylinder.from;
  }

  // The pins of the rods whose joint the point is, about which its arcs are; none: its link carries it.
  std::vector<int> pins() const {
    for (const geometry::Step& step : built_->steps) {
      if (const auto* rods = std::get_if<geometry::TwoRods>(&step); rods && rods->joint == point_)
        return {rods->first.pin, rods->second.pin};
      if (const auto* rod = std::get_if<geometry::RodAndTrack>(&step); rod && rod->joint == point_)
        return {rod->rod.pin};
    }
    return {};
  }
  bool joins_links(int p) const {
    return linkage().links_at(p).size() > 1 ||
           std::any_of(linkage().pins.begin(), linkage().pins.end(),
                       [&](const geometry::PinOnLine& pin) { return pin.point == p; });
  }
  // What is found in each position before the point: those pins, or the joints of its link.
  std::vector<int> found_before() const {
    std::vector<int> all = pins_;
    if (all.empty())
      for (const LinkPoint& p : linkage().links[index(carrier_)].points)
        if (joins_links(p.point)) all.push_back(p.point);
    std::erase_if(all, [&](int p) {
      return driven_ == point_ || p == driven_ || p == point_ || linkage().links_at(p).front() == 0;
    });
    return all;
  }
  // The bodies that are drawn in each position: the rods, or the link; of a plate one side, from a hinge to the
  // point, as all would be a thicket.
  std::vector<std::vector<int>> drawn() const {
    std::vector<std::vector<int>> all;
    for (const int pin : pins_) all.push_back({pin, point_});
    if (!all.empty()) return all;
    const std::vector<LinkPoint>& own = linkage().links[index(carrier_)].points;
    std::vector<int> points;
    for (const LinkPoint& p : own) points.push_back(p.point);
    const bool has_driven =
        driven_ != point_ && std::any_of(points.begin(), points.end(), [&](int p) { return p == driven_; });
    if (!are_in_line(own) && (has_driven || !found_.empty()))
      points = {has_driven ? *driven_ : found_.front(), point_};
    return {points};
  }
  static bool are_in_line(const std::vector<LinkPoint>& points) {
    const geometry::Own &A = points.front().at, &B = points.back().at;
    return std::all_of(points.begin(), points.end(), [&](const LinkPoint& p) {
      return (B.x - A.x) * (p.at.y - A.y) == (B.y - A.y) * (p.at.x - A.x);
    });
  }

  geometry::DriveAt<Fast> turned_to(double angle) const {
    return {0, {std::cos(angle), std::sin(angle)}, 0, places_.turns()};
  }
  void find_positions() {
    if (std::holds_alternative<TurnedLink>(drive())) {
      // Within a range at the middles of equal parts: at its ends the mechanism is about to open.
      for (int part = 0; part < shown_directions; ++part) {
        const double share = (part + (reached_.is_whole() ? 0 : 0.5)) / shown_directions;
        add(way_.closed_at(turned_to(reached_.is_whole()
                                         ? 2 * std::numbers::pi * share
                                         : reached_.low() + share * (reached_.high() - reached_.low()))),
            part);
      }
      return;
    }
    const double low = way_.low(), high = way_.high();
    for (int part = 0; part < shown_ways; ++part)
      add(way_.closed_at(DriveWay::at(low + (high - low) * part / (shown_ways - 1))), part);
  }
  void add(const std::optional<geometry::LinkagePosition<Fast>>& at, int number) {
    if (!at) return;
    LocusPanel::Position position;
    const auto place = [&](int p) { return at->points[index(p)]; };
    for (const std::vector<int>& body : drawn_) {
      std::vector<Place>& corners = position.body.empty() ? position.body : position.others.emplace_back();
      for (const int p : body) corners.push_back(place(p));
    }
    const std::string label = std::to_string(number);
    const Place P = place(point_);
    Place middle{0, 0};
    for (const Place& corner : position.body)
      middle = {middle.x + corner.x / static_cast<double>(position.body.size()),
                middle.y + corner.y / static_cast<double>(position.body.size())};
    if (driven_ && *driven_ != point_)
      position.points.push_back({label, place(*driven_), hinge_of_driven(*at), Meaning::construction});
    position.points.push_back({label, P, middle, Meaning::locus});
    for (const int p : found_) position.points.push_back({label, place(p), P, Meaning::construction, 1 + p});
    positions_.push_back(std::move(position));
  }
  Place hinge_of_driven(const geometry::LinkagePosition<Fast>& at) const {
    if (const auto* turned = std::get_if<TurnedLink>(&drive()))
      for (const LinkPoint& p : linkage().links[index(turned->link)].points)
        if (linkage().links_at(p.point).front() == 0) return at.points[index(p.point)];
    return at.points[index(*driven_)];
  }

  Words drive_in_words() const {
    const auto positions_of_driven = [&] {
      return driven_ ? format_words(": the positions of {}", ": le posizioni di {}", written(*driven_)) : Words{};
    };
    if (const auto* turned = std::get_if<TurnedLink>(&drive()))
      return (reached_.is_whole()
                  ? format_words("The axis of link {} in {} directions, from +x on",
                                 "L'asse del membro {} in {} direzioni, da +x",
                                 built_->letters.links[index(turned->link)], shown_directions)
                  : format_words("The axis of link {} in the middles of {} equal parts of the range in which the "
                                 "mechanism closes",
                                 "L'asse del membro {} nei punti medi di {} parti uguali del campo in cui il "
                                 "meccanismo si chiude",
                                 built_->letters.links[index(turned->link)], shown_directions)) +
             (places_.turns() == 1
                  ? Words{}
                  : format_words(", evenly over {} turns", ", spaziate su {} giri", places_.turns())) +
             positions_of_driven() + ".";
    if (const auto* slid = std::get_if<geometry::SlidPoint>(&drive()))
      return format_words("{} in {} places on ${}$, as far as the mechanism closes.",
                          "{} in {} posti su ${}$, fin dove il meccanismo si chiude.", written(slid->point),
                          shown_ways, point_letters(built_->letters.lines[index(slid->guide)]));
    const auto& cylinder = std::get<Stretched>(drive());
    return format_words("The cylinder {}{} in {} lengths, as far as the mechanism closes",
                        "Il cilindro {}{} in {} lunghezze, fin dove il meccanismo si chiude", written(cylinder.from),
                        written(cylinder.to), shown_ways) +
           positions_of_driven() + ".";
  }

  // How gears turn what the point is found from: the first pair that does.
  Words gears_in_words() const {
    std::vector<int> turned{carrier_};
    for (const int p : found_)
      for (const int link : linkage().links_at(p)) turned.push_back(link);
    const auto has = [&](int link) { return std::find(turned.begin(), turned.end(), link) != turned.end(); };
    for (const geometry::MeshingLinks& gear : linkage().gears)
      if (has(gear.first) || has(gear.second))
        return format_words("Wheels {} and {} roll on each other, equal arcs of their pitch circles",
                            "Le ruote {} e {} rotolano l'una sull'altra, archi uguali delle primitive",
                            built_->letters.links[index(gear.first)], built_->letters.links[index(gear.second)]);
    return {};
  }
  std::vector<std::string> written(const std::vector<int>& points) const {
    std::vector<std::string> all;
    for (const int p : points) all.push_back(written(p));
    return all;
  }

  // The joints that are found in each position until the point is.
  Words joints_in_words() const {
    if (point_ == driven_) return {};
    std::vector<std::string> joints;
    bool is_joint = false;
    if (!is_carried_by_drive())
      for (const DyadEquation& equation : dyad_equations(*built_)) {
        is_joint = equation.joint == letter(point_);
        if (!is_joint) joints.push_back("$" + point_letters(equation.joint) + "$");
        const auto& placed = equation.links;
        const int number = built_->letters.links[index(carrier_)];
        if (is_joint || std::find(placed.begin(), placed.end(), number) != placed.end()) break;
      }
    if (!is_joint) {
      const Words gears = gears_in_words();
      const bool is_first = joints.empty() && gears.empty();
      const Words with = format_words("{} tracing paper {} goes with link {} and marks a point.",
                                      "{} carta da lucido {} va con il membro {} e segna un punto.",
                                      is_first ? Words{"On", "Su"} : Words{"on", "su"}, written(point_),
                                      built_->letters.links[index(carrier_)]);
      if (joints.empty()) return (gears.empty() ? gears : gears + "; ") + with;
      return Words{"In each ", "In ognuna "} + enumerated(joints) + "; " + with;
    }
    if (joints.empty() && pins_.size() > 1) {
      const Words gears = gears_in_words();
      const Words found = gears.empty() ? gears
                                        : gears + Words{": the positions of ", ": le posizioni di "} +
                                              enumerated(written(found_)) + ". ";
      return found + format_words("In each {}, by arcs about {}.", "In ognuna {}, con archi da {}.", written(point_),
                                  enumerated(written(pins_)));
    }
    if (joints.empty()) return format_words("In each {}.", "In ognuna {}.", written(point_));
    return Words{"In each position ", "In ogni posizione "} + enumerated(joints) +
           format_words(", then {}.", ", poi {}.", written(point_));
  }

  Words centre_in_words(const Solution& s) const {
    const std::string Omega = "$Ω_{" + point_letters(name()) + "}$", P = written(point_);
    if (s.point(centre_of_curvature(name()).name))
      return format_words(
          "{0} on the normal of the path, at {1} = $v^{{2}}_{{{2}}}$ / $a^{{n}}_{{{2}}}$ from {3}; thin: the circle "
          "that osculates the path now.",
          "{0} sulla normale alla traiettoria, a {1} = $v^{{2}}_{{{2}}}$ / $a^{{n}}_{{{2}}}$ da {3}; sottile: il "
          "cerchio osculatore.",
          Omega, radius_of_curvature(name()).symbol, point_letters(name()), P);
    if (s.value(velocity(name()).name) == 0.0)
      return format_words("Now {} is at rest, and there is no {}.", "Ora {} è fermo, e non c'è {}.", P, Omega);
    return format_words("Now the path is straight: {} is at infinity.",
                        "Ora la traiettoria è diritta: {} è all'infinito.", Omega);
  }

  std::shared_ptr<const Built> built_;
  int point_, carrier_;
  std::optional<int> driven_;
  std::vector<int> pins_, found_;
  std::vector<std::vector<int>> drawn_;
  DriveWay way_;
  geometry::EveryPlace places_;
  std::vector<LocusPanel::Position> positions_;
  Reached reached_;
};

using KeptPath = KeptByGivens<PathOfScene>;

PanelSheet path_sheet(const Scene& scene, const Solution& s, std::size_t which, KeptPath& kept) {
  const auto built = std::make_shared<const Built>(scene.built(s.givens()));
  const auto found = kept.of(s.givens(), [&] { return PathOfScene(built, built->paths.at(which)); });
  const PathOfScene& path = *found;
  const std::string &P = path.name(), letters = point_letters(P), centre = centre_of_curvature(P).name;
  LocusPanel panel(std::make_shared<const Mechanism>(figure_of(*built, s).with_open_blocks()), P, path.positions(),
                   path.curve(), path.steps(s));
  panel.osculated(s.point(centre), centre, "$Ω_{" + letters + "}$");
  const std::string none = s.value(velocity(P).name) == 0.0 ? "–" : "∞";
  PanelSheet sheet;
  sheet.panels = panels(panel);
  sheet.results = {
      [words = path.range_in_words()](const Solution&, Language language) -> std::optional<drawings::Block> {
        if (words.empty()) return {};
        return drawings::Paragraph{words.in(language)};
      },
      table({"", "$x$", "$y$"}, {{"$" + letters + "$ (m)", {P + "_x", P + "_y"}},
                                 {"$v_{" + letters + "}$ (m/s)", {"v_" + P + "_x", "v_" + P + "_y"}},
                                 {"$a_{" + letters + "}$ (m/s²)", {"a_" + P + "_x", "a_" + P + "_y"}},
                                 {"$Ω_{" + letters + "}$ (m)", {centre + "_x", centre + "_y"}, none}}),
      values({radius_of_curvature(P).name})};
  sheet.seen = format_words("The path of {}, with the link that carries it in several positions; {} now",
                            "La traiettoria di {}, con il membro che lo porta in più posizioni; {} ora", P, P);
  sheet.told = {P + "_x", P + "_y"};
  return sheet;
}

}  // namespace

std::vector<SheetMaker> path_sheets(const std::shared_ptr<const Scene>& scene) {
  const Built built = scene->built(Givens(scene->givens()));
  std::vector<SheetMaker> sheets;
  for (std::size_t i = 0; i < built.paths.size(); ++i) {
    const std::string& P = built.letters.points[index(built.paths[i])];
    sheets.push_back(
        {{built.paths.size() == 1 ? "path" : "path-" + P, format_words("Path of {}", "Traiettoria di {}", P)},
         [scene, i, kept = std::make_shared<KeptPath>()](const Solution& s, Language) {
           return path_sheet(*scene, s, i, *kept);
         }});
  }
  return sheets;
}

}  // namespace epure::scenes
