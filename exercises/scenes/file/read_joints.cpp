#include "exercises/scenes/file/sections.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "exercises/kit/statement/format_words.h"
#include "geometry/linkages/carried_out.h"
#include "geometry/numbers/climb.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

// slides:, gears:, rolls:.
class JointsReader : SectionReader {
 public:
  using SectionReader::SectionReader;

  void slides() {
    const Tree* all = root_.find("slides");
    if (!all) return;
    file_.map(*all,
              {"slides: {A: s}, a point or line on a line", "slides: {A: s}, un punto o una retta su una retta"});
    for (const auto& [key, value] : all->entries) {
      const Words what{"the line is asked on which it slides, or several [s, g]",
                       "si chiede la retta su cui scorre, o più d'una [s, g]"};
      if (value.kind == Tree::Kind::list)
        for (const Tree& item : value.items) slide(key, item, file_.text(item, what));
      else
        slide(key, value, file_.text(value, what));
    }
  }
  // gears: [{wheels: 1 3, on: 2, teeth: [60, 20], inside: yes}].
  void gears() {
    const Tree* all = root_.find("gears");
    if (!all) return;
    const Words what{"gears: [{wheels: 2 4, on: 1, teeth: [20, 40]}]",
                     "gears: [{wheels: 2 4, on: 1, teeth: [20, 40]}]"};
    file_.demand(*all, Tree::Kind::list, what);
    for (const Tree& item : all->items) {
      file_.map(item, what);
      file_.demand_keys(item, {"wheels", "on", "teeth", "inside", "phase", "pressure_angle"});
      built_.linkage.gears.push_back(gear(item, what));
      built_.pressure_angles.push_back(pressure_angle(item, built_.linkage.gears.back().pressure_angle));
    }
  }
  // rolls: [{wheel: 5, centre: C, on: p, radius: 40 mm}].
  void rolls() {
    const Tree* all = root_.find("rolls");
    if (!all) return;
    const Words what{"rolls: [{wheel: 5, centre: C, on: p, radius: 40 mm}]",
                     "rolls: [{wheel: 5, centre: C, on: p, radius: 40 mm}]"};
    file_.demand(*all, Tree::Kind::list, what);
    for (const char* forces : {"loads", "masses", "friction"})
      if (root_.find(forces))
        refuse(*all,
               format_words("forces where a wheel rolls are not found yet: leave out {} or rolls",
                            "le forze dove rotola una ruota non si trovano ancora: togliere {} o rolls", forces));
    for (const Tree& item : all->items) {
      file_.map(item, what);
      file_.demand_keys(item, {"wheel", "centre", "on", "radius", "at", "phase"});
      built_.linkage.rolls.push_back(roll(item, what));
    }
  }

