#include "exercises/scenes/sheets/range_sheets.h"

#include <algorithm>

#include "drawings/text/text.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/extremes.h"
#include "exercises/scenes/range_of_drive.h"
#include "exercises/scenes/sheets/scene_figure.h"
#include "geometry/numbers/enclosure.h"

namespace epure::scenes {
namespace {

std::vector<Place> in_doubles(const std::vector<geometry::Point<geometry::Bounded>>& points) {
  std::vector<Place> all;
  for (const auto& [x, y] : points) all.push_back({geometry::midpoint(x).inf(), geometry::midpoint(y).inf()});
  return all;
}

// Letters of the points that are elsewhere then, and of what the drive moves in any case.
std::map<int, std::string> letters_there(const Built& built, const std::vector<Place>& there, const Mechanism& now,
                                         int driven, bool is_greatest) {
  constexpr double apart = 1e-3;  // of the whole
  std::map<int, std::string> letters;
  for (int p = 0; p < built.linkage.count_of_points(); ++p) {
    const std::string& name = built.letters.points[index(p)];
    if (p == driven || distance(there[index(p)], now.at(name)) > apart * now.reach())
      letters[p] = symbol_of_extreme("$" + point_letters(name) + "$", is_greatest);
  }
  return letters;
}

// What the drive moves: a pin of its link, the point, an end of the cylinder.
int driven_point(const Built& built, std::size_t drive) {
  const auto moves = [&](int p) { return built.linkage.links_at(p).front() != 0; };
  const geometry::Drive& of = built.linkage.drives[drive];
  if (const auto* slid = std::get_if<geometry::SlidPoint>(&of)) return slid->point;
  if (const auto* cylinder = std::get_if<geometry::Stretched>(&of))
    return moves(cylinder->to) ? cylinder->to : cylinder->from;
  for (const geometry::LinkPoint& p : built.linkage.links[index(std::get<geometry::TurnedLink>(of).link)].points)
    if (moves(p.point)) return p.point;
  return built.linkage.links[index(std::get<geometry::TurnedLink>(of).link)].points.front().point;
}

// How an end of the range is found, and the arcs, each about a centre, that meet there.
struct EndFound {
  PanelStep step;
  std::vector<std::pair<Place, Place>> arcs = {};
};

// Of two rods that lie in one line there, where the drive turns one of their pins about the frame, or is one of them;
// none: it takes more than one step.
class EndOfRods {
 public:
  EndOfRods(const Built& built, std::size_t drive, const geometry::TwoRods& rods, const std::vector<Place>& there,
            bool is_greatest)
      : built_(built), drive_(drive), rods_(rods), there_(there), is_greatest_(is_greatest) {}

  std::optional<EndFound> found() const {
    for (const auto& [one, other] : {std::pair(rods_.first, rods_.second), {rods_.second, rods_.first}}) {
      if (one.cylinder == static_cast<int>(drive_)) return of_cylinder(one.pin, other.pin);
      if (const auto* turned = std::get_if<geometry::TurnedLink>(&built_.linkage.drives[drive_]))
        if (const int O = built_.linkage.hinge_of(0, turned->link); O != geometry::nothing)
          if (built_.linkage.hinge_of(turned->link, one.link) == one.pin && is_fixed(other.pin))
            return of_crank(O, one.pin, other.pin);
    }
    return {};
  }

 private:
  bool is_fixed(int p) const { return built_.linkage.links_at(p).front() == 0; }
  std::string letters(int p) const { return point_letters(built_.letters.points[index(p)]); }
  std::string at_end(int p) const { return symbol_of_extreme("$" + letters(p) + "$", is_greatest_); }
  std::string way(int from, int to) const { return "$" + letters(from) + letters(to) + "$"; }
  double length(int from, int to) const { return distance(there_[index(from)], there_[index(to)]); }
  Place at(int p) const { return there_[index(p)]; }

