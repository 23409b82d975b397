#include "exercises/scenes/scene.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "drawings/text/text.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/file_head.h"
#include "exercises/scenes/greek.h"
#include "exercises/scenes/refusals.h"
#include "exercises/scenes/scene_routes.h"
#include "geometry/linkages/every_place.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;
using Tree = TextTree;

// Of a point or a line. P12, P13 ... are the instant centres.
bool is_letter(const std::string& text) {
  constexpr std::size_t longest = 8;
  const bool is_centre =
      text.size() > 2 && text.starts_with("P1") && text.find_first_not_of("0123456789", 2) == std::string::npos;
  return is_name(text) && text.size() <= longest && text.find('_') == std::string::npos && !is_centre;
}

std::vector<std::string> units_of(Kind kind) {
  std::vector<std::string> symbols;
  for (const Unit& unit : known_units())
    if (unit.kind == kind) symbols.push_back(unit.symbol);
  return symbols;
}

// Builds the linkage of a tree at certain givens.
class Building {
 public:
  // The links in this order, by their numbers in the file; that of the file where there is none.
  Building(const File& file, const Tree& root, const Givens& givens, std::vector<int> order = {})
      : file_(file), root_(root), order_(std::move(order)) {
    for (const GivenSpec& spec : givens.specs()) {
      known_[spec.symbol] = amount_of(givens, spec);
      given_.insert(spec.symbol);
    }
  }

  Built built() {
    units();
    where();
    links();
    demand_names_of_points();
    slides();
    gears();
    drives();
    assembly();
    offsets();
    paths();
    polodes();
    loads();
    masses();
    demand_near_origin();
    place();
    built_.linkage = with_sides_in_full(std::move(built_.linkage), built_.steps);
    demand_polodes();
    demand_paths_end();
    return std::move(built_);
  }

 private:
  [[noreturn]] void refuse(const Tree& at, const Words& sentence) const { file_.refuse(at, sentence); }

  // --- numbers ---------------------------------------------------------------------------------------------------
  void units() {
    const Tree* all = root_.find("units");
    if (!all) return;
    file_.map(*all, {"units: {length: mm, angle: deg}", "units: {length: mm, angle: deg}"});
    file_.demand_keys(*all, {"length", "angle"});
    for (const auto& [key, value] : all->entries) {
      const std::string& unit = file_.text(value, {"a unit is asked here", "qui si chiede un'unità"});
      const auto found = find_unit(unit);
      const Kind wanted = key.text == "length" ? Kind::length : Kind::angle;
      if (!found || found->kind != wanted)
        refuse(value, format_words("\"{}\" is no unit of {}; {}", "\"{}\" non è unità di {}; {}", unit,
                                   name_of(wanted), did_you_mean(unit, units_of(wanted))));
      (wanted == Kind::length ? length_unit_ : angle_unit_) = unit;
    }
  }
  // Names for formulas: where: {h: l/2}.
  void where() {
    const Tree* all = root_.find("where");
    if (!all) return;
    file_.map(*all, {"where: {name: formula}", "where: {nome: formula}"});
    for (const auto& [key, value] : all->entries) {
      const std::string name = spelled_out(key.text);
      if (!is_name(name)) refuse(key, format_words("\"{}\" is no name", "\"{}\" non è un nome", key.text));
      if (known_.contains(name))
        refuse(key, format_words("\"{}\" is a given already", "\"{}\" è già un dato", key.text));
      try {
        known_[name] = read_any_amount(file_.text(value, {"a formula is asked", "si chiede una formula"}), known_);
      } catch (const BadFormula& bad) {
        refuse(value, bad.words());
      }
    }
  }
  Amount amount(const Tree& at, Kind kind) const {
    const std::string& text = file_.text(at, format_words("{} is asked here", "qui si chiede {}", name_of(kind)));
    const std::string bare = kind == Kind::length ? length_unit_ : kind == Kind::angle ? angle_unit_ : unit_of(kind);
    try {
      return read_amount(text, kind, bare, known_);
    } catch (const BadFormula& bad) {
      refuse(at, bad.words());
    }
  }
  Rational length(const Tree& at) const { return amount(at, Kind::length).value; }
  Own own(const Tree& at) const {
    if (at.kind != Tree::Kind::list || at.items.size() != 2)
      refuse(at, {"two coordinates are asked, such as [0, 120 mm]", "si chiedono due coordinate, come [0, 120 mm]"});
    return {length(at.items[0]), length(at.items[1])};
  }

