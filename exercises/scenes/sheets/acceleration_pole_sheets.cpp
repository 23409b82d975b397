#include "exercises/scenes/sheets/acceleration_pole_sheets.h"

#include <algorithm>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/scenes/scene_routes.h"
#include "exercises/scenes/sheets/in_lines.h"
#include "exercises/scenes/sheets/scene_figure.h"

namespace epure::scenes {
namespace {

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
std::vector<PolesStep> steps_to_pole(const Solution& s, int link, const std::string& A, const std::string& B) {
  using Where = PolesStep::Where;
  const std::string number = std::to_string(link), tan = "$α_{" + number + "}$ / $ω^{2}_{" + number + "}$",
                    alpha = "$α_{" + number + "}$", K = letters_of_pole(link);
  for (const std::string& X : {A, B})
    if (s.value(acceleration(X).name) == 0.0)
      return {{format_words("{} = 0, so {} is ${}$.", "{} = 0, quindi {} è ${}$.", acceleration(X).length().symbol, K,
                            point_letters(X)),
               Where::pole}};
  if (s.value(angular_acceleration(link).name) == 0.0)
    return {{format_words("{} = 0, and so $γ$ = 0: the ray from ${}$ to {} runs along {}.",
                          "{} = 0, e quindi $γ$ = 0: la semiretta da ${}$ a {} corre lungo la {}.", alpha,
                          point_letters(A), K, acceleration(A).arrow()),
             Where::ray, A},
            {format_words("The ray from ${}$ runs along {}. The two meet in {}.",
                          "La semiretta da ${}$ corre lungo la {}. Le due si incontrano in {}.", point_letters(B),
                          acceleration(B).arrow(), K),
             Where::ray, B}};
  return {{format_words("{0} turned by $γ$ in the sense of {1}, tan $γ$ = |{2}|: the ray from ${3}$ to {4}.",
                        "La {0} ruotata di $γ$ nel verso di {1}, tg $γ$ = |{2}|: la semiretta da ${3}$ a {4}.",
                        acceleration(A).arrow(), alpha, tan, point_letters(A), K),
           Where::ray, A},
          {format_words("{} turned by the same $γ$: the ray from ${}$. The two meet in {}.",
                        "La {} ruotata dello stesso $γ$: la semiretta da ${}$. Le due si incontrano in {}.",
                        acceleration(B).arrow(), point_letters(B), K),
           Where::ray, B}};
}

std::vector<PolesStep> without_pole(int link) {
  return {{format_words(
      "Link {} neither turns nor begins to: all of it has one acceleration, and {} is at infinity.",
      "Il membro {} non ruota, né comincia a farlo: ha tutto una sola accelerazione, e {} è all'infinito.", link,
      letters_of_pole(link))}};
}

// Of one link, as large as the paper lets it be: vectors, rays and angles crowd about it.
PanelSheet pole_sheet(const Scene& scene, const Solution& s, std::size_t which, Language language) {
  const Built built = scene.built(s.givens());
  const std::size_t of = links_with_pole(built).at(which);
  const int link = built.letters.links[of];
  const std::vector<std::string> points = points_of(built, of);
  const std::string &A = points.front(), &B = points.back();
  PolesPanel::Kind kind = PolesPanel::of_acceleration();
  kind.pole = acceleration_centre(link).name;
  kind.letters = letters_of_pole(link);
  PolesPanel panel(s, std::make_shared<const Mechanism>(figure_of(built, s)), kind, {A, B},
                   s.point(kind.pole) ? steps_to_pole(s, link, A, B) : without_pole(link));
  panel.coordinates_from({0, 0});
  PanelSheet sheet;
  sheet.panels = panels(std::move(panel));
  add_in_lines(sheet, {angular_velocity(link).name, angular_acceleration(link).name}, 2);
  sheet.results.push_back(remark(positive_rates.in(language)));
  for (const std::string& X : {A, B}) {
    sheet.told.push_back(acceleration(X).name);
    sheet.results.push_back(components(acceleration(X)));
  }
  sheet.results.push_back(table({from_origin(built, language), "$x$ (m)", "$y$ (m)"},
                                {{kind.letters, {kind.pole + "_x", kind.pole + "_y"}}}));
  sheet.seen = format_words("The mechanism, and the point of link {} that has no acceleration now",
                            "Il meccanismo, e il punto del membro {} che ora non ha accelerazione", link);
  return sheet;
}

}  // namespace

std::vector<SheetMaker> acceleration_pole_sheets(const std::shared_ptr<const Scene>& scene) {
  const Built built = scene->built(Givens(scene->givens()));
  const std::vector<std::size_t> links = links_with_pole(built);
  std::vector<SheetMaker> sheets;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Words title{"Acceleration pole", "Polo delle accelerazioni"};
    const int link = built.letters.links[links[i]];
    sheets.push_back(
        {{i == 0 ? "acceleration-poles" : "acceleration-poles-" + std::to_string(i + 1),
          links.size() == 1 ? title : title + format_words(" of link {}", " del membro {}", link)},
         [scene, i](const Solution& s, Language language) { return pole_sheet(*scene, s, i, language); }});
  }
  return sheets;
}

}  // namespace epure::scenes
