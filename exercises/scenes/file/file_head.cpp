#include "exercises/scenes/file/file_head.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

#include "drawings/text/text.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/file/formula.h"
#include "exercises/scenes/file/greek.h"
#include "exercises/scenes/shipped.h"

namespace epure::scenes {
namespace {

using Tree = TextTree;
using geometry::BadGiven;
using geometry::find_unit;
using geometry::read_given;

// What of the text is a unit, or would be one: what follows the number. Empty for a pure number, none where there is
// no number, or a formula.
std::optional<std::string> unit_after_number(const std::string& text) {
  std::size_t end = text.find_first_not_of("+-0123456789.,/ ");
  if (end != std::string::npos && (text[end] == 'e' || text[end] == 'E') && end > 0 && end + 1 < text.size() &&
      std::string("+-0123456789").find(text[end + 1]) != std::string::npos)
    end = text.find_first_not_of("+-0123456789.,/ ", end + 1);
  if (end == std::string::npos) return "";
  if (end == 0 || text[end] == '*' || text[end] == '(') return {};
  std::string unit = text.substr(end);
  while (!unit.empty() && unit.back() == ' ') unit.pop_back();
  return unit;
}

// More than any file may have: what has no end is refused for its length.
std::string beginning_of(std::istream& in) {
  std::string bytes(std::size_t{1} << 20, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

GivenSpec given(const File& file, const Tree& key, const Tree& value) {
  const std::string symbol = spelled_out(key.text);
  if (!is_name(symbol))
    file.refuse(key, format_words("\"{}\" is no name of a given: a letter, then letters and digits",
                                  "\"{}\" non è un nome di dato: una lettera, poi lettere e cifre", key.text));
  const Tree* number = &value;
  GivenSpec spec;
  spec.symbol = symbol;
  spec.letters = given_letters(symbol);
  spec.range = Range::any;
  if (value.kind == Tree::Kind::map) {
    file.demand_keys(value, {"value", "meaning"});
    number = value.find("value");
    if (!number) file.refuse(value, {"value: is missing", "manca value:"});
    if (const Tree* meaning = value.find("meaning")) spec.meaning = escaped(file.words(*meaning));
  }
  const std::string& text = file.text(*number, {"a number with its unit is asked here, such as 120 mm",
                                                "qui si chiede un numero con la sua unità, come 120 mm"});
  const auto unit = unit_after_number(text);
  if (!unit)
    file.refuse(*number, format_words("\"{}\" is no number with a unit; formulas of givens stand under where:",
                                      "\"{}\" non è un numero con unità; le formule stanno sotto where:", text));
  if (!unit->empty() && !find_unit(*unit)) file.refuse(*number, no_unit(*unit));
  spec.unit = unit->empty() ? "1" : *unit;
  spec.stated = text.substr(0, text.size() - unit->size());
  while (!spec.stated.empty() && spec.stated.back() == ' ') spec.stated.pop_back();
  if (spec.meaning.empty()) spec.meaning = {spec.symbol, spec.symbol};
  try {
    read_given(spec.stated, spec.unit);
  } catch (const BadGiven& bad) {
    file.refuse(*number, bad.words());
  }
  return spec;
}

// {quantity: omega_3, value: -1.42, unit: rad/s, place: "page 57", reading: 0.02}.
Printed printed_number(const File& file, const Tree& at) {
  const Words what{"a printed number is {quantity: omega_3, value: -1.42, unit: rad/s, place: page 57}",
                   "un numero stampato è {quantity: omega_3, value: -1.42, unit: rad/s, place: pagina 57}"};
  file.map(at, what);
  file.demand_keys(at, {"quantity", "value", "unit", "place", "reading"});
  const auto demand = [&](const char* key) -> const Tree& {
    const Tree* value = at.find(key);
    if (!value) file.refuse(at, format_words("{}: is missing", "manca {}:", key));
    file.text(*value, what);
    return *value;
  };
  const Tree& unit_at = demand("unit");
  const auto unit = find_unit(unit_at.text);
  if (!unit) file.refuse(unit_at, no_unit(unit_at.text));
  const auto number = [&](const Tree& told) {
    try {
      return read_decimal(told.text, "1").value;
    } catch (const BadGiven& bad) {
      file.refuse(told, bad.words());
    }
  };
  const Tree& value = demand("value");
  number(value);
  Printed printed{demand("quantity").text, value.text + (unit->factor == 1 ? "" : " " + unit->symbol),
                  file.words(demand("place")).english};
  if (at.find("reading")) {
    const Rational reading = number(demand("reading"));
    if (reading < 0) file.refuse(*at.find("reading"), {"it is below zero", "è sotto lo zero"});
    printed.reading = CGAL::to_double(unit->counts_turns ? reading : reading * unit->factor);
  }
  return printed;
}

}  // namespace

void File::demand_keys(const Tree& map, const std::vector<std::string>& known) const {
  for (const auto& [key, value] : map.entries)
    if (std::find(known.begin(), known.end(), key.text) == known.end())
      refuse(key, format_words("\"{}\" has no meaning here; {}", "\"{}\" qui non ha senso; {}", key.text,
                               did_you_mean(key.text, known)));
}

Words File::words(const Tree& at) const {
  if (at.kind == Tree::Kind::text) return {line(at), line(at)};
  map(at, {"a text is asked here, or {en: ..., it: ...}", "qui si chiede un testo, o {en: ..., it: ...}"});
  demand_keys(at, {"en", "it"});
  const Tree *english = at.find("en"), *italian = at.find("it");
  if (!english && !italian) refuse(at, {"neither en: nor it:", "né en: né it:"});
  return {line(english ? *english : *italian), line(italian ? *italian : *english)};
}

const std::string& File::line(const Tree& at) const {
  constexpr std::size_t longest = 120;
  const std::string& line = text(at, {"a text is asked here", "qui si chiede un testo"});
  const bool is_line = line.size() <= longest && std::none_of(line.begin(), line.end(), [](char c) {
                         return (static_cast<unsigned char>(c) < 0x20) || c == 0x7f;
                       });
  if (!is_line)
    refuse(at, format_words("this must be a line of at most {} printable letters",
                            "dev'essere una riga di al più {} caratteri stampabili", longest));
  if (!drawings::can_write(line))
    refuse(at, {"epure's fonts have Latin, Greek and Cyrillic letters, and one of these is none of them",
                "i caratteri di epure hanno lettere latine, greche e cirilliche, e una di queste non lo è"});
  return line;
}

bool is_name(const std::string& text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

bool is_id(const std::string& text) {
  return !text.empty() && text.size() <= 60 && std::islower(static_cast<unsigned char>(text[0])) != 0 &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return std::islower(static_cast<unsigned char>(c)) != 0 ||
                  std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-';
         });
}

std::vector<std::string> parted(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> parts;
  for (std::string part; in >> part;) parts.push_back(part);
  return parts;
}

std::string bytes_of(const std::string& file) {
  if (file == standard_input) return beginning_of(std::cin);
  if (const Shipped* shipped = shipped_scene(file)) return std::string(shipped->text);
  const auto closed = [&] {
    return BadScene(format_words("{}: the file cannot be read", "{}: il file non si può leggere", file));
  };
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown))
    throw unknown ? closed() : BadScene(format_words("{}: there is no such file", "{}: non c'è un file così", file));
  if (!std::filesystem::is_regular_file(file, unknown))
    throw BadScene(format_words("{}: this is no file to be read, but a folder or a device",
                                "{}: non è un file da leggere, ma una cartella o un dispositivo", file));
  std::ifstream in(file, std::ios::binary);
  if (!in) throw closed();
  try {
    return {std::istreambuf_iterator<char>(in), {}};
  } catch (const std::ios_base::failure&) {  // a disk's error: not an empty file
    throw closed();
  }
}

