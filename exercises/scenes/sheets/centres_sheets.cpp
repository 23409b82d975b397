#include "exercises/scenes/sheets/centres_sheets.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/scene_routes.h"
#include "exercises/scenes/sheets/centres_panel.h"
#include "exercises/scenes/sheets/in_lines.h"
#include "exercises/scenes/sheets/scene_figure.h"
#include "geometry/linkages/centre_plan.h"

namespace epure::scenes {
namespace {

using geometry::CentrePlan;
using geometry::FoundCentre;
using geometry::PermanentCentre;

constexpr std::size_t most_on_a_sheet = 6;

class CentresOfScene {
 public:
  CentresOfScene(const Built& built, const CentrePlan& plan, const Solution& s) : built_(built), plan_(plan), s_(s) {}

  // Where wheels touch each other, or the lines that they roll on, and then the found centres of links, in their
  // order.
  std::vector<DrawnCentre> all() const {
    std::vector<DrawnCentre> drawn;
    for (const PermanentCentre& centre : plan_.permanent)
      if (centre.gear != geometry::nothing)
        drawn.push_back(of_wheels(centre));
      else if (centre.roll != geometry::nothing)
        drawn.push_back(of_rolling(centre));
    for (const FoundCentre& centre : plan_.found) drawn.push_back(of(centre));
    return drawn;
  }
  // "P₁₂ = A₀, P₂₃ = A: hinges. P₁₄ at infinity, square to g."
  Words joints() const {
    std::string hinges;
    Words slides;
    for (const PermanentCentre& centre : plan_.permanent) {
      if (!is_link(centre.i) || !is_link(centre.j)) continue;
      if (centre.point != geometry::nothing)
        hinges += (hinges.empty() ? "" : ", ") + letters(centre.i, centre.j) + "\u00a0=\u00a0" + point(centre.point);
      else if (!centre.is_of_touching())
        slides = slides + " " +
                 format_words("{} is at infinity, ⊥ ${}$.", "{} è all'infinito, ⊥ ${}$.", letters(centre.i, centre.j),
                              point_letters(built_.letters.lines[index(centre.line)]));
    }
    return (hinges.empty() ? Words{} : Words{hinges + ".", hinges + "."}) + slides;
  }

 private:
  bool is_link(int body) const { return index(body) < built_.linkage.links.size(); }
  std::string point(int p) const { return "$" + point_letters(built_.letters.points[index(p)]) + "$"; }
  PointQuantity quantity(int i, int j) const {
    return instant_centre(built_.letters.links[index(i)], built_.letters.links[index(j)]);
  }
  std::string letters(int i, int j) const {
    const auto [a, b] = std::minmax(built_.letters.links[index(i)], built_.letters.links[index(j)]);
    return "$P_{" + std::to_string(a) + (b < 10 ? "" : ",") + std::to_string(b) + "}$";
  }

  OnLine on_line(int i, int j) const {
    if (const PermanentCentre* joint = plan_.permanent_of(i, j); joint && !joint->is_of_touching()) {
      if (joint->point != geometry::nothing) return {{}, s_.place(built_.letters.points[index(joint->point)]), {}};
      return {{}, {}, geometry::quarter_turn(s_.vector("along_" + built_.letters.lines[index(joint->line)]))};
    }
    const auto at = s_.point(quantity(i, j).name);
    return {letters(i, j), at, at ? std::nullopt : towards_infinity(i, j)};
  }
  // Along the lines on which it was found, which are parallel.
  std::optional<Arrow2> towards_infinity(int i, int j) const {
    for (const FoundCentre& centre : plan_.found) {
      if (std::minmax(centre.i, centre.j) != std::minmax(i, j)) continue;
      for (const int via : {centre.k, centre.l}) {
        const auto along = along_line({on_line(i, via), on_line(via, j)});
        if (along && magnitude(*along) > 0) return along;
      }
    }
    return {};
  }

