#include "exercises/scenes/forces/force_sheets.h"

#include <algorithm>
#include <numbers>

#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/scenes/forces/force_figures.h"
#include "exercises/scenes/forces/force_letters.h"
#include "exercises/scenes/forces/group_sheet.h"
#include "exercises/scenes/forces/signs_in_words.h"
#include "exercises/scenes/sheets/in_lines.h"

namespace epure::scenes {
namespace {

using geometry::nothing;

std::vector<std::string> numbers_of(const Built& built, const GroupForces& group) {
  std::vector<std::string> all;
  for (const LinkForces& body : group.bodies)
    if (body.link != nothing) all.push_back(std::to_string(built.letters.links[index(body.link)]));
  std::sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  return all;
}
// The pin of a group that places no link.
std::string pin_of(const Built& built, const GroupForces& group) {
  const LinkForces& body = group.bodies.front();
  return built.letters.points[index(body.known.front().point)];
}
Words forces_on(const Built& built, const GroupForces& group) {
  const std::vector<std::string> numbers = numbers_of(built, group);
  if (numbers.empty())
    return format_words("Forces on the pin {}", "Forze sul perno {}",
                        "$" + point_letters(pin_of(built, group)) + "$");
  return numbers.size() == 1 ? format_words("Forces on link {}", "Forze sul membro {}", numbers[0])
                             : format_words("Forces on links {}", "Forze sui membri {}", enumerated_links(numbers));
}

Words links_or_pin(const Built& built, const GroupForces& group) {
  const std::vector<std::string> numbers = numbers_of(built, group);
  if (numbers.empty()) {
    const std::string pin = "$" + point_letters(pin_of(built, group)) + "$";
    return format_words("the pin {}", "il perno {}", pin);
  }
  return numbers.size() == 1 ? format_words("link {}", "il membro {}", numbers[0])
                             : format_words("links {}", "i membri {}", enumerated_links(numbers));
}
// "forces-5-6".
std::string name_of_sheet(const Built& built, const GroupForces& group) {
  std::string name = "forces";
  const std::vector<std::string> numbers = numbers_of(built, group);
  if (numbers.empty()) name += "-" + pin_of(built, group);
  for (const std::string& number : numbers) name += "-" + number;
  return name;
}
std::string name_of_polygon(const std::string& sheet) { return sheet + "-polygon"; }

// What is found of a group: "R_45, N_C".
std::string found_of(const Built& built, const ForceFigures& of, const GroupForces& group) {
  std::vector<std::string> symbols;
  const auto add = [&](const std::string& symbol) {
    if (std::find(symbols.begin(), symbols.end(), symbol) == symbols.end()) symbols.push_back(symbol);
  };
  for (const LinkForces& body : group.bodies)
    for (const ActingForce& force : body.sought)
      add(is_of_links(force) ? force_of_two(built, force).length().symbol : letters_of_force(built, force));
  for (const Moments& each : group.moments)
    if (const auto* couple = std::get_if<ActingCouple>(&each.sought)) add(of.quantity(*couple).symbol);
  std::string all;
  for (const std::string& symbol : symbols) all += (all.empty() ? "" : ", ") + symbol;
  return all;
}
// When a group is cut free, why then, what that gives, and on which sheets.
Words turn_of(const Built& built, const ForceFigures& of, const std::vector<GroupForces>& groups, std::size_t i,
              const SheetNumbers& numbers) {
  const Words group = links_or_pin(built, groups[i]);
  const std::string sheet = name_of_sheet(built, groups[i]);
  const Words first = numbers.of(sheet), second = numbers.of(name_of_polygon(sheet)),
              sheets = first + (first.empty() || second.empty() ? Words{} : Words{" and ", " e "}) + second;
  const Words turn =
      groups.size() == 1
          ? format_words("Cut free {}, where only loads act", "Si isola {}, dove agiscono solo carichi", group)
      : i == 0
          ? format_words("First {}, where only loads act", "Per prima cosa {}, dove agiscono solo carichi", group)
          : format_words("{} {}, with what the others exert on it", "{} {}, con ciò che gli altri vi esercitano",
                         i + 1 == groups.size() ? Words{"At last", "Infine"} : Words{"Then", "Poi"}, group);
  return turn + ": " + found_of(built, of, groups[i]) +
         (sheets.empty() ? Words{} : format_words(" ({})", " ({})", sheets)) + ".";
}
// What drives turns about a hinge of the frame: clear of the link, and of what turns it. Another couple is in the
// middle of its link, as on the link cut free.
void add_couple(FreeBodyPanel& whole, const ForceFigures& of, int link, const ActingCouple& couple,
                const Place& otherwise) {
  std::vector<double> occupied = of.directions(link);
  if (couple.kind == ActingCouple::Kind::drive && !occupied.empty()) {
    const double along = occupied.front();
    occupied = {along, along - std::numbers::pi / 3, along + std::numbers::pi / 3, -std::numbers::pi / 2};
  }
  whole.couple(of.quantity(couple).symbol, of.place(couple, link, otherwise), of.value(couple), occupied);
}

bool acts_in_a_centre(const Built& built, std::size_t load) {
  const geometry::LinkForce& force = built.loads->forces[load];
  const auto& masses = built.loads->masses;
  return std::any_of(masses.begin(), masses.end(), [&](const geometry::LinkMass& body) {
    return body.link == force.link && body.at.x == force.at.x && body.at.y == force.at.y;
  });
}

// The whole mechanism with its loads and what drives it, and in which order its links are cut free.
PanelSheet overview(const Built& built, const Solution& s, const SheetNumbers& numbers, Language language) {
  const std::vector<GroupForces> groups = force_groups(built);
  const ForceFigures of(built, s);
  const auto figure = std::make_shared<const Mechanism>(figure_of(built, s));
  const Place middle = middle_of(*figure);
  FreeBodyPanel whole(figure);
  whole.to_scale();
  for (std::size_t k = 0; k < built.loads->forces.size(); ++k) {
    const ActingForce load{ActingForce::Kind::load, static_cast<int>(k), built.loads->forces[k].link};
    // Beside weight and inertia of its point it starts there too, or they would lie on each other.
    whole.load(of.side(load), of.place(load),
               acts_in_a_centre(built, k) ? FreeBodyPanel::Arrow::starts : of.there(load, middle));
  }
  for (std::size_t k = 0; k < built.loads->masses.size(); ++k)
    for (const auto kind : {ActingForce::Kind::weight, ActingForce::Kind::inertia}) {
      const ActingForce force{kind, static_cast<int>(k), built.loads->masses[k].link};
      if (kind == ActingForce::Kind::weight && built.gravity.empty()) continue;
      whole.force(of.side(force), of.place(force));
    }
  PanelSheet sheet;
  std::vector<std::string> efforts, reactions;
  SignsInWords signs(of, built);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const GroupForces& group = groups[i];
    for (const LinkForces& body : group.bodies) {
      for (const ActingCouple& each : body.couples)
        if (each.kind != ActingCouple::Kind::guide && each.kind != ActingCouple::Kind::hinge)
          add_couple(whole, of, body.link, each,
                     of.place(body.sought.empty() ? body.known.front() : body.sought.front()));
      for (const ActingForce& force : body.sought) {
        if (!friction_of(built, force)) signs.add(force);
        const std::string name = name_of_force(built, force);
        if (force.kind == ActingForce::Kind::slid || force.kind == ActingForce::Kind::cylinder)
          whole.effort(of.side(force), of.place(force));
        else if (std::find(reactions.begin(), reactions.end(), name) == reactions.end())
          reactions.push_back(name);
      }
    }
    whole.step(turn_of(built, of, groups, i, numbers), of.place(group.bodies.front().sought.front()));
  }
  for (const geometry::Drive& drive : built.linkage.drives) {
    efforts.push_back(driving_effort(built, drive).name);
    if (std::holds_alternative<geometry::TurnedLink>(drive)) signs.add_couples();
  }
  sheet.panels = panels(std::move(whole));
  for (const std::string& each : efforts) sheet.results.push_back(values({each}));
  if (built.loads->has_friction()) {
    sheet.results.push_back(remark(Words{"Without friction:", "Senza attrito:"}.in(language)));
    for (const geometry::Drive& drive : built.linkage.drives) {
      efforts.push_back(frictionless_effort(built, drive).name);
      sheet.results.push_back(values({efforts.back()}));
    }
    sheet.results.push_back(remark(Words{"Reactions, with friction:", "Reazioni, con l'attrito:"}.in(language)));
  }
  add_in_lines(sheet, reactions, 3);
  if (const Words all = signs.all(); !all.empty()) sheet.results.push_back(remark(all.in(language)));
  sheet.results.push_back(remark(ForceLetters(built).all(groups).in(language)));
  sheet.seen = {"The mechanism with its loads and what drives it",
                "Il meccanismo con i suoi carichi e ciò che lo muove"};
  sheet.told = efforts;
  return sheet;
}

// Then its polygon has a sheet of its own.
bool is_crowded(const GroupForces& group) {
  constexpr std::size_t most = 4;
  std::size_t known = 0;
  for (const LinkForces& body : group.bodies) {
    known += body.known.size();
    for (const ActingCouple& each : body.couples)
      if (each.kind == ActingCouple::Kind::load || each.kind == ActingCouple::Kind::inertia) ++known;
  }
  return known > most;
}

// What the links of a group are known to bear from groups before, and the sheets that find it.
std::vector<Section> found_on_other_sheets(const Built& built, const ForceFigures& of,
                                           const std::vector<GroupForces>& groups, std::size_t i,
                                           const SheetNumbers& numbers) {
  Section found;
  std::vector<Words> sheets;
  const auto add = [&](const GroupForces& group, Result line) {
    const std::string name = name_of_sheet(built, group);
    const Words sheet = numbers.of(is_crowded(group) ? name_of_polygon(name) : name);
    if (sheet.empty()) return;
    if (std::find(sheets.begin(), sheets.end(), sheet) == sheets.end()) sheets.push_back(sheet);
    found.lines.push_back(std::move(line));
  };
  const auto told = [&](const ActingForce& force) {
    if (is_of_links(force)) return components(force_of_two(built, force));
    std::vector<std::string> names{name_of_force(built, force)};
    if (const auto* friction = friction_of(built, force))
      names.insert(names.end(), {contact(built, *friction).normal.name, friction_force(built, *friction).name});
    return values(names);
  };
  for (std::size_t before = 0; before < i; ++before) {
    for (const LinkForces& body : groups[i].bodies)
      for (const ActingForce& force : body.known) {
        const auto is_sought = [&](const LinkForces& other) {
          return std::any_of(other.sought.begin(), other.sought.end(),
                             [&](const ActingForce& each) { return each.is_same(force); });
        };
        if (std::any_of(groups[before].bodies.begin(), groups[before].bodies.end(), is_sought))
          add(groups[before], told(force));
      }
    for (const Moments& each : groups[before].moments)
      if (const auto* sought = std::get_if<ActingCouple>(&each.sought))
        for (const LinkForces& body : groups[i].bodies)
          if (std::any_of(body.couples.begin(), body.couples.end(), [&](const ActingCouple& couple) {
                return couple.kind == sought->kind && couple.which == sought->which;
              }))
            add(groups[before], values({of.quantity(*sought).name}));
  }
  for (const Words& sheet : sheets)
    found.heading =
        found.heading + (found.heading.empty() ? Words{"From ", "Dalla "} : Words{" and ", " e dalla "}) + sheet;
  return found.lines.empty() ? std::vector<Section>{} : std::vector{found};
}

}  // namespace