  // --- links -----------------------------------------------------------------------------------------------------
  static int index(std::vector<std::string>& names, const std::string& name) {
    const auto place = std::find(names.begin(), names.end(), name) - names.begin();
    if (place == std::ssize(names)) names.push_back(name);
    return static_cast<int>(place);
  }
  int point(const Tree& at, const std::string& name) const {
    const auto& names = built_.letters.points;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      refuse(at, format_words("no link has a point {}; {}", "nessun membro ha un punto {}; {}", name,
                              did_you_mean(name, names)));
    return static_cast<int>(found - names.begin());
  }
  int line(const Tree& at, const std::string& name) const {
    const auto& names = built_.letters.lines;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      refuse(at, format_words("no link has a line {}{}", "nessun membro ha una retta {}{}", name,
                              names.empty() ? Words{} : Words{"; ", "; "} + did_you_mean(name, names)));
    return static_cast<int>(found - names.begin());
  }
  bool is_line(const std::string& name) const {
    const auto& names = built_.letters.lines;
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  void links() {
    const Tree* all = root_.find("links");
    if (!all) refuse(root_, {"links: is missing", "manca links:"});
    file_.map(*all,
              {"links: {1: ..., 2: ...}, link 1 is the frame", "links: {1: ..., 2: ...}, il membro 1 è il telaio"});
    read_drawing();
    const Tree* frame = all->find("1");
    if (!frame) refuse(*all, {"link 1, the frame, is missing", "manca il membro 1, il telaio"});
    link(*frame, 1, *frame);
    std::vector<const std::pair<Tree, Tree>*> entries;
    for (const auto& entry : all->entries) entries.push_back(&entry);
    const auto place = [&](const std::pair<Tree, Tree>* entry) {
      return std::find_if(order_.begin(), order_.end(),
                          [&](int number) { return std::to_string(number) == entry->first.text; });
    };
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const auto* a, const auto* b) { return place(a) < place(b); });
    for (const auto* entry : entries) {
      const auto& [key, value] = *entry;
      if (key.text == "1") continue;
      const bool is_number = !key.text.empty() && key.text.size() <= 4 && key.text[0] != '0' &&
                             key.text.find_first_not_of("0123456789") == std::string::npos;
      if (!is_number)
        refuse(key, format_words("\"{}\" is no number of a link: 1 is the frame, then 2, 3 ...",
                                 "\"{}\" non è un numero di membro: 1 è il telaio, poi 2, 3 ...", key.text));
      link(key, std::stoi(key.text), value);
    }
  }

  // points: where letters lie on a drawing, from which links take their shapes.
  void read_drawing() {
    const Tree* drawing = root_.find("points");
    if (!drawing) return;
    file_.map(*drawing, {"points: {A: [x, y]}", "points: {A: [x, y]}"});
    for (const auto& [key, value] : drawing->entries) {
      demand_letter(key, key.text);
      drawn_[key.text] = own(value);
    }
  }
  void demand_letter(const Tree& at, const std::string& name) const {
    if (!is_letter(name))
      refuse(at, format_words("\"{}\" is no name of a point or line: a letter, then letters and digits, eight at "
                              "most (and P12, P13 ... are the instant centres)",
                              "\"{}\" non è un nome di punto o retta: una lettera, poi lettere e cifre, otto al più "
                              "(e P12, P13 ... sono i centri di istantanea rotazione)",
                              name));
  }

  void link(const Tree& told_at, int number, const Tree& at) {
    link_at_.push_back(&told_at);
    built_.letters.links.push_back(number);
    built_.linkage.links.emplace_back();
    if (at.kind == Tree::Kind::text) {
      for (const std::string& name : parted(at.text)) {
        const auto drawn = drawn_.find(name);
        if (drawn == drawn_.end())
          refuse(at, format_words("{} does not stand under points:", "{} non sta sotto points:", name));
        add_point(at, name, drawn->second);
      }
    } else {
      file_.map(at, {"a link is {A0 A: length}, {A: [x, y], ...}, or letters of points:",
                     "un membro è {A0 A: lunghezza}, {A: [x, y], ...}, o lettere di points:"});
      for (const auto& [key, value] : at.entries) element(key, value);
    }
  }

  void element(const Tree& key, const Tree& value) {
    if (const std::vector<std::string> ends = parted(key.text); ends.size() == 2) {
      const Rational far = length(value);
      if (far <= 0)
        refuse(value, format_words("the bar {} must be longer than zero", "l'asta {} dev'essere più lunga di zero",
                                   key.text));
      add_point(key, ends[0], {0, 0});
      add_point(key, ends[1], {far, 0});
      return;
    }
    demand_letter(key, key.text);
    if (value.kind == Tree::Kind::list) return add_point(key, key.text, own(value));
    file_.map(value, {"a point is [x, y], a line {through: [x, y], along: [1, 0] or 20 deg}",
                      "un punto è [x, y], una retta {through: [x, y], along: [1, 0] o 20 deg}"});
    file_.demand_keys(value, {"through", "along"});
    const Tree* through = value.find("through");
    add_line(key, key.text, through ? own(*through) : Own{0, 0}, direction(value));
  }

  Direction direction(const Tree& line) const {
    const Tree* along = line.find("along");
    if (!along) refuse(line, {"along: is missing", "manca along:"});
    if (along->kind == Tree::Kind::text) return amount(*along, Kind::angle).angle;
    if (along->kind != Tree::Kind::list || along->items.size() != 2)
      refuse(*along, {"a direction is [x, y] or an angle", "una direzione è [x, y] o un angolo"});
    const bool are_pure = std::all_of(along->items.begin(), along->items.end(), [](const Tree& item) {
      return item.text.find_first_not_of("+-0123456789./ ") == std::string::npos;
    });
    const Kind kind = are_pure ? Kind::pure_number : Kind::length;
    const Own vector{amount(along->items[0], kind).value, amount(along->items[1], kind).value};
    if (vector.x == 0 && vector.y == 0) refuse(*along, {"[0, 0] is no direction", "[0, 0] non è una direzione"});
    return vector;
  }

  void add_point(const Tree& at, const std::string& name, const Own& place) {
    demand_letter(at, name);
    const int number = index(built_.letters.points, name);
    Link& link = built_.linkage.links.back();
    for (const LinkPoint& other : link.points) {
      if (other.point == number)
        refuse(at, format_words("{} stands twice in link {}", "{} sta due volte nel membro {}", name,
                                built_.letters.links.back()));
      if (other.at.x == place.x && other.at.y == place.y)
        refuse(at, format_words("{} and {} lie in one place of link {}", "{} e {} stanno in un punto del membro {}",
                                built_.letters.points[static_cast<std::size_t>(other.point)], name,
                                built_.letters.links.back()));
    }
    link.points.push_back({number, place});
  }
  void add_line(const Tree& at, const std::string& name, const Own& through, const Direction& along) {
    if (is_line(name))
      refuse(at,
             format_words("the line {} is of another link already", "la retta {} è già di un altro membro", name));
    built_.linkage.links.back().lines.push_back({index(built_.letters.lines, name), through, along});
  }

  // --- joints, drives, sides -------------------------------------------------------------------------------------
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

  // gears: [{wheels: 1 3, on: 2, teeth: [60, 20], inside: yes}].
  void gears() {
    const Tree* all = root_.find("gears");
    if (!all) return;
    const Words what{"gears: [{wheels: 2 4, on: 1, teeth: [20, 40]}]",
                     "gears: [{wheels: 2 4, on: 1, teeth: [20, 40]}]"};
    file_.demand(*all, Tree::Kind::list, what);
    for (const Tree& item : all->items) {
      file_.map(item, what);
      file_.demand_keys(item, {"wheels", "on", "teeth", "inside", "phase"});
      built_.linkage.gears.push_back(gear(item, what));
    }
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
    gear.is_inside = is_inside(at);
    if (gear.is_inside && gear.first_teeth == gear.second_teeth)
      refuse(teeth,
             {"of two wheels as large none lies inside the other", "di due ruote uguali nessuna sta dentro l'altra"});
    gear.phase = turning(at, "phase", Kind::angle);
    return gear;
  }
  int link_of_number(const Tree& at, const std::string& number) const {
    const auto& links = built_.letters.links;
    const auto found =
        std::find_if(links.begin(), links.end(), [&](int link) { return std::to_string(link) == number; });
    if (found == links.end()) refuse(at, format_words("there is no link {}", "non c'è un membro {}", number));
    return static_cast<int>(found - links.begin());
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
      if (!kind) kind = kind_of_size(item);
      Rational& size = is_first ? both.first : both.second;
      size = amount(item, *kind).value;
      if (size <= 0) refuse(item, {"a wheel has more than no teeth", "una ruota ha più di zero denti"});
      if (*kind == Kind::pure_number && size.denominator() != 1)
        refuse(item, {"a wheel has a whole number of teeth; radii have a unit, such as 20.5 mm",
                      "una ruota ha un numero intero di denti; i raggi hanno un'unità, come 20.5 mm"});
    }
    return both;
  }
  Kind kind_of_size(const Tree& item) const {
    try {
      read_amount(file_.text(item, {"a number of teeth is asked here", "qui si chiede un numero di denti"}),
                  Kind::pure_number, "1", known_);
      return Kind::pure_number;
    } catch (const BadFormula&) {
      return Kind::length;
    }
  }
  bool is_inside(const Tree& gear) const {
    const Tree* inside = gear.find("inside");
    if (!inside) return false;
    if (inside->text == "yes" || inside->text == "true") return true;
    if (inside->text == "no" || inside->text == "false") return false;
    refuse(*inside, {"inside: yes or no", "inside: yes o no"});
  }

  void drives() {
    const Tree* drive = root_.find("drive");
    if (!drive)
      refuse(root_, {"drive: is missing; what moves the mechanism?", "manca drive:; che cosa muove il meccanismo?"});
    if (drive->kind == Tree::Kind::list)
      for (const Tree& one : drive->items) this->drive(one);
    else
      this->drive(*drive);
  }
  void drive(const Tree& at) {
    file_.map(at,
              {"drive: {link: 2, angle: 30 deg, speed: 60 rpm}", "drive: {link: 2, angle: 30 deg, speed: 60 rpm}"});
    if (at.find("link")) return turned(at);
    if (at.find("slide")) return slid(at);
    if (at.find("length")) return stretched(at);
    refuse(at, {"a drive has link:, slide: or length:", "drive vuole link:, slide: o length:"});
  }
  const Tree& demand(const Tree& map, const std::string& key) const {
    const Tree* value = map.find(key);
    if (!value) refuse(map, format_words("{}: is missing", "manca {}:", key));
    return *value;
  }
  Rational rate(const Tree& drive, const std::string& key, Kind kind) const {
    const Tree* value = drive.find(key);
    return value ? amount(*value, kind).value : Rational(0);
  }
  Angle turning(const Tree& drive, const std::string& key, Kind kind) const {
    const Tree* value = drive.find(key);
    return value ? amount(*value, kind).angle : Angle{};
  }

  void turned(const Tree& at) {
    file_.demand_keys(at, {"link", "angle", "speed", "acceleration"});
    const Tree& number = demand(at, "link");
    const auto& links = built_.letters.links;
    const auto found =
        std::find_if(links.begin(), links.end(), [&](int link) { return std::to_string(link) == number.text; });
    if (found == links.end() || found == links.begin())
      refuse(number, format_words("there is no moving link {}", "non c'è un membro mobile {}", number.text));
    built_.linkage.drives.push_back(TurnedLink{
        static_cast<int>(found - links.begin()), turning(at, "angle", Kind::angle),
        turning(at, "speed", Kind::angular_velocity), turning(at, "acceleration", Kind::angular_acceleration)});
  }
  void slid(const Tree& at) {
    file_.demand_keys(at, {"slide", "on", "at", "speed", "acceleration"});
    const Tree &joint = demand(at, "slide"), &on = demand(at, "on");
    const Words what{"a letter is asked here", "qui si chiede una lettera"};
    built_.linkage.drives.push_back(SlidPoint{point(joint, file_.text(joint, what)), line(on, file_.text(on, what)),
                                              length(demand(at, "at")), rate(at, "speed", Kind::velocity),
                                              rate(at, "acceleration", Kind::acceleration)});
  }
  void stretched(const Tree& at) {
    file_.demand_keys(at, {"length", "is", "speed", "acceleration"});
    const Tree& ends_at = demand(at, "length");
    const std::vector<std::string> ends =
        parted(file_.text(ends_at, {"two letters are asked, such as A0 B", "si chiedono due lettere, come A0 B"}));
    if (ends.size() != 2)
      refuse(ends_at, {"two letters are asked, such as A0 B", "si chiedono due lettere, come A0 B"});
    const Tree& is = demand(at, "is");
    const Rational far = length(is);
    if (far <= 0)
      refuse(is, format_words("the cylinder {} must be longer than zero",
                              "il cilindro {} dev'essere più lungo di zero", ends_at.text));
    built_.linkage.drives.push_back(Stretched{point(ends_at, ends[0]), point(ends_at, ends[1]), far,
                                              rate(at, "speed", Kind::velocity),
                                              rate(at, "acceleration", Kind::acceleration)});
  }

  void assembly() {
    const Tree* all = root_.find("assembly");
    if (!all) return;
    file_.map(*all, {"assembly: {B: left of A B0}", "assembly: {B: left of A B0}"});
    for (const auto& [key, value] : all->entries) {
      const std::vector<std::string> words = parted(file_.text(
          value, {"a side is asked here, such as: left of A B0", "qui si chiede un lato, come: left of A B0"}));
      chosen_at_.push_back(&key);
      built_.linkage.chosen.push_back(choice(key, value, words));
    }
  }
  Chosen choice(const Tree& key, const Tree& value, const std::vector<std::string>& words) const {
    const auto is = [&](std::size_t k, const char* word) { return k < words.size() && words[k] == word; };
    if (words.size() == 4 && (is(0, "left") || is(0, "right")) && is(1, "of"))
      return BesideLine{point(key, key.text), point(value, words[2]), point(value, words[3]), is(0, "left")};
    if (words.size() == 3 && (is(0, "ahead") || is(0, "behind")) && is(1, "on")) {
      return OnGuide{point(key, key.text), is(0, "ahead"), line(value, words[2])};
    }
    if (words.size() == 4 && is(0, "from") && is(2, "towards"))
      return SlotPoints{line(key, key.text), true, point(value, words[1]), point(value, words[3])};
    if (words.size() == 5 && is(0, "from") && is(2, "away") && is(3, "from"))
      return SlotPoints{line(key, key.text), false, point(value, words[1]), point(value, words[4])};
    refuse(
        value,
        {"a side reads: left of A B0, right of A B0, ahead on g, behind on g, from O towards A, from O away from A",
         "un lato si scrive: left of A B0, right of A B0, ahead on g, behind on g, from O towards A, from O away "
         "from A"});
  }

  // offsets: {e: P from g}.
  void offsets() {
    const Tree* all = root_.find("offsets");
    if (!all) return;
    file_.map(*all, {"offsets: {e: P from g}, how far a point is left of a line",
                     "offsets: {e: P from g}, quanto un punto sta a sinistra di una retta"});
    for (const auto& [key, value] : all->entries) {
      const std::string name = spelled_out(key.text);
      demand_letter(key, name);
      if (known_.contains(name))
        refuse(key, format_words("\"{}\" is a given already", "\"{}\" è già un dato", key.text));
      const Words what{"an offset reads: P from g", "uno scostamento si scrive: P from g"};
      const std::vector<std::string> words = parted(file_.text(value, what));
      if (words.size() != 3 || words[1] != "from") refuse(value, what);
      built_.offsets.push_back({name, point(value, words[0]), line(value, words[2])});
    }
  }

  // paths: [P, Q].
  void paths() {
    const Tree* all = root_.find("paths");
    if (!all) return;
    const Words what{"paths: [P, Q], the points whose paths are asked for",
                     "paths: [P, Q], i punti di cui si chiede la traiettoria"};
    file_.demand(*all, Tree::Kind::list, what);
    for (const Tree& item : all->items) {
      const int P = point(item, file_.text(item, what));
      if (built_.linkage.links_at(P).front() == 0)
        refuse(item,
               format_words("{} is of the frame: it has no path", "{} è del telaio: non ha traiettoria", letter(P)));
      if (std::find(built_.paths.begin(), built_.paths.end(), P) != built_.paths.end())
        refuse(item, format_words("{} stands here twice", "{} sta qui due volte", letter(P)));
      built_.paths.push_back(P);
    }
    if (!built_.paths.empty() && built_.linkage.drives.size() != 1)
      refuse(*all, format_words("with {} drives a point has no one path",
                                "con {} moventi un punto non ha una sola traiettoria", built_.linkage.drives.size()));
  }

  // polodes: [3].
  void polodes() {
    const Tree* all = root_.find("polodes");
    if (!all) return;
    const Words what{"polodes: [3], the links whose polodes are asked for",
                     "polodes: [3], i membri di cui si chiedono le polari"};
    file_.demand(*all, Tree::Kind::list, what);
    const auto& numbers = built_.letters.links;
    for (const Tree& item : all->items) {
      const auto found = std::find_if(numbers.begin() + 1, numbers.end(),
                                      [&](int number) { return std::to_string(number) == file_.text(item, what); });
      if (found == numbers.end())
        refuse(item, format_words("there is no moving link {}", "non c'è un membro mobile {}", item.text));
      const int link = static_cast<int>(found - numbers.begin());
      if (built_.linkage.hinge_of(0, link) != nothing)
        refuse(item, format_words("link {0} turns about {1}: both of its polodes are that point",
                                  "il membro {0} ruota attorno a {1}: le sue polari sono quel punto", item.text,
                                  letter(built_.linkage.hinge_of(0, link))));
      if (built_.linkage.links[static_cast<std::size_t>(link)].points.empty())
        refuse(item, format_words("link {} has no point to be drawn by: give it one",
                                  "il membro {} non ha un punto con cui disegnarlo: dargliene uno", item.text));
      for (const LineOnLine& block : built_.linkage.blocks)
        if (const int one = built_.linkage.link_of_line(block.moving),
            other = built_.linkage.link_of_line(block.guide);
            (one == 0 && other == link) || (one == link && other == 0))
          refuse(item, format_words("link {} is led along {} and does not turn: it has no polodes",
                                    "il membro {} scorre lungo {} e non ruota: non ha polari", item.text,
                                    built_.letters.lines[static_cast<std::size_t>(block.guide)]));
      if (std::find(built_.polodes.begin(), built_.polodes.end(), link) != built_.polodes.end())
        refuse(item, format_words("{} stands here twice", "{} sta qui due volte", item.text));
      built_.polodes.push_back(link);
    }
    if (!built_.polodes.empty() && built_.linkage.drives.size() != 1)
      refuse(*all, format_words("with {} drives a link has no polodes", "con {} moventi un membro non ha polari",
                                built_.linkage.drives.size()));
  }

  // loads: [{at: P, on: 3, force: 200 N, direction: -90 deg}, {on: 4, couple: 20 N*m}].
  void loads() {
    const Tree* all = root_.find("loads");
    if (!all) return;
    const Words what{"loads: [{at: P, on: 3, force: 200 N, direction: -90 deg}, {on: 4, couple: 20 N*m}]",
                     "loads: [{at: P, on: 3, force: 200 N, direction: -90 deg}, {on: 4, couple: 20 N*m}]"};
    file_.demand(*all, Tree::Kind::list, what);
    demand_no_gears(*all);
    built_.loads.emplace();
    for (const Tree& item : all->items) {
      file_.map(item, what);
      if (item.find("couple"))
        couple(item, what);
      else
        force(item, what);
    }
  }
  void demand_no_gears(const Tree& at) const {
    if (!built_.linkage.gears.empty())
      refuse(at,
             {"forces of wheels that mesh are not found yet", "le forze fra ruote dentate non si trovano ancora"});
  }

  // masses: {3: {mass: 2 kg, at: G, inertia: 0.03 kg*m^2}} and gravity: 9.81 m/s^2, downwards.
  void masses() {
    const Tree *all = root_.find("masses"), *gravity = root_.find("gravity");
    if (gravity && !all)
      refuse(*gravity, {"nothing weighs here: say what the links weigh under  masses: {3: {mass: 2 kg, at: G}}",
                        "qui nulla pesa: dire quanto pesano i membri sotto  masses: {3: {mass: 2 kg, at: G}}"});
    if (!all) return;
    const Words what{"masses: {3: {mass: 2 kg, at: G, inertia: 0.03 kg*m^2}}, link by link",
                     "masses: {3: {mass: 2 kg, at: G, inertia: 0.03 kg*m^2}}, membro per membro"};
    file_.map(*all, what);
    demand_no_gears(*all);
    if (!built_.loads) built_.loads.emplace();
    if (gravity) this->gravity(*gravity);
    for (const auto& [key, value] : all->entries) {
      const int link = link_of_number(key, key.text);
      if (link == 0)
        refuse(key, {"link 1 is the frame: its mass neither moves nor reaches a joint",
                     "il membro 1 è il telaio: la sua massa non si muove né arriva ad alcun vincolo"});
      file_.map(value, what);
      file_.demand_keys(value, {"mass", "at", "inertia"});
      mass(link, value, what);
    }
  }
  void gravity(const Tree& at) {
    Own& g = built_.loads->gravity;
    if (at.kind == Tree::Kind::list) {
      if (at.items.size() != 2)
        refuse(at, {"two components are asked, such as [0, -9.81 m/s^2]",
                    "si chiedono due componenti, come [0, -9.81 m/s^2]"});
      g = {amount(at.items[0], Kind::acceleration).value, amount(at.items[1], Kind::acceleration).value};
      built_.gravity = "$\\it{g}$";
    } else {
      g = {0, -amount(at, Kind::acceleration).value};
      built_.gravity = letters_of_given(at, "$\\it{g}$");
    }
  }
  void mass(int link, const Tree& item, const Words& what) {
    const Tree &size = demand(item, "mass"), *inertia = item.find("inertia"), *at = item.find("at");
    if (!at)
      refuse(item,
             format_words("at: is missing: where the centre of mass is, a point of link {0} or [x, y] in its axes",
                          "manca at:, dov'è il baricentro: un punto del membro {0} o [x, y] nei suoi assi",
                          number(link)));
    LinkMass body{link, {0, 0}, amount(size, Kind::mass).value};
    if (at->kind == Tree::Kind::list) {
      body.at = own(*at);
    } else {
      const int G = point(*at, file_.text(*at, what));
      const std::vector<int> links = built_.linkage.links_at(G);
      if (std::find(links.begin(), links.end(), link) == links.end())
        refuse(*at,
               format_words("link {} has no point {}", "il membro {} non ha un punto {}", number(link), letter(G)));
      body.at = built_.linkage.place(link, G);
    }
    if (inertia) body.inertia = amount(*inertia, Kind::moment_of_inertia).value;
    for (const auto& [tree, value] : {std::pair(&size, body.mass), std::pair(inertia, body.inertia)})
      if (value < 0)
        refuse(*tree, format_words("\"{}\" is below zero, and no mass is",
                                   "\"{}\" è sotto lo zero, e nessuna massa lo è", tree->text));
    built_.loads->masses.push_back(body);
    built_.mass_names.push_back({letters_of_given(size, "$\\it{m}_{" + number(link) + "}$"),
                                 inertia ? letters_of_given(*inertia, "$\\it{J}_{" + number(link) + "}$") : ""});
  }
  std::string letters_of_given(const Tree& at, const std::string& otherwise) const {
    const std::string symbol = spelled_out(at.text);
    return given_.contains(symbol) ? italic_letters(symbol) : otherwise;
  }

  void couple(const Tree& item, const Words& what) {
    file_.demand_keys(item, {"on", "couple"});
    const Tree& on = demand(item, "on");
    const int link = link_of_number(on, file_.text(on, what));
    demand_moving(on, link);
    const Tree& couple = demand(item, "couple");
    built_.loads->couples.push_back({link, amount(couple, Kind::moment).value});
    built_.couple_names.push_back(name_of_load(couple, "T", number(link)));
  }
  // After the given that it is, where no load before is; or after where it acts.
  LoadName name_of_load(const Tree& size, const std::string& letter, const std::string& where) {
    std::string text = spelled_out(size.text);
    const std::size_t first = text.find_first_not_of("- ");
    text = first == std::string::npos ? "" : text.substr(first);
    if (given_.contains(text) && load_names_.insert(text).second) return {text, italic_letters(text), true, {}};
    const std::string of = std::isdigit(static_cast<unsigned char>(where[0])) != 0 ? where : point_letters(where);
    std::string name = letter + "_" + where, script = of;
    for (int k = 2; !load_names_.insert(name).second; ++k) {
      name = letter + "_" + where + "_" + std::to_string(k);
      script = of + "," + std::to_string(k);
    }
    return {name, "$\\it{" + letter + "}_{" + script + "}$", false, {}};
  }
  // "∥ $y$", "∠ −100°".
  std::string direction_of_load(const Tree& item, const LinkForce& load) const {
    const Tree &force = *item.find("force"), *direction = item.find("direction");
    const auto typed = [](std::string text) {
      for (const auto& [from, to] : {std::pair<std::string, std::string>{" deg", "°"}, {"-", "−"}})
        for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
          text.replace(at, from.size(), to);
      return text;
    };
    if (!direction) {
      if (load.components.x == 0 || load.components.y == 0) return load.components.y == 0 ? "∥ $x$" : "∥ $y$";
      return "∥ (" + typed(force.items[0].text) + "; " + typed(force.items[1].text) + ")";
    }
    const Rational quarters = 4 * load.turned.turns;
    if (quarters.denominator() == 1) return Rational(quarters / 2).denominator() == 1 ? "∥ $x$" : "∥ $y$";
    const std::string symbol = spelled_out(direction->text);
    return "∠ " + (given_.contains(symbol) ? given_letters(symbol) : typed(direction->text));
  }
  void force(const Tree& item, const Words& what) {
    file_.demand_keys(item, {"at", "on", "force", "direction"});
    const auto [link, at] = loaded_place(item, what);
    const int at_point = point_in(link, at);
    const Tree &force = demand(item, "force"), *direction = item.find("direction");
    LinkForce load{link, at, {0, 0}};
    if (force.kind == Tree::Kind::list) {
      if (force.items.size() != 2)
        refuse(force, {"two components are asked, such as [120 N, -50 N]",
                       "si chiedono due componenti, come [120 N, -50 N]"});
      if (direction)
        refuse(*direction, {"a force of two components has its direction already",
                            "una forza di due componenti ha già la sua direzione"});
      load.components = {amount(force.items[0], Kind::force).value, amount(force.items[1], Kind::force).value};
    } else {
      load.components = {amount(force, Kind::force).value, 0};
      load.turned = amount(demand(item, "direction"), Kind::angle).angle;
    }
    built_.loads->forces.push_back(load);
    built_.force_names.push_back(name_of_load(force, "Q", at_point != nothing ? letter(at_point) : number(link)));
    built_.force_names.back().direction = direction_of_load(item, load);
  }
  int point_in(int link, const Own& at) const {
    for (const LinkPoint& p : built_.linkage.links[static_cast<std::size_t>(link)].points)
      if (p.at.x == at.x && p.at.y == at.y) return p.point;
    return nothing;
  }
  // A point of a link, or coordinates in its axes.
  std::pair<int, Own> loaded_place(const Tree& item, const Words& what) const {
    const Tree &at = demand(item, "at"), *on = item.find("on");
    if (at.kind == Tree::Kind::list) {
      const Tree& told = demand(item, "on");
      const int link = link_of_number(told, file_.text(told, what));
      demand_moving(told, link);
      return {link, own(at)};
    }
    const int P = point(at, file_.text(at, what));
    const std::vector<int> links = built_.linkage.links_at(P);
    if (!on && links.size() > 1) {
      std::vector<std::string> numbers;
      for (const int link : links) numbers.push_back(number(link));
      refuse(at, format_words("{} is of links {}: say on which the force acts, as  on: {}",
                              "{} è dei membri {}: dire su quale agisce la forza, come  on: {}", letter(P),
                              enumerated(numbers), numbers.back()));
    }
    const int link = on ? link_of_number(*on, file_.text(*on, what)) : links.front();
    if (std::find(links.begin(), links.end(), link) == links.end())
      refuse(*on,
             format_words("link {} has no point {}", "il membro {} non ha un punto {}", number(link), letter(P)));
    demand_moving(on ? *on : at, link);
    return {link, built_.linkage.place(link, P)};
  }
  std::string number(int link) const { return std::to_string(built_.letters.links[static_cast<std::size_t>(link)]); }
  void demand_moving(const Tree& at, int link) const {
    if (link == 0)
      refuse(at, {"link 1 is the frame: what acts on it reaches no joint",
                  "il membro 1 è il telaio: ciò che agisce su di esso non arriva ad alcun vincolo"});
  }

  // Not of a planet that gears keep from turning, as Ferguson's: wherever the drive is.
  void demand_polodes() const {
    for (const Step& step : built_.steps)
      if (const auto* wheel = std::get_if<GearedWheel>(&step);
          wheel && std::find(built_.polodes.begin(), built_.polodes.end(), wheel->link) != built_.polodes.end() &&
          std::all_of(wheel->turn.times.begin(), wheel->turn.times.end(), [](const Rational& x) { return x == 0; }))
        refuse(section("polodes"),
               format_words("the gears keep link {} from turning: its instant centre is at infinity in every place, "
                            "and it has no polodes",
                            "le ruote impediscono al membro {} di ruotare: il suo centro di istantanea rotazione è "
                            "all'infinito in ogni posizione, ed esso non ha polari",
                            number(wheel->link)));
  }

  void demand_paths_end() const {
    if (built_.paths.empty() && built_.polodes.empty()) return;
    try {
      EveryPlace(built_.linkage, built_.steps);
    } catch (const Impossible& endless) {
      refuse(section(built_.paths.empty() ? "polodes" : "paths"), endless.words());
    }
  }

  // --- what the file leaves open -----------------------------------------------------------------------------------
  const std::string& letter(int p) const { return built_.letters.points[static_cast<std::size_t>(p)]; }
  const Tree& section(const char* name) const {
    const Tree* found = root_.find(name);
    return found ? *found : root_;
  }

  // P23 is the instant centre of links 2 and 3.
  // A sheet is drawn in doubles: far from the origin they would part more than a pen does.
  void demand_near_origin() const {
    constexpr int most_sizes = 1'000'000'000;
    Rational far = 0, size = 0, lowest[2], highest[2];
    bool is_first = true;
    const auto far_off = [&](const Own& at) {
      far = std::max({far, Rational(CGAL::abs(at.x)), Rational(CGAL::abs(at.y))});
    };
    const auto fixed = [&](const Own& at) {
      far_off(at);
      for (const auto& [axis, x] : {std::pair(0, at.x), std::pair(1, at.y)}) {
        if (is_first || x < lowest[axis]) lowest[axis] = x;
        if (is_first || x > highest[axis]) highest[axis] = x;
        size = std::max<Rational>(size, highest[axis] - lowest[axis]);
      }
      is_first = false;
    };
    const auto moving = [&](const Own& at) { size = std::max<Rational>(size, CGAL::abs(at.x) + CGAL::abs(at.y)); };
    for (std::size_t i = 0; i < built_.linkage.links.size(); ++i) {
      for (const LinkPoint& point : built_.linkage.links[i].points) i == 0 ? fixed(point.at) : moving(point.at);
      // A line is as long as it needs to be: where the frame's is given through tells nothing of the size.
      for (const LinkLine& line : built_.linkage.links[i].lines)
        i == 0 ? far_off(line.through) : moving(line.through);
    }
    if (size != 0 && far > most_sizes * size)
      refuse(*root_.find("links"),
             format_words(
                 "the mechanism lies over {} times its size from the origin of link 1, too far to be drawn",
                 "il meccanismo sta oltre {} volte la sua grandezza dall'origine del membro 1, troppo per disegnarlo",
                 "1e9"));
  }

  // What other things are called is no name for a point.
  void demand_names_of_points() const {
    const auto& numbers = built_.letters.links;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (const LinkPoint& p : built_.linkage.links[i].points) {
        if (const std::vector<std::string> two = points_in(letter(p.point)); two.size() == 2)
          refuse(*link_at_[i], format_words("{} means {} seen from {}: name the point otherwise",
                                            "{} significa {} visto da {}: dare al punto un altro nome",
                                            letter(p.point), two[0], two[1]));
        for (std::size_t a = 0; a < numbers.size(); ++a)
          for (std::size_t b = a + 1; b < numbers.size(); ++b)
            if (letter(p.point) == instant_centre(numbers[a], numbers[b]).name)
              refuse(*link_at_[i],
                     format_words(
                         "{} is the instant centre of links {} and {}: name the point otherwise",
                         "{} è il centro di istantanea rotazione dei membri {} e {}: dare al punto un altro nome",
                         letter(p.point), numbers[a], numbers[b]));
      }
  }

  void place() {
    try {
      built_.steps = assur_groups(built_.linkage);
    } catch (const NotPlaced& open) {
      if (!take_sides_from_drawing(open)) tell(open);
      place();
    }
  }

  // A drawing tells on which side of two pins a joint lies, exactly; what the file says of it comes first.
  bool take_sides_from_drawing(const NotPlaced& open) {
    bool are_all = open.why == NotPlaced::Why::open_sides;
    for (const OpenSide& side : open.sides) {
      const auto X = drawn_.find(side.joint == nothing ? "" : letter(side.joint)), none = drawn_.end();
      const auto P = side.from == nothing ? none : drawn_.find(letter(side.from)),
                 Q = side.to == nothing ? none : drawn_.find(letter(side.to));
      const Rational left =
          X == none || P == none || Q == none ? Rational(0) : left_of(X->second, P->second, Q->second);
      are_all = are_all && left != 0;
      if (left == 0) continue;
      chosen_at_.push_back(&section("points"));
      built_.linkage.chosen.push_back(BesideLine{side.joint, side.from, side.to, left > 0});
    }
    return are_all;
  }
  // X of P -> Q.
  static Rational left_of(const Own& X, const Own& P, const Own& Q) {
    return (Q.x - P.x) * (X.y - P.y) - (Q.y - P.y) * (X.x - P.x);
  }

  [[noreturn]] void tell(const NotPlaced& open) const {
    using Why = NotPlaced::Why;
    if (open.why == Why::contradicting_side) {
      const Tree& at = *chosen_at_.at(open.chosen);
      refuse(at, format_words("nothing is open of {} here: leave the line out, or name the points its links hang on",
                              "di {} qui nulla è aperto: togliere la riga, o nominare i punti a cui i membri pendono",
                              at.text));
    }
    if (open.why == Why::open_sides) {
      // What the drawing says of the others need not be written.
      NotPlaced rest(Why::open_sides);
      try {
        assur_groups(built_.linkage);
      } catch (const NotPlaced& still_open) {
        rest.sides = still_open.sides;
      }
      refuse(section("assembly"), in_words(rest, built_));
    }
    refuse(*link_at_.at(static_cast<std::size_t>(open.links.front())), in_words(open, built_));
  }

  const File& file_;
  const Tree& root_;
  std::vector<int> order_;
  Amounts known_;
  std::set<std::string> given_, load_names_;
  std::string length_unit_ = "m", angle_unit_ = {};
  std::map<std::string, Own> drawn_;
  std::vector<const Tree*> chosen_at_, link_at_;  // where the file says so
  Built built_;
};

