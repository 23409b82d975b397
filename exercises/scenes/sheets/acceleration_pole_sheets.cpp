#include "exercises/scenes/sheets/acceleration_pole_sheets.h"

#include <algorithm>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/scenes/scene_routes.h"
#include "exercises/scenes/sheets/in_lines.h"
#include "exercises/scenes/sheets/scene_figure.h"

namespace epure::scenes {
namespace {

constexpr std::size_t most_poles_on_a_sheet = 2;

std::vector<std::string> points_of(const Built& built, std::size_t link) {
  std::vector<std::string> names;
  for (const geometry::LinkPoint& p : built.linkage.links[link].points)
    names.push_back(built.letters.points[index(p.point)]);
  return names;
}

std::vector<std::size_t> links_with_pole(const Built& built) {
  std::vector<std::size_t> all = links_without_pivot(built);
  std::erase_if(all, [&](std::size_t link) { return built.linkage.links[link].points.size() < 2; });
  return all;
}

std::string letters_of_pole(int link) { return "$K_{" + std::to_string(link) + "}$"; }

// From two of the link's points, the rays that its accelerations are turned into by γ.
std::vector<PolesStep> steps_to_pole(int link, const std::string& A, const std::string& B) {
  using Where = PolesStep::Where;
  const std::string number = std::to_string(link), tan = "$α_{" + number + "}$ / $ω^{2}_{" + number + "}$",
                    alpha = "$α_{" + number + "}$";
  return {{format_words("{0} turned by $γ$ in the sense of {1}, tan $γ$ = |{2}|: the ray from ${3}$ to {4}.",
                        "La {0} ruotata di $γ$ nel verso di {1}, tg $γ$ = |{2}|: il raggio da ${3}$ a {4}.",
                        acceleration(A).arrow(), alpha, tan, point_letters(A), letters_of_pole(link)),
           Where::ray, A},
          {format_words("{} turned by the same $γ$: the ray from ${}$. The two meet in {}.",
                        "La {} ruotata dello stesso $γ$: il raggio da ${}$. I due si incontrano in {}.",
                        acceleration(B).arrow(), point_letters(B), letters_of_pole(link)),
           Where::ray, B}};
}

std::vector<PolesStep> without_pole(int link) {
  return {{format_words(
      "Link {} neither turns nor begins to: all of it has one acceleration, and {} is at infinity.",
      "Il membro {} non ruota, né comincia a farlo: ha tutto una sola accelerazione, e {} è all'infinito.", link,
      letters_of_pole(link))}};
}

// All of a sheet show one mechanism, and at one scale.
class LinkPolePanel : public PolesPanel {
 public:
  using PolesPanel::PolesPanel;
  std::string scale_group() const override { return "mechanism"; }
};

PanelSheet poles_sheet(const Scene& scene, const Solution& s, std::size_t page) {
  const Built built = scene.built(s.givens());
  const std::vector<std::size_t> links = links_with_pole(built);
  const std::size_t first = page * most_poles_on_a_sheet,
                    last = std::min(links.size(), first + most_poles_on_a_sheet);
  const auto figure = std::make_shared<const Mechanism>(figure_of(built, s));
  PanelSheet sheet;
  std::vector<std::pair<std::string, std::string>> rows;
  for (std::size_t i = first; i < last; ++i) {
    const int link = built.letters.links[links[i]];
    const std::vector<std::string> points = points_of(built, links[i]);
    PolesPanel::Kind kind = PolesPanel::of_acceleration();
    kind.pole = acceleration_centre(link).name;
    kind.letters = letters_of_pole(link);
    LinkPolePanel panel(s, figure, kind, {points.front(), points.back()},
                        s.point(kind.pole) ? steps_to_pole(link, points.front(), points.back()) : without_pole(link));
    panel.coordinates_from({0, 0});
    sheet.panels.push_back(std::make_unique<LinkPolePanel>(std::move(panel)));
    add_in_lines(sheet, {angular_velocity(link).name, angular_acceleration(link).name}, 2);
    for (const std::string& X : {points.front(), points.back()}) {
      const std::string name = acceleration(X).name;
      if (std::find(sheet.told.begin(), sheet.told.end(), name) != sheet.told.end()) continue;
      sheet.told.push_back(name);
      sheet.results.push_back(components(acceleration(X)));
    }
    rows.emplace_back(kind.letters, kind.pole);
  }
  sheet.results.push_back(coordinates(rows));
  sheet.seen = {"The mechanism, and the points of its links that have no acceleration now",
                "Il meccanismo, e i punti dei suoi membri che ora non hanno accelerazione"};
  return sheet;
}

}  // namespace

std::vector<SheetMaker> acceleration_pole_sheets(const std::shared_ptr<const Scene>& scene) {
  const std::size_t count = links_with_pole(scene->built(Givens(scene->givens()))).size(),
                    pages = (count + most_poles_on_a_sheet - 1) / most_poles_on_a_sheet;
  std::vector<SheetMaker> sheets;
  for (std::size_t page = 0; page < pages; ++page) {
    const std::string number = std::to_string(page + 1);
    const Words title = count == 1 ? Words{"Acceleration pole", "Polo delle accelerazioni"}
                                   : Words{"Acceleration poles", "Poli delle accelerazioni"};
    sheets.push_back({{page == 0 ? "acceleration-poles" : "acceleration-poles-" + number,
                       pages == 1 ? title : title + (" (" + number + ")")},
                      [scene, page](const Solution& s, Language) { return poles_sheet(*scene, s, page); }});
  }
  return sheets;
}

}  // namespace epure::scenes