  // "P₁₂P₂₃"; of what slides, "the line through A square to s".
  Words line_in_words(int i, int k, int j) const {
    const PermanentCentre *first = plan_.permanent_of(i, k), *second = plan_.permanent_of(k, j);
    for (const auto& [slide, other, body] : {std::tuple(first, second, j), {second, first, i}}) {
      if (!slide || slide->line == geometry::nothing || (other && other->point == geometry::nothing)) continue;
      return format_words("the line ⊥ ${}$ through {}", "la retta ⊥ ${}$ per {}",
                          point_letters(built_.letters.lines[index(slide->line)]),
                          other ? point(other->point) : letters(k, body));
    }
    return {letters(i, k) + letters(k, j), letters(i, k) + letters(k, j)};
  }

  // Without its lines, and how it is found.
  DrawnCentre begun(int i, int j) const {
    const std::string name = quantity(i, j).name;
    return {.quantity = name, .letters = letters(i, j), .at = s_.point(name), .lines = {}, .step = {}};
  }
  // On the line of the wheels' centres, as far from each as its pitch circle reaches.
  DrawnCentre of_wheels(const PermanentCentre& centre) const {
    const geometry::MeshingLinks& gear = built_.linkage.gears[index(centre.gear)];
    const int one = built_.linkage.hinge_of(gear.first, gear.carrier),
              other = built_.linkage.hinge_of(gear.second, gear.carrier);
    DrawnCentre drawn = begun(centre.i, centre.j);
    drawn.lines = {{{{}, s_.place(built_.letters.points[index(one)]), {}},
                    {{}, s_.place(built_.letters.points[index(other)]), {}}}};
    drawn.step =
        format_words("{} on {}{}, where the pitch circles of wheels {} and {} touch.",
                     "{} su {}{}, dove si toccano le primitive delle ruote {} e {}.", drawn.letters, point(one),
                     point(other), built_.letters.links[index(gear.first)], built_.letters.links[index(gear.second)]);
    return drawn;
  }
  // At the foot of the wheel's centre.
  DrawnCentre of_rolling(const PermanentCentre& centre) const {
    const geometry::RollingWheel& roll = built_.linkage.rolls[index(centre.roll)];
    const std::string &C = built_.letters.points[index(roll.centre)], &g = built_.letters.lines[index(roll.line)];
    DrawnCentre drawn = begun(centre.i, centre.j);
    drawn.lines = {{{{}, s_.place(C), {}}, {{}, {}, geometry::quarter_turn(s_.vector("along_" + g))}}};
    drawn.step = format_words("{} where wheel {} touches ${}$: at the foot of {}.",
                              "{} dove la ruota {} tocca ${}$: al piede della perpendicolare da {}.", drawn.letters,
                              built_.letters.links[index(roll.wheel)], point_letters(g), point(roll.centre));
    return drawn;
  }
  DrawnCentre of(const FoundCentre& centre) const {
    const auto& [i, j, k, l] = centre;
    DrawnCentre drawn = begun(i, j);
    drawn.lines = {{on_line(i, k), on_line(k, j)}, {on_line(i, l), on_line(l, j)}};
    const Words one = line_in_words(i, k, j), other = line_in_words(i, l, j);
    const auto is_at_infinity = [](const std::pair<OnLine, OnLine>& line) {
      return line.first.towards && line.second.towards;
    };
    for (const auto& [line, finite, via] : {std::tuple(drawn.lines[0], other, k), {drawn.lines[1], one, l}})
      if (!drawn.at && is_at_infinity(line)) {
        drawn.step = format_words("{} at infinity along {}: {} and {} are at infinity too.",
                                  "{} all'infinito lungo {}: lo sono anche {} e {}.", drawn.letters, finite,
                                  letters(i, via), letters(via, j));
        return drawn;
      }
    drawn.step = drawn.at ? format_words("{} where {} and {} meet.", "{} dove si incontrano {} e {}.", drawn.letters,
                                         one, other)
                          : format_words("{} at infinity: {} and {} are parallel.",
                                         "{} all'infinito: {} e {} sono parallele.", drawn.letters, one, other);
    return drawn;
  }