// Capitals upright are points, and two of them a length.
bool is_of_mass(Kind kind) {
  return kind == Kind::force || kind == Kind::moment || kind == Kind::mass || kind == Kind::moment_of_inertia;
}

// charts: [omega_4, [v_B, v_C]].
std::vector<std::vector<std::string>> read_charts(const File& file, const Tree& all) {
  const Words what{
      "charts: [omega_4, [v_B, v_C]], quantities over all places of the drive, a chart each or together",
      "charts: [omega_4, [v_B, v_C]], grandezze in tutte le posizioni del movente, un grafico ciascuna o insieme"};
  file.demand(all, Tree::Kind::list, what);
  std::vector<std::vector<std::string>> charts;
  for (const Tree& item : all.items) {
    std::vector<std::string> names;
    if (item.kind == Tree::Kind::list)
      for (const Tree& each : item.items) names.push_back(spelled_out(file.text(each, what)));
    else
      names.push_back(spelled_out(file.text(item, what)));
    if (names.empty()) file.refuse(item, what);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
          names.begin() + static_cast<std::ptrdiff_t>(i))
        file.refuse(item, format_words("{} stands here twice", "{} sta qui due volte", names[i]));
    if (std::find(charts.begin(), charts.end(), names) != charts.end())
      file.refuse(item, {"this chart stands here twice", "questo grafico sta qui due volte"});
    charts.push_back(std::move(names));
  }
  return charts;
}