Words escaped(const Words& words) { return {drawings::escaped(words.english), drawings::escaped(words.italian)}; }

FileHead read_head(const File& file, const Tree& root) {
  FileHead head;
  const Tree* version = root.find("epure");
  if (!version || version->text != "1")
    file.refuse(version ? *version : root, {"a scene begins with  epure: 1", "una scena comincia con  epure: 1"});
  const Tree* id = root.find("id");
  if (!id) file.refuse(root, {"id: is missing", "manca id:"});
  head.id = file.text(*id, {"an id is asked here", "qui si chiede un id"});
  if (!is_id(head.id))
    file.refuse(*id, format_words("\"{}\" is no id: small letters, digits and hyphens, a letter first",
                                  "\"{}\" non è un id: minuscole, cifre e trattini, prima una lettera", head.id));
  const Tree *title = root.find("title"), *source = root.find("source");
  head.title = title ? file.words(*title) : Words{head.id, head.id};
  const std::string file_alone = std::filesystem::path(file.name()).filename();
  head.source = source ? file.words(*source) : Words{file_alone, file_alone};
  if (const Tree* givens = root.find("givens")) {
    file.map(*givens, {"givens: {r: 120 mm}", "givens: {r: 120 mm}"});
    for (const auto& [key, value] : givens->entries) {
      head.givens.push_back(given(file, key, value));
      if (const auto first = index_of(head.givens, head.givens.back().symbol); first + 1 < head.givens.size())
        file.refuse(key, format_words("\"{}\" and \"{}\" are one name", "\"{}\" e \"{}\" sono un solo nome",
                                      givens->entries[first].first.text, key.text));
    }
  }
  if (const Tree* printed = root.find("printed")) {
    file.demand(*printed, Tree::Kind::list,
                {"printed: a list of what the book prints", "printed: un elenco di quanto il libro stampa"});
    for (const Tree& item : printed->items) head.printed.push_back(printed_number(file, item));
  }
  return head;
}

}  // namespace epure::scenes
