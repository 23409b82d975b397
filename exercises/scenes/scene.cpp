#include "exercises/scenes/scene.h"

#include <algorithm>
#include <map>

#include "drawings/text/text.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/extremes.h"
#include "exercises/scenes/file/demand_few.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/file/greek.h"
#include "exercises/scenes/file/refusals.h"
#include "exercises/scenes/file/sections.h"
#include "exercises/scenes/range_of_drive.h"
#include "geometry/linkages/every_place.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;
using Tree = TextTree;

// Capitals upright are points, and two of them a length: these are italic.
bool is_of_mass(Kind kind) {
  return kind == Kind::force || kind == Kind::moment || kind == Kind::mass || kind == Kind::moment_of_inertia;
}

Built built_of(FileReading reading) {
  read_numbers(reading);
  read_links(reading);
  demand_names_of_points(reading);
  read_joints(reading);
  read_drives(reading);
  read_questions(reading);
  read_loads(reading);
  read_friction(reading);
  place_links(reading);
  return std::move(reading.built);
}

// charts: [omega_4, [v_B, v_C]].
std::vector<std::vector<std::string>> read_charts(const File& file, const Tree& all) {
  const Words what{
      "charts: [omega_4, [v_B, v_C]], quantities over all places of the drive, a chart each or together",
      "charts: [omega_4, [v_B, v_C]], grandezze in tutte le posizioni del movente, un grafico ciascuna o insieme"};
  file.demand(all, Tree::Kind::list, what);
  std::size_t count = 0;
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
    count += names.size();
    charts.push_back(std::move(names));
  }
  demand_few(file, all, count);
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

// Of what no extremes are told.
[[noreturn]] void refuse_extreme(const File& file, const Tree& item, const std::string& name, const Built& built,
                                 const std::vector<std::string>& known) {
  const auto* turned = std::get_if<TurnedLink>(&built.linkage.drives.front());
  std::vector<std::string> sets;
  for (const Quantity& coordinate : driven_coordinates(built)) sets.push_back(coordinate.name);
  const Words range = format_words("how far a drive goes ({})", "fin dove va un movente ({})", enumerated(sets));
  if (built.linkage.drives.size() > 1 || !turned)
    file.refuse(item,
                format_words("of a mechanism that no single turned link drives extremes are told of {}: not of "
                             "\"{}\"; {}",
                             "di un meccanismo che non è mosso da un solo membro girato gli estremi si dicono di "
                             "{}: non di \"{}\"; {}",
                             range, name, did_you_mean(name, known)));
  file.refuse(
      item, format_words("extremes are told of coordinates (C_x), directions of links (theta_4), and how fast these "
                         "change (v_C_x, omega_4), of what link {} moves, and of {}: not of \"{}\"; {}",
                         "gli estremi si dicono di coordinate (C_x), direzioni di membri (theta_4) e di quanto "
                         "rapide variano (v_C_x, omega_4), di ciò che il membro {} muove, e di {}: non di \"{}\"; {}",
                         built.letters.links[index(turned->link)], range, name, did_you_mean(name, known)));
}

// extremes: [theta_4, v_C_x].
std::vector<std::string> read_extremes(const File& file, const Tree& all, const Built& built) {
  const Words what{
      "extremes: [theta_4, v_C_x], quantities whose greatest and least over a turn of the drive are asked for",
      "extremes: [theta_4, v_C_x], grandezze di cui si chiedono massimo e minimo in un giro del movente"};
  file.demand(all, Tree::Kind::list, what);
  demand_few(file, all, all.items.size());
  const std::vector<std::string> known = with_extremes(built);
  std::vector<std::string> names;
  for (const Tree& item : all.items) {
    const std::string name = spelled_out(file.text(item, what));
    if (std::find(known.begin(), known.end(), name) == known.end()) refuse_extreme(file, item, name, built, known);
    if (std::find(names.begin(), names.end(), name) != names.end())
      file.refuse(item, format_words("{} stands here twice", "{} sta qui due volte", name));
    names.push_back(name);
  }
  return names;
}