// A chart has one axis, and that ends.
void demand_one_way(const File& file, const Tree& at, const Built& built) {
  if (built.linkage.drives.size() != 1)
    file.refuse(
        at, format_words("with {} drives there is no one way to chart over",
                         "con {} moventi non c'è un solo moto su cui fare il grafico", built.linkage.drives.size()));
  try {
    EveryPlace(built.linkage, built.steps);
  } catch (const Impossible& endless) {
    file.refuse(at, endless.words());
  }
}

}  // namespace

Scene::Scene(std::string file_name, std::string_view bytes)
    : file_(std::move(file_name)), root_(read_text_tree(file_, bytes)) {
  const File file(file_);
  file.map(root_, {"a scene is a list of keys and values, such as  id: four-bar",
                   "una scena è un elenco di chiavi e valori, come  id: four-bar"});
  file.demand_keys(root_, {"epure",  "id",     "title",  "source",  "givens",   "where",   "units", "points",
                           "links",  "slides", "gears",  "drive",   "assembly", "offsets", "paths", "polodes",
                           "charts", "loads",  "masses", "gravity", "sheets",   "printed"});
  const FileHead head = read_head(file, root_);
  id_ = head.id;
  title_ = head.title;
  source_ = head.source;
  givens_ = head.givens;
  for (GivenSpec& given : givens_)
    if (const auto unit = find_unit(given.unit); unit && is_of_mass(unit->kind))
      given.letters = italic_letters(given.symbol);
  printed_ = head.printed;
  const Built stated = built(Givens(givens_));
  if (const TextTree* charts = root_.find("charts")) {
    charts_ = read_charts(file, *charts);
    demand_one_way(file, *charts, stated);
  }
}