  const Built& built_;
  const CentrePlan& plan_;
  const Solution& s_;
};

std::string name_of_page(std::size_t page) {
  return page == 0 ? "instant-centres" : "instant-centres-" + std::to_string(page + 1);
}

// "P₄₅, P₃₇: sheet 9. P₂₈: sheet 10." of the centres that the shown ones start from and other sheets have.
Words found_on_other_sheets(const std::vector<DrawnCentre>& all, const std::vector<DrawnCentre>& shown,
                            const SheetNumbers& numbers) {
  std::map<std::size_t, std::set<std::string>> pages;
  const auto take = [&](const std::string& letters) {
    const auto is_it = [&](const DrawnCentre& centre) { return centre.letters == letters; };
    const auto found = std::find_if(all.begin(), all.end(), is_it);
    if (found != all.end() && std::none_of(shown.begin(), shown.end(), is_it))
      pages[static_cast<std::size_t>(found - all.begin()) / most_on_a_sheet].insert(letters);
  };
  for (const DrawnCentre& centre : shown)
    for (const auto& [one, other] : centre.lines) {
      take(one.letters);
      take(other.letters);
    }
  Words told;
  for (const auto& [page, letters] : pages) {
    std::string list;
    for (const std::string& each : letters) list += (list.empty() ? "" : ", ") + each;
    if (const Words sheet = numbers.of(name_of_page(page)); !sheet.empty())
      told = told + (told.empty() ? "" : " ") + format_words("{}: {}.", "{}: {}.", list, sheet);
  }
  return told;
}

PanelSheet centres_sheet(const Scene& scene, const Solution& s, std::size_t page, Language language,
                         const SheetNumbers& numbers) {
  const Built built = scene.built(s.givens());
  const CentrePlan plan = centre_plan_of(built);
  const CentresOfScene centres(built, plan, s);
  std::vector<DrawnCentre> all = centres.all();
  const std::size_t first = std::min(all.size(), page * most_on_a_sheet),
                    last = std::min(all.size(), first + most_on_a_sheet);
  std::vector<DrawnCentre> shown(all.begin() + static_cast<std::ptrdiff_t>(first),
                                 all.begin() + static_cast<std::ptrdiff_t>(last));
  const Words before = page == 0 ? centres.joints() : found_on_other_sheets(all, shown, numbers);
  std::vector<Place> points;
  for (const std::string& P : built.letters.points) points.push_back(s.place(P));
  PanelSheet sheet;
  std::vector<Row> rows;
  for (const DrawnCentre& centre : shown) {
    rows.push_back({centre.letters, {centre.quantity + "_x", centre.quantity + "_y"}});
    sheet.told.insert(sheet.told.end(), rows.back().names.begin(), rows.back().names.end());
  }
  if (!rows.empty()) sheet.results.push_back(table({from_origin(built, language), "$x$ (m)", "$y$ (m)"}, rows));
  sheet.panels = panels(CentresPanel(std::make_shared<const Mechanism>(figure_of(built, s)), std::move(points),
                                     std::move(shown), before));
  sheet.seen = {"The mechanism, and the instant centres of its links with the lines on which they lie",
                "Il meccanismo, e i centri di istantanea rotazione dei suoi membri con le rette su cui stanno"};
  return sheet;
}

}  // namespace

std::vector<SheetMaker> centres_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers) {
  const Built built = scene->built(Givens(scene->givens()));
  const CentrePlan plan = centre_plan_of(built);
  const std::size_t count = plan.found.size() + built.linkage.gears.size() + built.linkage.rolls.size(),
                    pages = (count + most_on_a_sheet - 1) / most_on_a_sheet;
  std::vector<SheetMaker> sheets;
  for (std::size_t page = 0; page < pages; ++page) {
    const std::string number = std::to_string(page + 1);
    const Words title{"Instant centres", "Centri di istantanea rotazione"};
    sheets.push_back({{name_of_page(page), pages == 1 ? title : title + " (" + number + ")"},
                      [scene, page, numbers](const Solution& s, Language language) {
                        return centres_sheet(*scene, s, page, language, numbers);
                      }});
  }
  return sheets;
}

}  // namespace epure::scenes
