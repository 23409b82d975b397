#include "exercises/scenes/file/truss_file.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "exercises/kit/statement/suggest.h"
#include "exercises/kit/trusses/truss_sheets.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/file/formula.h"
#include "exercises/scenes/file/greek.h"
#include "geometry/numbers/climb.h"

namespace epure::scenes {
namespace {

using geometry::Kind;
using Tree = TextTree;

constexpr std::size_t most_joints = 40;

// A capital letter, and up to two digits; small letters are the regions of Bow's notation.
bool is_joint(const std::string& text) {
  constexpr std::size_t longest = 3;
  return !text.empty() && text.size() <= longest && text[0] >= 'A' && text[0] <= 'Z' &&
         text.find_first_not_of("0123456789", 1) == std::string::npos;
}

// A force has a slanting capital, where a point's is upright.
std::string letters_of_force(const std::string& given) {
  const std::string letters = given_letters(given);
  if (std::isupper(static_cast<unsigned char>(letters[1])) == 0) return letters;
  return "$\\it{" + letters.substr(1, 1) + "}" + letters.substr(2);
}

class TrussBuilding {
 public:
  TrussBuilding(const File& file, const Tree& truss, const Givens& givens) : file_(file), truss_(truss) {
    for (const GivenSpec& spec : givens.specs()) known_[spec.symbol] = amount_of(givens, spec);
  }

  trusses::LoadedTruss built() {
    file_.map(truss_, {"truss: {joints: ..., bars: ..., supports: ..., loads: ...}",
                       "truss: {joints: ..., bars: ..., supports: ..., loads: ...}"});
    file_.demand_keys(truss_, {"joints", "bars", "supports", "loads"});
    joints();
    bars();
    supports();
    loads();
    try {
      trusses::LoadedTruss found(built_, roller_, loads_);
      demand_held(found);
      return found;
    } catch (const geometry::Impossible& why) {
      refuse(truss_, why.words());
    }
  }

 private:
  [[noreturn]] void refuse(const Tree& at, const Words& sentence) const { file_.refuse(at, sentence); }
  const Tree& section(const char* key) const {
    const Tree* found = truss_.find(key);
    if (!found) refuse(truss_, format_words("{}: is missing", "manca {}:", key));
    return *found;
  }
  Amount amount(const Tree& at, Kind kind, const std::string& unit_of_bare) const {
    try {
      return read_amount(file_.text(at, format_words("{} is asked here", "qui si chiede {}", name_of(kind))), kind,
                         unit_of_bare, known_);
    } catch (const BadFormula& bad) {
      refuse(at, bad.words());
    }
  }
  geometry::Vector<Rational> pair(const Tree& at, Kind kind, const Words& what) const {
    if (at.kind != Tree::Kind::list || at.items.size() != 2) refuse(at, what);
    return {amount(at.items[0], kind, unit_of(kind)).value, amount(at.items[1], kind, unit_of(kind)).value};
  }
  std::size_t joint(const Tree& at, const std::string& name) const {
    const auto& names = built_.names;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      refuse(at, format_words("there is no joint {}; {}", "non c'è un nodo {}; {}", name, did_you_mean(name, names)));
    return static_cast<std::size_t>(found - names.begin());
  }

  void joints() {
    const Words what{"joints: {A: [0, 0], B: [4 m, 0]}", "joints: {A: [0, 0], B: [4 m, 0]}"};
    for (const auto& [key, value] : file_.map(section("joints"), what).entries) {
      if (!is_joint(key.text))
        refuse(key, format_words("\"{}\" is no name of a joint: a capital letter, and up to two digits",
                                 "\"{}\" non è un nome di nodo: una maiuscola, e al più due cifre", key.text));
      const auto [x, y] =
          pair(value, Kind::length,
               {"two coordinates are asked, such as [0, 2.5 m]", "si chiedono due coordinate, come [0, 2.5 m]"});
      built_.names.push_back(key.text);
      built_.joints.push_back({x, y});
    }
    if (built_.joints.size() > most_joints)
      refuse(section("joints"),
             format_words("the truss has {} joints; {} at most are drawn",
                          "la travatura ha {} nodi; se ne disegnano al più {}", built_.joints.size(), most_joints));
  }

  void bars() {
    const Words what{"bars: [A B, B C], each between two joints", "bars: [A B, B C], ognuna tra due nodi"};
    const Tree& all = file_.demand(section("bars"), Tree::Kind::list, what);
    if (all.items.empty()) refuse(all, what);
    for (const Tree& item : all.items) {
      const std::vector<std::string> ends = parted(file_.text(item, what));
      if (ends.size() != 2 || ends[0] == ends[1]) refuse(item, what);
      built_.bars.push_back({joint(item, ends[0]), joint(item, ends[1])});
    }
  }

