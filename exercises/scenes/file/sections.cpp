#include "exercises/scenes/file/sections.h"

#include <algorithm>

#include "exercises/kit/panels/results.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/given_number.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/file/greek.h"

namespace epure::scenes {
namespace {

// Of a point or a line. P12, P13 ... are the instant centres.
bool is_letter(const std::string& text) {
  constexpr std::size_t longest = 8;
  const bool is_centre =
      text.size() > 2 && text.starts_with("P1") && text.find_first_not_of("0123456789", 2) == std::string::npos;
  return is_name(text) && text.size() <= longest && text.find('_') == std::string::npos && !is_centre;
}

}  // namespace

FileReading::FileReading(const File& in, const TextTree& all, const Givens& givens, std::vector<int> links)
    : file(in), root(all), order(std::move(links)) {
  for (const GivenSpec& spec : givens.specs()) {
    known[spec.symbol] = amount_of(givens, spec);
    given.insert(spec.symbol);
  }
}

std::string FileReading::unit(geometry::Kind kind) const {
  return kind == geometry::Kind::length ? length_unit : kind == geometry::Kind::angle ? angle_unit : unit_of(kind);
}

Amount SectionReader::amount(const Tree& at, geometry::Kind kind) const {
  const std::string& text = file_.text(at, format_words("{} is asked here", "qui si chiede {}", name_of(kind)));
  try {
    return read_amount(text, kind, of_.unit(kind), of_.known);
  } catch (const BadFormula& bad) {
    refuse(at, bad.words());
  }
}

bool SectionReader::reads_as(const Tree& at, geometry::Kind kind) const {
  if (at.kind != TextTree::Kind::text) return false;
  try {
    read_amount(at.text, kind, of_.unit(kind), of_.known);
    return true;
  } catch (const BadFormula&) {
    return false;
  }
}

geometry::Own SectionReader::own(const Tree& at) const {
  if (at.kind != TextTree::Kind::list || at.items.size() != 2)
    refuse(at, {"two coordinates are asked, such as [0, 120 mm]", "si chiedono due coordinate, come [0, 120 mm]"});
  return {length(at.items[0]), length(at.items[1])};
}

int SectionReader::point(const Tree& at, const std::string& name) const {
  const auto& names = built_.letters.points;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    refuse(at, format_words("no link has a point {}; {}", "nessun membro ha un punto {}; {}", name,
                            did_you_mean(name, names)));
  return static_cast<int>(found - names.begin());
}

int SectionReader::line(const Tree& at, const std::string& name) const {
  const auto& names = built_.letters.lines;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    refuse(at, format_words("no link has a line {}{}", "nessun membro ha una retta {}{}", name,
                            names.empty() ? Words{} : Words{"; ", "; "} + did_you_mean(name, names)));
  return static_cast<int>(found - names.begin());
}

bool SectionReader::is_line(const std::string& name) const {
  const auto& names = built_.letters.lines;
  return std::find(names.begin(), names.end(), name) != names.end();
}

void SectionReader::demand_letter(const Tree& at, const std::string& name) const {
  if (!is_letter(name))
    refuse(at, format_words("\"{}\" is no name of a point or line: a letter, then letters and digits, eight at "
                            "most (and P12, P13 ... are the instant centres)",
                            "\"{}\" non è un nome di punto o retta: una lettera, poi lettere e cifre, otto al più "
                            "(e P12, P13 ... sono i centri di istantanea rotazione)",
                            name));
}

int SectionReader::place_of_link(const std::string& number) const {
  const auto& links = built_.letters.links;
  const auto found =
      std::find_if(links.begin(), links.end(), [&](int link) { return std::to_string(link) == number; });
  return found == links.end() ? geometry::nothing : static_cast<int>(found - links.begin());
}
int SectionReader::link_of_number(const Tree& at, const std::string& number) const {
  const int link = place_of_link(number);
  if (link == geometry::nothing) refuse(at, format_words("there is no link {}", "non c'è un membro {}", number));
  return link;
}
int SectionReader::moving_link_of_number(const Tree& at, const std::string& number) const {
  const int link = place_of_link(number);
  if (link == geometry::nothing || link == 0)
    refuse(at, format_words("there is no moving link {}", "non c'è un membro mobile {}", number));
  return link;
}

const TextTree& SectionReader::demand(const Tree& map, const std::string& key) const {
  const Tree* value = map.find(key);
  if (!value) refuse(map, format_words("{}: is missing", "manca {}:", key));
  return *value;
}

geometry::Angle SectionReader::turning(const Tree& drive, const std::string& key, geometry::Kind kind) const {
  const Tree* value = drive.find(key);
  return value ? amount(*value, kind).angle : geometry::Angle{};
}

Words SectionReader::words_of_amount(const Tree& at, geometry::Kind kind) const {
  const std::string symbol = spelled_out(at.text);
  if (of_.given.contains(symbol)) return {given_letters(symbol), given_letters(symbol)};
  const Amount it = amount(at, kind);
  const Words number = kind == geometry::Kind::angle    ? told_degrees(it.angle) + "°"
                       : kind == geometry::Kind::length ? told_value(1000 * it.value) + " mm"
                                                        : told_value(it.value);
  return {as_printed(number.english), as_printed(number.italian)};
}

Words SectionReader::equal_to_amount(const Tree& at, geometry::Kind kind) const {
  const auto as_told = [](const geometry::Rational& number, const std::string& unit) {
    const auto in = [&](Language language) { return equal_to(number, language) + unit_after_number(unit, language); };
    return Words{in(Language::english), in(Language::italian)};
  };
  try {
    const geometry::InUnit typed = geometry::read_as_typed(at.text, of_.unit(kind));
    return as_told(typed.number, typed.unit.symbol);
  } catch (const geometry::BadGiven&) {
    if (geometry::turns(kind) && kind != geometry::Kind::angle) return decimal("=\u00a0" + as_printed(at.text));
    return kind == geometry::Kind::angle ? "=\u00a0" + words_of_amount(at, kind)
                                         : as_told(amount(at, kind).value, unit_of(kind));
  }
}

void SectionReader::tell(const Words& what, const Tree* at, geometry::Kind kind) const {
  if (!at) return;
  const std::string text = spelled_out(at->text);
  if (of_.given.contains(text.substr(std::min(text.find_first_not_of("- "), text.size())))) return;
  tell_once(what + "\u00a0" + equal_to_amount(*at, kind));
}

void SectionReader::tell_once(const Words& told) const {
  std::vector<Words>& all = built_.in_place;
  if (std::find(all.begin(), all.end(), told) == all.end()) all.push_back(told);
}

const TextTree& SectionReader::section(const char* name) const {
  const Tree* found = root_.find(name);
  return found ? *found : root_;
}
}  // namespace epure::scenes
