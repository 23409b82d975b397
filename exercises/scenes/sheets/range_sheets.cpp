#include "exercises/scenes/sheets/range_sheets.h"

#include "drawings/text/text.h"
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

// The positions at the ends are what is asked for.
class RangePanel : public MechanismPanel {
 public:
  RangePanel(std::shared_ptr<const Mechanism> now, std::shared_ptr<const Mechanism> with_ends)
      : MechanismPanel(std::move(with_ends)), now_(std::move(now)) {}
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { now_->draw_given(plot); }

 private:
  std::shared_ptr<const Mechanism> now_;
};

PanelSheet range_sheet(const Scene& scene, const Solution& s, std::size_t drive, Language language) {
  const Built built = scene.built(s.givens());
  const Quantity coordinate = driven_coordinates(built)[drive];
  PanelSheet sheet;
  const auto now = std::make_shared<const Mechanism>(figure_of(built, s));
  Mechanism with_ends = *now;
  bool has_end = false;
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
  }
  if (has_end)
    sheet.results.push_back(remark(Words{"In outline: the mechanism there, at its dead centres.",
                                         "Tratteggiato: il meccanismo lì, nei suoi punti morti."}
                                       .in(language)));
  sheet.panels = panels(RangePanel(now, std::make_shared<const Mechanism>(std::move(with_ends))));
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
      sheets.push_back({{"range-" + name, format_words("Range of {}", "Campo di {}", coordinates[*drive].symbol)},
                        [scene, drive = *drive](const Solution& s, Language language) {
                          return range_sheet(*scene, s, drive, language);
                        }});
  return sheets;
}

}  // namespace epure::scenes