  // From the pin that rests both rods reach the crank's pin, one after the other or one upon the other.
  EndFound of_crank(int O, int A, int Q) const {
    const int X = rods_.joint;
    const double first = length(A, X), second = length(Q, X);
    const std::string longer = first > second ? way(A, X) : way(Q, X),
                      shorter = first > second ? way(Q, X) : way(A, X);
    const std::string reach =
        length(A, Q) > std::max(first, second) ? longer + " + " + shorter : longer + " − " + shorter;
    return {{format_words("{0} where the arc about ${1}$ with ${1}{2}$ and that about ${3}$ with {4} meet; {5} in "
                          "line with it and ${3}$.",
                          "{0} dove si incontrano l'arco da ${1}$ con ${1}{2}$ e quello da ${3}$ con {4}; {5} "
                          "allineato con esso e ${3}$.",
                          at_end(A), letters(O), letters(A), letters(Q), reach, at_end(X)),
             at(A)},
            {{at(O), at(A)}, {at(Q), at(A)}}};
  }
  // The rod that turns, in line with the cylinder: towards its hinge or away from it.
  EndFound of_cylinder(int P, int A) const {
    const int X = rods_.joint;
    const bool is_away =
        length(P, X) > length(P, A) && length(P, X) > length(A, X) && dot(at(X) - at(A), at(P) - at(A)) < 0;
    return {
        {format_words("{0} on the line {1}, at the distance {2} from ${3}$, {4} ${5}$.",
                      "{0} sulla retta {1}, a {2} da ${3}$, {4} ${5}$.", at_end(X), way(P, A), way(A, X), letters(A),
                      is_away ? Words{"away from", "lontano da"} : Words{"towards", "verso"}, letters(P)),
         at(X)},
        {{at(A), at(X)}}};
  }

  const Built& built_;
  std::size_t drive_;
  const geometry::TwoRods& rods_;
  const std::vector<Place>& there_;
  bool is_greatest_;
};

// The positions at the ends are what is asked for.
class RangePanel : public MechanismPanel {
 public:
  RangePanel(std::shared_ptr<const Mechanism> now, std::shared_ptr<const Mechanism> with_ends,
             std::vector<EndFound> found)
      : MechanismPanel(std::move(with_ends)), now_(std::move(now)), found_(std::move(found)) {}
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { now_->draw_given(plot); }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    for (const EndFound& end : found_)
      for (const auto& [centre, P] : end.arcs) compass_arc(plot, centre, P);
    return MechanismPanel::draw(plot, room, language);
  }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    std::vector<PanelStep> all;
    for (const EndFound& end : found_) all.push_back(end.step);
    return all;
  }

 private:
  std::shared_ptr<const Mechanism> now_;
  std::vector<EndFound> found_;
};

PanelSheet range_sheet(const Scene& scene, const Solution& s, std::size_t drive, Language language) {
  const Built built = scene.built(s.givens());
  const Quantity coordinate = driven_coordinates(built)[drive];
  PanelSheet sheet;
  const auto now = std::make_shared<const Mechanism>(figure_of(built, s));
  Mechanism with_ends = *now;
  bool has_end = false;
  std::vector<EndFound> found;
  std::string said;
  for (const bool is_greatest : {true, false}) {
    const std::string name = extreme_name(coordinate.name, is_greatest);
    const AtEnd end = at_end(built, drive, is_greatest);
    sheet.results.push_back(values({name}));
    if (const std::string words = end.words.in(language) + "."; end.position || words != said) {
      sheet.results.push_back(remark(words));
      said = words;
    }
    if (!end.position) continue;
    has_end = true;
    const std::vector<Place> there = in_doubles(end.position->points);
    add_in_outline(with_ends, built, name, there,
                   letters_there(built, there, *now, driven_point(built, drive), is_greatest));
    if (!end.rods) continue;
    if (const auto how = EndOfRods(built, drive, *end.rods, there, is_greatest).found()) found.push_back(*how);
  }
  if (has_end)
    sheet.results.push_back(remark(Words{"In outline: the mechanism there, at its dead centres.",
                                         "Tratteggiato: il meccanismo lì, nei suoi punti morti."}
                                       .in(language)));
  sheet.panels = panels(RangePanel(now, std::make_shared<const Mechanism>(std::move(with_ends)), std::move(found)));
  const std::string letters = drawings::plain(coordinate.symbol);
  sheet.seen = format_words("The mechanism now, and where {} is greatest and least",
                            "Il meccanismo ora, e dove {} è massimo e minimo", letters);
  sheet.told = {extreme_name(coordinate.name, true), extreme_name(coordinate.name, false)};
  return sheet;
}

}  // namespace

std::vector<SheetMaker> range_sheets(const std::shared_ptr<const Scene>& scene) {
  const Built built = scene->built(Givens(scene->givens()));
  const std::vector<Quantity> coordinates = driven_coordinates(built);
  std::vector<SheetMaker> sheets;
  for (const std::string& name : scene->extremes())
    if (const auto drive = drive_of_coordinate(built, name))
      sheets.push_back(
          {{"range-" + name, format_words("Range of {}", "Campo di variazione di {}", coordinates[*drive].symbol)},
           [scene, drive = *drive](const Solution& s, Language language) {
             return range_sheet(*scene, s, drive, language);
           }});
  return sheets;
}

}  // namespace epure::scenes