  // {A: hinge, B: roller}, or B: {roller: 30 deg}.
  void supports() {
    const Words what{
        "a truss stands on a hinge and a roller: supports: {A: hinge, B: roller}; a roller on inclined ground is "
        "{roller: 30 deg}",
        "una travatura sta su una cerniera e un carrello: supports: {A: hinge, B: roller}; un carrello su un piano "
        "inclinato è {roller: 30 deg}"};
    const Tree& all = file_.map(section("supports"), what);
    std::optional<std::size_t> hinge, roller;
    for (const auto& [key, value] : all.entries) {
      const std::size_t at = joint(key, key.text);
      const Tree* ground = value.find("roller");
      if (value.kind == Tree::Kind::text && value.text == "hinge" && !hinge) {
        hinge = at;
      } else if ((ground || (value.kind == Tree::Kind::text && value.text == "roller")) && !roller) {
        if (ground) file_.demand_keys(value, {"roller"});
        roller = at;
        roller_ = (ground ? amount(*ground, Kind::angle, "").angle : Angle{}) + Angle{Rational(1, 4)};
      } else {
        refuse(value, what);
      }
    }
    if (!hinge || !roller) refuse(all, what);
    built_.outside = {*hinge, *roller};
  }

  void loads() {
    const Tree& all = file_.map(section("loads"), {"loads: {C: [0, -10 kN]}", "loads: {C: [0, -10 kN]}"});
    for (const auto& [key, value] : all.entries) {
      trusses::Load load = value.kind == Tree::Kind::map ? along_angle(value) : in_components(value);
      load.joint = joint(key, key.text);
      if (load.size == 0 && load.components.x == 0 && load.components.y == 0) continue;
      load.is_told = load.label.empty();
      if (load.is_told) load.label = "$\\vec{\\it{F}}_{" + key.text + "}$";
      loads_.push_back(std::move(load));
    }
    if (loads_.empty()) refuse(all, {"nothing loads the truss", "nulla carica la travatura"});
  }
  trusses::Load in_components(const Tree& at) const {
    const Words what{"a load is [0, -10 kN], or {force: 10 kN, angle: -60 deg}",
                     "un carico è [0, -10 kN], o {force: 10 kN, angle: -60 deg}"};
    trusses::Load load{.joint = 0, .components = pair(at, Kind::force, what), .size = 0, .along = {}, .label = {}};
    if (load.components.x == 0 || load.components.y == 0)
      if (const auto given = given_in(at.items[load.components.x == 0 ? 1 : 0]))
        load.label = letters_of_force(*given);
    return load;
  }
  trusses::Load along_angle(const Tree& at) const {
    file_.demand_keys(at, {"force", "angle"});
    const Tree *force = at.find("force"), *angle = at.find("angle");
    if (!force || !angle)
      refuse(at, format_words("{}: is missing", "manca {}:", std::string(force ? "angle" : "force")));
    trusses::Load load{.joint = 0,
                       .components = {0, 0},
                       .size = amount(*force, Kind::force, unit_of(Kind::force)).value,
                       .along = amount(*angle, Kind::angle, "").angle,
                       .label = {}};
    if (const auto given = given_in(*force); given && given_in(*angle)) load.label = letters_of_force(*given);
    return load;
  }
  // The given that a text is, but for a sign before it.
  std::optional<std::string> given_in(const Tree& at) const {
    const std::vector<std::string> parts = parted(at.text);
    if (parts.size() != 1) return {};
    const std::string name = spelled_out(parts[0].substr(parts[0][0] == '-' ? 1 : 0));
    if (!known_.contains(name)) return {};
    return name;
  }

  void demand_held(const trusses::LoadedTruss& of) const {
    const geometry::Vector<Rational> AB = built_.joints[of.roller_at()] - built_.joints[of.hinge()];
    const auto arm = [&]<class T>() {
      return geometry::cross(geometry::Vector<T>{geometry::from_rational<T>(AB.x), geometry::from_rational<T>(AB.y)},
                             geometry::Vector<T>{geometry::cosine<T>(of.roller), geometry::sine<T>(of.roller)});
    };
    if (geometry::decide(arm).sign == geometry::Sign::zero)
      refuse(section("supports"), {"the truss is unstable: the roller's line of action passes through the hinge",
                                   "la travatura è labile: la retta d'azione del carrello passa per la cerniera"});
  }

  const File& file_;
  const Tree& truss_;
  Amounts known_;
  geometry::Truss built_;
  Angle roller_;
  std::vector<trusses::Load> loads_;
};

struct TrussFile {
  std::string name;
  Tree root;

  trusses::LoadedTruss built(const Givens& givens) const {
    return TrussBuilding(File(name), *root.find("truss"), givens).built();
  }
};

}  // namespace

std::unique_ptr<Exercise> truss_of_text(const std::string& name, std::string_view bytes) {
  const auto of = std::make_shared<const TrussFile>(TrussFile{name, read_text_tree(name, bytes)});
  if (!of->root.find("truss")) return {};
  const File file(of->name);
  file.demand_keys(of->root, {"epure", "id", "title", "source", "givens", "truss"});
  FileHead head = read_head(file, of->root);
  for (GivenSpec& given : head.givens) given.letters = letters_of_force(given.symbol);  // no point is among them
  const std::size_t bars = of->built(Givens(head.givens)).bars();
  Description about{.id = head.id,
                    .title = escaped(head.title),
                    .document = "scene",
                    .item = head.id,
                    .source = escaped(head.source),
                    .question = {},  // that of all trusses
                    .givens = head.givens};
  return trusses::exercise_of_truss(
      std::move(about), bars, [of](const Givens& givens) { return of->built(givens); },
      [](const Givens&) { return std::set<std::string>{}; });
}

}  // namespace epure::scenes