// All of them together: each is found over all places of the drive, and a place costs the more, the more links there
// are.
void demand_few_curves(const File& file, const TextTree& root, const Built& built, std::size_t charts) {
  constexpr std::size_t most_of_one_link = 96;
  const std::size_t links = built.linkage.links.size(), most = most_of_one_link / links;
  const std::size_t count = built.paths.size() + 2 * built.polodes.size() + charts;
  std::size_t so_far = 0;
  for (const auto& [key, curves] :
       {std::pair{"paths", built.paths.size()}, {"polodes", 2 * built.polodes.size()}, {"charts", charts}}) {
    so_far += curves;
    if (so_far <= most) continue;
    const TextTree* list = root.find(key);
    file.refuse(list ? *list : *root.find("extremes"),
                format_words("{} curves over all places of the drive are asked for, two of them by each link with "
                             "polodes; a mechanism of {} links may have {}",
                             "si chiedono {} curve su tutte le posizioni del movente, due per ogni membro con le "
                             "polari; un meccanismo di {} membri può averne {}",
                             count, links, most));
  }
}

}  // namespace

Scene::Scene(std::string file_name, std::string_view bytes)
    : file_(std::move(file_name)), root_(read_text_tree(file_, bytes)) {
  const File file(file_);
  file.map(root_, {"a scene is a list of keys and values, such as  id: four-bar",
                   "una scena è un elenco di chiavi e valori, come  id: four-bar"});
  file.demand_keys(root_,
                   {"epure",    "id",    "title",    "source", "givens",   "where",   "units",  "points",  "links",
                    "slides",   "gears", "rolls",    "drive",  "assembly", "offsets", "paths",  "polodes", "charts",
                    "extremes", "loads", "friction", "masses", "gravity",  "sheets",  "printed"});
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
  if (const TextTree* asked = root_.find("extremes")) {
    if (stated.linkage.drives.size() == 1) demand_one_way(file, *asked, stated);
    extremes_ = read_extremes(file, *asked, stated);
    for (const std::string& name : extremes_) {
      if (drive_of_coordinate(stated, name)) continue;  // it has a sheet of its own
      const auto shows = [&](const std::vector<std::string>& chart) {
        return std::find(chart.begin(), chart.end(), name) != chart.end();
      };
      if (std::none_of(charts_.begin(), charts_.end(), shows)) charts_.push_back({name});
    }
  }
  demand_few_curves(file, root_, stated, charts_.size());
}

void Scene::demand_charts(const std::vector<Quantity>& quantities) const {
  const File file(file_);
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities) names.push_back(quantity.name);
  const TextTree* asked = root_.find("charts");  // the others are of extremes, which are known
  for (std::size_t i = 0; asked && i < asked->items.size(); ++i) {
    std::string unit;
    for (const std::string& name : charts_[i]) {
      const TextTree& item = asked->items[i];
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
    const Unit asked = *find_unit(unit.text), own = *find_unit(quantity.unit);
    if (asked.kind == own.kind && asked.counts_turns && !own.counts_turns)
      file.refuse(unit, format_words("{} counts turns, and epure tells {} in {}: π lies between; write it in {}",
                                     "{} conta giri, ed epure dice {} in {}: c'è di mezzo π; scriverlo in {}",
                                     asked.symbol, quantity.name, own.symbol, own.symbol));
    if (asked.kind != own.kind || (own.counts_turns && asked.factor != own.factor))
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
  Built built = built_of(FileReading(file, root_, givens));
  if (!built.loads) return built;
  std::vector<int> order{1};
  for (const Step& step : built.steps)
    for (const int link : placed_by(step)) order.push_back(built.letters.links[index(link)]);
  if (order == built.letters.links) return built;
  return built_of(FileReading(file, root_, givens, order));
}

}  // namespace epure::scenes
