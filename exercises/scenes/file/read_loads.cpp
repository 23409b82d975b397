#include "exercises/scenes/file/sections.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/given_number.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/file/greek.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

// loads:, masses:, gravity:.
class LoadsReader : SectionReader {
 public:
  using SectionReader::SectionReader;

  // loads: [{at: P, on: 3, force: 200 N, direction: -90 deg}, {on: 4, couple: 20 N*m}].
  void loads() {
    const Tree* all = root_.find("loads");
    if (!all) return;
    const Words what{"loads: [{at: P, on: 3, force: 200 N, direction: -90 deg}, {on: 4, couple: 20 N*m}]",
                     "loads: [{at: P, on: 3, force: 200 N, direction: -90 deg}, {on: 4, couple: 20 N*m}]"};
    file_.demand(*all, Tree::Kind::list, what);
    built_.loads.emplace();
    for (const Tree& item : all->items) {
      file_.map(item, what);
      if (item.find("couple"))
        couple(item, what);
      else
        force(item, what);
    }
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

 private:
  void gravity(const Tree& at) {
    Own& g = built_.loads->gravity;
    if (at.kind == Tree::Kind::list) {
      if (at.items.size() != 2)
        refuse(at, {"two components are asked, such as [0, -9.81 m/s^2]",
                    "si chiedono due componenti, come [0, -9.81 m/s^2]"});
      g = {amount(at.items[0], Kind::acceleration).value, amount(at.items[1], Kind::acceleration).value};
      built_.gravity = "$\\it{g}$";
      tell_components("$\\it{g}", at, Kind::acceleration);
    } else {
      g = {0, -amount(at, Kind::acceleration).value};
      built_.gravity = letters_of_given(at, "$\\it{g}$");
      tell({built_.gravity, built_.gravity}, &at, Kind::acceleration);
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
    const MassName& names = built_.mass_names.back();
    tell({names.mass, names.mass}, &size, Kind::mass);
    tell({names.inertia, names.inertia}, inertia, Kind::moment_of_inertia);
  }
  // Of "$\\it{g}": "$\\it{g}_{x}$" and "$\\it{g}_{y}$".
  void tell_components(const std::string& letters, const Tree& both, Kind kind) const {
    for (const std::size_t k : {0, 1}) {
      std::string of = letters;
      const std::string axis = k == 0 ? "x" : "y";
      if (of.ends_with('}') && of.find('_') != std::string::npos)
        of.insert(of.size() - 1, "," + axis);
      else
        of += "_{" + axis + "}";
      tell({of + "$", of + "$"}, &both.items[k], kind);
    }
  }
  std::string letters_of_given(const Tree& at, const std::string& otherwise) const {
    const std::string symbol = spelled_out(at.text);
    return of_.given.contains(symbol) ? italic_letters(symbol) : otherwise;
  }
  void couple(const Tree& item, const Words& what) {
    file_.demand_keys(item, {"on", "couple"});
    const Tree& on = demand(item, "on");
    const int link = link_of_number(on, file_.text(on, what));
    demand_moving(on, link);
    const Tree& couple = demand(item, "couple");
    built_.loads->couples.push_back({link, amount(couple, Kind::moment).value});
    built_.couple_names.push_back(name_of_load(couple, "T", number(link)));
    const std::string& symbol = built_.couple_names.back().symbol;
    tell({symbol, symbol}, &couple, Kind::moment);
  }
  // After the given that it is, where no load before is; or after where it acts.
  LoadName name_of_load(const Tree& size, const std::string& letter, const std::string& where) {
    std::string text = spelled_out(size.text);
    const std::size_t first = text.find_first_not_of("- ");
    text = first == std::string::npos ? "" : text.substr(first);
    if (of_.given.contains(text) && load_names_.insert(text).second) return {text, italic_letters(text), true, {}};
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
    const Tree* direction = item.find("direction");
    if (!direction) {
      if (load.components.x == 0 || load.components.y == 0) return load.components.y == 0 ? "∥ $x$" : "∥ $y$";
      return as_printed("∥ (" + told_value(load.components.x).english + " N; " +
                        told_value(load.components.y).english + " N)");
    }
    const Rational quarters = 4 * load.turned.turns;
    if (quarters.denominator() == 1) return Rational(quarters / 2).denominator() == 1 ? "∥ $x$" : "∥ $y$";
    return "∠ " + words_of_amount(*direction, Kind::angle).english;
  }
  void force(const Tree& item, const Words& what) {
    file_.demand_keys(item, {"at", "on", "force", "direction"});
    const auto [link, at] = loaded_place(item, what);
    const int at_point = point_at(built_, link, at);
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
    LoadName& name = built_.force_names.back();
    name.direction = direction_of_load(item, load);
    if (force.kind == Tree::Kind::list)
      tell_components(name.symbol.substr(0, name.symbol.size() - 1), force, Kind::force);
    else
      tell({name.symbol, name.symbol}, &force, Kind::force);
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
  void demand_moving(const Tree& at, int link) const {
    if (link == 0)
      refuse(at, {"link 1 is the frame: what acts on it reaches no joint",
                  "il membro 1 è il telaio: ciò che agisce su di esso non arriva ad alcun vincolo"});
  }

  std::set<std::string> load_names_;
};

}  // namespace

void read_loads(FileReading& of) {
  LoadsReader reader(of);
  reader.loads();
  reader.masses();
}

}  // namespace epure::scenes
