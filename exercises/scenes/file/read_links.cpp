#include "exercises/scenes/file/sections.h"

#include <algorithm>

#include "exercises/kit/statement/format_words.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

// links:, and points:.
class LinksReader : SectionReader {
 public:
  using SectionReader::SectionReader;

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
      return std::find_if(of_.order.begin(), of_.order.end(),
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
    demand_few(*all);
  }

 private:
  // What a mechanism costs grows with the fourth power of its links, and with all pairs of its letters on a sheet.
  void demand_few(const Tree& at) const {
    constexpr std::size_t most_links = 24, most_points = 100;
    if (const std::size_t links = built_.linkage.links.size(); links > most_links)
      refuse(at, format_words("{} links are too many: {} at most", "{} membri sono troppi: al più {}", links,
                              most_links));
    if (const std::size_t points = built_.letters.points.size(); points > most_points)
      refuse(at, format_words("{} points are too many: {} at most", "{} punti sono troppi: al più {}", points,
                              most_points));
  }
  static int index(std::vector<std::string>& names, const std::string& name) {
    const auto place = std::find(names.begin(), names.end(), name) - names.begin();
    if (place == std::ssize(names)) names.push_back(name);
    return static_cast<int>(place);
  }
  // points: where letters lie on a drawing, and its lines, from which links take their shapes.
  void read_drawing() {
    const Tree* drawing = root_.find("points");
    if (!drawing) return;
    file_.map(*drawing, {"points: {A: [x, y]}", "points: {A: [x, y]}"});
    for (const auto& [key, value] : drawing->entries) {
      demand_letter(key, key.text);
      if (value.kind == Tree::Kind::map)
        of_.drawn_lines[key.text] = line_told(value);
      else
        of_.drawn[key.text] = own(value);
    }
  }
  void link(const Tree& told_at, int number, const Tree& at) {
    of_.link_at.push_back(&told_at);
    built_.letters.links.push_back(number);
    built_.linkage.links.emplace_back();
    if (at.kind == Tree::Kind::text) {
      for (const std::string& name : parted(at.text)) {
        if (const auto line = of_.drawn_lines.find(name); line != of_.drawn_lines.end()) {
          add_line(at, name, line->second.through, line->second.along);
          continue;
        }
        const auto drawn = of_.drawn.find(name);
        if (drawn == of_.drawn.end())
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
    const LinkLine told = line_told(value);
    add_line(key, key.text, told.through, told.along);
  }
  // Without its number.
  LinkLine line_told(const Tree& value) const {
    file_.demand_keys(value, {"through", "along"});
    const Tree* through = value.find("through");
    return {nothing, through ? own(*through) : Own{0, 0}, direction(value)};
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
};

}  // namespace

void read_links(FileReading& of) { LinksReader(of).links(); }

}  // namespace epure::scenes