 private:
  RollingWheel roll(const Tree& at, const Words& what) const {
    const Tree &wheel = demand(at, "wheel"), &centre = demand(at, "centre"), &on = demand(at, "on"),
               &radius = demand(at, "radius");
    const std::string C = file_.text(centre, what), g = file_.text(on, what);
    RollingWheel roll{moving_link_of_number(wheel, file_.text(wheel, what)), point(centre, C), line(on, g),
                      length(radius)};
    if (built_.linkage.link_of_line(roll.line) == roll.wheel)
      refuse(on, format_words("{} is a line of link {} itself", "{} è una retta dello stesso membro {}", g,
                              number(roll.wheel)));
    const std::vector<int> there = built_.linkage.links_at(roll.centre);
    if (std::find(there.begin(), there.end(), roll.wheel) == there.end())
      refuse(centre, format_words("{} is no point of link {}: a wheel turns about its centre",
                                  "{} non è un punto del membro {}: una ruota gira attorno al suo centro", C,
                                  number(roll.wheel)));
    if (roll.radius <= 0) refuse(radius, {"a wheel has a radius above zero", "una ruota ha un raggio sopra lo zero"});
    if (const Tree* from = at.find("at")) roll.at = length(*from);
    roll.phase = turning(at, "phase", Kind::angle);
    if (!is_on_the_left(roll, centre, C, g)) roll.radius = -roll.radius;
    return roll;
  }
  // What keeps the centre on a way along the line: a line of its link on which the centre slides, or which slides on
  // a line of another link that has the centre.
  struct Lead {
    int line, own_line = nothing, link = nothing;
  };
  std::vector<Lead> leads_of(const RollingWheel& roll) const {
    const Linkage& of = built_.linkage;
    const int link = of.link_of_line(roll.line);
    std::vector<Lead> all;
    for (const PinOnLine& pin : of.pins)
      if (pin.point == roll.centre && of.link_of_line(pin.line) == link) all.push_back({pin.line});
    for (const LineOnLine& block : of.blocks)
      for (const auto& [one, other] : {std::pair(block.moving, block.guide), {block.guide, block.moving}})
        for (const int carrier : of.links_at(roll.centre))
          if (of.link_of_line(one) == link && of.link_of_line(other) == carrier) all.push_back({one, other, carrier});
    return all;
  }
  // How far left of the line it keeps the centre, and the sine of the angle between the two lines.
  template <class T>
  std::pair<T, T> kept(const RollingWheel& roll, const Lead& lead) const {
    const auto vector = [](const Own& own) { return Vector<T>{from_rational<T>(own.x), from_rational<T>(own.y)}; };
    const LinkLine &g = built_.linkage.line(roll.line), &led = built_.linkage.line(lead.line);
    const Vector<T> along = linkages::unit_vector<T>(g.along), lead_along = linkages::unit_vector<T>(led.along);
    T left = cross(along, vector(led.through) - vector(g.through));
    if (lead.link != nothing) {
      const LinkLine& own = built_.linkage.line(lead.own_line);
      left +=
          dot(along, lead_along) * cross(linkages::unit_vector<T>(own.along),
                                         vector(built_.linkage.place(lead.link, roll.centre)) - vector(own.through));
    }
    return {left, cross(along, lead_along)};
  }
  bool is_on_the_left(const RollingWheel& roll, const Tree& at, const std::string& C, const std::string& g) const {
    std::optional<Lead> parallel;
    for (const Lead& lead : leads_of(roll)) {
      if (decide([&]<class T>() { return kept<T>(roll, lead).second; }).sign != Sign::zero) continue;
      parallel = lead;
      const auto is_kept = [&](bool is_left) {
        return decide([&]<class T>() {
                 const T left = kept<T>(roll, lead).first, r = from_rational<T>(roll.radius);
                 return is_left ? left - r : left + r;
               }).sign == Sign::zero;
      };
      if (is_kept(true)) return true;
      if (is_kept(false)) return false;
    }
    if (parallel)
      refuse(at, format_words("{} is kept {} m from {}, and the radius is {} m",
                              "{} è tenuto a {} m da {}, e il raggio è {} m", C,
                              decimal(std::abs(kept<Fast>(roll, *parallel).first), 4), g,
                              decimal(CGAL::to_double(roll.radius), 4)));
    refuse(at,
           format_words("nothing keeps {0} beside {1}: let it slide on a line of the same link, parallel to {1}, or "
                        "hinge it on a link that is led along {1}",
                        "nulla tiene {0} accanto a {1}: farlo scorrere su una retta dello stesso membro, parallela a "
                        "{1}, o incernierarlo a un membro guidato lungo {1}",
                        C, g));
  }
  void slide(const Tree& key, const Tree& value, const std::string& guide_name) {
    const int guide = line(value, guide_name);
    const int link = built_.linkage.link_of_line(guide);
    if (is_line(key.text)) {
      const int moving = line(key, key.text);
      if (built_.linkage.link_of_line(moving) == link) refuse_own(value, key.text, guide_name);
      built_.linkage.blocks.push_back({moving, guide});
      return;
    }
    const int pin = point(key, key.text);
    const std::vector<int> links = built_.linkage.links_at(pin);
    if (std::find(links.begin(), links.end(), link) != links.end()) refuse_own(value, key.text, guide_name);
    built_.linkage.pins.push_back({pin, guide});
  }
  [[noreturn]] void refuse_own(const Tree& at, const std::string& what, const std::string& guide) const {
    refuse(at, format_words("{} and {} are of one link: nothing slides there",
                            "{} e {} sono di uno stesso membro: lì nulla scorre", what, guide));
  }
  MeshingLinks gear(const Tree& at, const Words& what) const {
    const Tree &wheels = demand(at, "wheels"), &on = demand(at, "on"), &teeth = demand(at, "teeth");
    const std::vector<std::string> both = parted(file_.text(wheels, what));
    if (both.size() != 2)
      refuse(wheels, {"two links mesh, as in  wheels: 2 4", "ingranano due membri, come in  wheels: 2 4"});
    MeshingLinks gear{link_of_number(wheels, both[0]), link_of_number(wheels, both[1]),
                      link_of_number(on, file_.text(on, what)), 1, 1};
    if (gear.first == gear.second || gear.first == gear.carrier || gear.second == gear.carrier)
      refuse(wheels, {"two wheels and the link that carries them are three links",
                      "due ruote e il membro che le porta sono tre membri"});
    for (const int wheel : {gear.first, gear.second})
      if (built_.linkage.hinge_of(wheel, gear.carrier) == nothing)
        refuse(on, format_words("links {} and {} have no hinge: what carries a wheel has its centre",
                                "i membri {} e {} non hanno una cerniera: chi porta una ruota ne ha il centro",
                                built_.letters.links[static_cast<std::size_t>(wheel)],
                                built_.letters.links[static_cast<std::size_t>(gear.carrier)]));
    if (built_.linkage.hinge_of(gear.first, gear.carrier) == built_.linkage.hinge_of(gear.second, gear.carrier))
      refuse(on, {"the two wheels have one centre", "le due ruote hanno un solo centro"});
    std::tie(gear.first_teeth, gear.second_teeth) = sizes(teeth);
    for (const std::size_t k : {0, 1}) {
      const bool is_number = reads_as(teeth.items[0], Kind::pure_number);
      tell(is_number ? format_words("teeth of wheel {}", "denti della ruota {}", both[k])
                     : format_words("radius of wheel {}", "raggio della ruota {}", both[k]),
           &teeth.items[k], is_number ? Kind::pure_number : Kind::length);
    }
    gear.is_inside = is_inside(at);
    if (gear.is_inside && gear.first_teeth == gear.second_teeth)
      refuse(teeth,
             {"of two wheels as large none lies inside the other", "di due ruote uguali nessuna sta dentro l'altra"});
    gear.phase = turning(at, "phase", Kind::angle);
    return gear;
  }
  // Numbers of teeth, or two radii.
  std::pair<Rational, Rational> sizes(const Tree& teeth) const {
    if (teeth.kind != Tree::Kind::list || teeth.items.size() != 2)
      refuse(teeth, {"two numbers of teeth are asked, such as [20, 40], or two radii",
                     "si chiedono due numeri di denti, come [20, 40], o due raggi"});
    std::pair<Rational, Rational> both;
    std::optional<Kind> kind;
    for (const bool is_first : {true, false}) {
      const Tree& item = teeth.items[is_first ? 0 : 1];
      if (!kind) kind = reads_as(item, Kind::pure_number) ? Kind::pure_number : Kind::length;
      Rational& size = is_first ? both.first : both.second;
      size = amount(item, *kind).value;
      if (size <= 0) refuse(item, {"a wheel has more than no teeth", "una ruota ha più di zero denti"});
      if (*kind == Kind::pure_number && size.denominator() != 1)
        refuse(item, {"a wheel has a whole number of teeth; radii have a unit, such as 20.5 mm",
                      "una ruota ha un numero intero di denti; i raggi hanno un'unità, come 20.5 mm"});
    }
    return both;
  }
  // 20 degrees where the file does not say it.
  Words pressure_angle(const Tree& gear, Angle& angle) const {
    const Tree* at = gear.find("pressure_angle");
    if (!at) {
      const bool are_forces_asked = root_.find("loads") || root_.find("masses");
      if (are_forces_asked) tell_once(Words{"pressure angle", "angolo di pressione"} + "\u00a0=\u00a020°");
      return {"20°", "20°"};
    }
    angle = amount(*at, Kind::angle).angle;
    if (sign_of(angle) < 0 || sign_of(angle - Angle{Rational(1, 4)}) >= 0)
      refuse(*at, format_words("\"{}\" is no pressure angle: these are from 0 to below 90 degrees",
                               "\"{}\" non è un angolo di pressione: va da 0 a meno di 90 gradi", at->text));
    tell({"pressure angle", "angolo di pressione"}, at, Kind::angle);
    return words_of_amount(*at, Kind::angle);
  }
  bool is_inside(const Tree& gear) const {
    const Tree* inside = gear.find("inside");
    if (!inside) return false;
    if (inside->text == "yes" || inside->text == "true") return true;
    if (inside->text == "no" || inside->text == "false") return false;
    refuse(*inside, {"inside: yes or no", "inside: yes o no"});
  }
};

}  // namespace

void read_joints(FileReading& of) {
  JointsReader reader(of);
  reader.slides();
  reader.gears();
  reader.rolls();
}

}  // namespace epure::scenes