void Scene::demand_charts(const std::vector<Quantity>& quantities) const {
  const File file(file_);
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities) names.push_back(quantity.name);
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    std::string unit;
    for (const std::string& name : charts_[i]) {
      const TextTree& item = root_.find("charts")->items[i];
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        file.refuse(
            item, format_words("this mechanism has no quantity \"{}\"; {}",
                               "questo meccanismo non ha la grandezza \"{}\"; {}", name, did_you_mean(name, names)));
      const Quantity& quantity = quantities[static_cast<std::size_t>(found - names.begin())];
      if (!unit.empty() && unit != quantity.unit)
        file.refuse(
            item,
            format_words("one chart has one unit, and {} is in {}, not in {}; write a chart for each",
                         "un grafico ha una sola unità, e {} è in {}, non in {}; scrivere un grafico per ciascuna",
                         name, quantity.unit, unit));
      unit = quantity.unit;
    }
  }
}

void Scene::demand_one_meaning(const std::vector<Quantity>& quantities) const {
  std::map<std::string, const Quantity*> known;
  for (const Quantity& each : quantities) {
    const auto [found, is_new] = known.emplace(each.name, &each);
    const Words &one = found->second->meaning, &other = each.meaning;
    if (is_new || one.english == other.english) continue;
    const File file(file_);
    file.refuse(*root_.find("links"),
                format_words("{} would be two things, \"{}\" and \"{}\": give a point or a line another name",
                             "{} sarebbe due cose, \"{}\" e \"{}\": dare a un punto o a una retta un altro nome",
                             each.name, Words{drawings::plain(one.english), drawings::plain(one.italian)},
                             Words{drawings::plain(other.english), drawings::plain(other.italian)}));
  }
}

