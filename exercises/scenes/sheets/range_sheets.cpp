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

PanelSheet range_sheet(const Scene& scene, const Solution& s, std::size_t drive, Language language) {
  const Built built = scene.built(s.givens());
  const Quantity coordinate = driven_coordinates(built)[drive];
  PanelSheet sheet;
  Mechanism mechanism = figure_of(built, s);
  bool has_end = false;
  for (const bool is_greatest : {true, false}) {
    const std::string name = extreme_name(coordinate.name, is_greatest);
    sheet.results.push_back(values({name}));
    if (!s.value(name)) continue;
    if (const auto end = at_end(built, drive, is_greatest)) {
      const int driven = driven_point(built, drive);
      const std::string letters =
          symbol_of_extreme("$" + point_letters(built.letters.points[index(driven)]) + "$", is_greatest);
      has_end = true;
      add_in_outline(mechanism, built, name, in_doubles(end->position.points), {{driven, letters}});
      sheet.results.push_back(remark(end->stopped_by.in(language) + "."));
    }
  }
  if (has_end)
    sheet.results.push_back(remark(Words{"In outline: the mechanism there, at its dead centres.",
                                         "Tratteggiato: il meccanismo lì, nei suoi punti morti."}
                                       .in(language)));
  sheet.panels = panels(MechanismPanel(std::make_shared<const Mechanism>(std::move(mechanism))));
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
