#include <algorithm>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/file/sections.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

// friction: {C: 0.15, b: 8 deg}, of what slides.
class FrictionReader : SectionReader {
 public:
  using SectionReader::SectionReader;

  void friction() {
    const Tree* all = root_.find("friction");
    if (!all) return;
    file_.map(
        *all,
        {"friction: {C: 0.15} or {C: 8 deg} of what slides, {A: 5 mm}, its friction circle, of a hinge",
         "friction: {C: 0.15} o {C: 8 deg} di ciò che scorre, {A: 5 mm}, il cerchio d'attrito, di una cerniera"});
    if (!built_.loads)
      refuse(*all, {"nothing presses here: friction needs  loads:  or  masses:",
                    "qui nulla preme: l'attrito vuole  loads:  o  masses:"});
    for (const auto& [key, value] : all->entries) contact(key, value);
    constexpr std::size_t most = 6, most_with_teeth = 8;
    if (built_.loads->frictions.size() > most)
      refuse(*all,
             format_words("friction in more than {} places is too much: there are {}",
                          "l'attrito in più di {} luoghi è troppo: sono {}", most, built_.loads->frictions.size()));
    if (built_.loads->frictions.size() + built_.linkage.gears.size() > most_with_teeth)
      refuse(*all,
             format_words("friction beside so many gears is too much: there may be {} of both together",
                          "l'attrito accanto a tante ruote è troppo: possono essere {} in tutto", most_with_teeth));
  }

 private:
  void contact(const Tree& key, const Tree& value) {
    tell(format_words("friction of ${}$", "attrito di ${}$", point_letters(key.text)), &value,
         reads_as(value, Kind::pure_number) ? Kind::pure_number
         : reads_as(value, Kind::length)    ? Kind::length
                                            : Kind::angle);
    const bool is_line = SectionReader::is_line(key.text);
    if (!is_line && !reads_as(value, Kind::pure_number) && reads_as(value, Kind::length)) return hinge(key, value);
    const int what = is_line ? line(key, key.text) : point(key, key.text);
    const auto& blocks = built_.linkage.blocks;
    const auto& pins = built_.linkage.pins;
    bool slides = false;
    for (std::size_t k = 0; is_line && k < blocks.size(); ++k)
      if (blocks[k].moving == what) slides = add(true, k, value);
    for (std::size_t k = 0; !is_line && k < pins.size(); ++k)
      if (pins[k].point == what) slides = add(false, k, value);
    if (!slides)
      refuse(key, format_words(
                      "{} does not slide: friction is told of a point or line that does, C of  slides: {{C: g}}",
                      "{} non scorre: l'attrito si dice di un punto o una retta che scorre, C di  slides: {{C: g}}",
                      key.text));
  }
  bool add(bool is_of_block, std::size_t which, const Tree& value) {
    LineFriction friction{is_of_block, static_cast<int>(which), Rational(0)};
    if (reads_as(value, Kind::angle) && !reads_as(value, Kind::pure_number)) {
      const Angle angle = amount(value, Kind::angle).angle;
      if (sign_of(angle) < 0 || sign_of(angle - Angle{Rational(1, 4)}) >= 0)
        refuse(value, format_words("\"{}\" is no angle of friction: these are from 0 to below 90 degrees",
                                   "\"{}\" non è un angolo d'attrito: va da 0 a meno di 90 gradi", value.text));
      friction.amount = angle;
    } else {
      const Rational coefficient = amount(value, Kind::pure_number).value;
      if (coefficient < 0)
        refuse(value, format_words("\"{}\" is below zero, and no coefficient of friction is",
                                   "\"{}\" è sotto lo zero, e nessun coefficiente d'attrito lo è", value.text));
      friction.amount = coefficient;
    }
    built_.loads->frictions.push_back(friction);
    built_.friction_names.push_back({words_of_amount(
        value, std::holds_alternative<Rational>(friction.amount) ? Kind::pure_number : Kind::angle)});
    return true;
  }
  void hinge(const Tree& key, const Tree& value) {
    const int A = point(key, key.text);
    if (built_.linkage.links_at(A).size() < 2)
      refuse(key,
             format_words("{} is no hinge: of what slides there is a coefficient of friction or its angle",
                          "{} non è una cerniera: di ciò che scorre si dà il coefficiente d'attrito o il suo angolo",
                          key.text));
    if (!built_.linkage.gears.empty())
      refuse(key,
             {"friction circles in hinges are not found beside gears yet: leave these out, or the gears",
              "i cerchi d'attrito nelle cerniere accanto a ruote dentate non si trovano ancora: togliere gli uni "
              "o le altre"});
    const Rational radius = length(value);
    if (radius < 0)
      refuse(value, format_words("\"{}\" is below zero, and no radius of a friction circle is",
                                 "\"{}\" è sotto lo zero, e nessun raggio di cerchio d'attrito lo è", value.text));
    built_.loads->hinge_frictions.push_back({A, radius});
    built_.hinge_friction_names.push_back({words_of_amount(value, Kind::length)});
  }
};

}  // namespace

void read_friction(FileReading& of) { FrictionReader(of).friction(); }

}  // namespace epure::scenes