void Scene::demand_printed(const std::vector<Quantity>& quantities) const {
  const File file(file_);
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities) names.push_back(quantity.name);
  for (std::size_t i = 0; i < printed_.size(); ++i) {
    const Tree &item = root_.find("printed")->items[i], &unit = *item.find("unit");
    const auto found = std::find(names.begin(), names.end(), printed_[i].quantity);
    if (found == names.end())
      file.refuse(*item.find("quantity"),
                  format_words("this mechanism has no quantity \"{}\"; {}",
                               "questo meccanismo non ha la grandezza \"{}\"; {}", printed_[i].quantity,
                               did_you_mean(printed_[i].quantity, names)));
    const Quantity& quantity = quantities[static_cast<std::size_t>(found - names.begin())];
    if (find_unit(unit.text)->kind != find_unit(quantity.unit)->kind)
      file.refuse(unit, format_words("{} is told in {}, not in {}", "{} si dice in {}, non in {}", quantity.name,
                                     quantity.unit, unit.text));
  }
}

std::vector<std::size_t> Scene::chosen_sheets(const std::vector<std::string>& names) const {
  std::vector<std::size_t> chosen;
  const Tree* asked = root_.find("sheets");
  if (!asked) {
    for (std::size_t i = 0; i < names.size(); ++i) chosen.push_back(i);
    return chosen;
  }
  const File file(file_);
  file.demand(*asked, Tree::Kind::list,
              {"sheets: [velocities, instant-centres]", "sheets: [velocities, instant-centres]"});
  if (asked->items.empty()) file.refuse(*asked, {"no sheet is asked for", "non si chiede alcuna tavola"});
  for (const Tree& item : asked->items) {
    const std::string& name =
        file.text(item, {"the name of a sheet is asked here", "qui si chiede il nome di una tavola"});
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      file.refuse(item,
                  format_words("this mechanism has no sheet \"{}\"; {}",
                               "questo meccanismo non ha la tavola \"{}\"; {}", name, did_you_mean(name, names)));
    const auto place = static_cast<std::size_t>(found - names.begin());
    if (std::find(chosen.begin(), chosen.end(), place) != chosen.end())
      file.refuse(item,
                  format_words("the sheet \"{}\" stands here twice", "la tavola \"{}\" sta qui due volte", name));
    chosen.push_back(place);
  }
  return chosen;
}

// Where forces are asked for the links stand in the order in which they are placed, so that the first of those at a
// point, which carries its pin, is there before the others.
Built Scene::built(const Givens& givens) const {
  const File file(file_);
  Built built = Building(file, root_, givens).built();
  if (!built.loads) return built;
  std::vector<int> order{1};
  for (const Step& step : built.steps)
    for (const int link : placed_by(step)) order.push_back(built.letters.links[index(link)]);
  if (order == built.letters.links) return built;
  return Building(file, root_, givens, order).built();
}

}  // namespace epure::scenes