std::vector<SheetMaker> force_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers) {
  const Built stated = scene->built(Givens(scene->givens()));
  const std::vector<GroupForces> groups = force_groups(stated);
  std::vector<SheetMaker> sheets;
  if (groups.empty()) return sheets;
  sheets.push_back({{"forces", {"Forces", "Forze"}}, [scene, numbers](const Solution& s, Language language) {
                      return overview(scene->built(s.givens()), s, numbers, language);
                    }});
  const auto add = [&](const std::string& name, const Words& title, std::size_t i, Shows shows) {
    sheets.push_back({{name, title}, [scene, numbers, i, shows](const Solution& s, Language language) {
                        const Built built = scene->built(s.givens());
                        const std::vector<GroupForces> all = force_groups(built);
                        PanelSheet sheet = group_sheet(built, s, all.at(i), shows, language);
                        sheet.first = found_on_other_sheets(built, ForceFigures(built, s), all, i, numbers);
                        return sheet;
                      }});
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string name = name_of_sheet(stated, groups[i]);
    const Words title = forces_on(stated, groups[i]);
    if (!is_crowded(groups[i])) {
      add(name, title, i, Shows::all);
      continue;
    }
    add(name, title, i, Shows::bodies);
    add(name_of_polygon(name), title + Words{": polygon", ": poligono"}, i, Shows::polygons);
  }
  return sheets;
}

}  // namespace epure::scenes
