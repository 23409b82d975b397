#include "exercises/scenes/file/sections.h"

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/file/greek.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

std::vector<std::string> units_of(Kind kind) {
  std::vector<std::string> symbols;
  for (const Unit& unit : known_units())
    if (unit.kind == kind) symbols.push_back(unit.symbol);
  return symbols;
}

// units:, and where:.
class NumbersReader : SectionReader {
 public:
  using SectionReader::SectionReader;

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
      (wanted == Kind::length ? of_.length_unit : of_.angle_unit) = unit;
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
      if (of_.known.contains(name))
        refuse(key, format_words("\"{}\" is a given already", "\"{}\" è già un dato", key.text));
      try {
        of_.known[name] =
            read_any_amount(file_.text(value, {"a formula is asked", "si chiede una formula"}), of_.known);
      } catch (const BadFormula& bad) {
        refuse(value, bad.words());
      }
    }
  }
};

}  // namespace

void read_numbers(FileReading& of) {
  NumbersReader reader(of);
  reader.units();
  reader.where();
}

}  // namespace epure::scenes
