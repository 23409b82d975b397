#include "exercises/gear-pair/fault_words.h"

#include <fmt/format.h>

#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

using geometry::Fault;
using Kind = Fault::Kind;

std::string of_name(int wheel, const DrawnPair& pair, Language language) {
  const std::string name = name_of(wheel, pair, language);
  if (language == Language::english) return "of " + name;
  return "del" + name;  // la ruota -> della ruota
}

Words sentence_of(const Fault& fault, const DrawnPair& pair, const std::string& value, const std::string& limit,
                  Language language) {
  const std::string of = of_name(fault.wheel, pair, language), other = of_name(3 - fault.wheel, pair, language);
  const std::string mm = "\u00a0mm";
  switch (fault.kind) {
    case Kind::tip_inside_base:
      return {fmt::format("The tip circle {} ({}) lies inside its base circle ({}): it has no involute flank there.",
                          of, value + mm, limit + mm),
              fmt::format("La circonferenza di testa {} ({}) è interna a quella di base ({}): lì non c'è fianco a "
                          "evolvente.",
                          of, value + mm, limit + mm)};
    case Kind::pointed:
      return {fmt::format("The teeth {} are pointed: their flanks meet before the tip circle, where the thickness "
                          "would be {}.",
                          of, value + mm),
              fmt::format("I denti {} sono a punta: i fianchi si incontrano prima della circonferenza di testa, dove "
                          "lo spessore sarebbe {}.",
                          of, value + mm)};
    case Kind::undercut:
      return {fmt::format("The cutter undercuts the teeth {}: z = {} is less than {}.", of, value, limit),
              fmt::format("L'utensile sottotaglia i denti {}: z = {} è minore di {}.", of, value, limit)};
    case Kind::undercut_by_edge:
      return {
          fmt::format("The cutter's straight edge reaches deeper than its addendum and undercuts the teeth {}: z = "
                      "{} is less than {}.",
                      of, value, limit),
          fmt::format("Il tagliente rettilineo dell'utensile scende oltre l'addendum e sottotaglia i denti {}: z = "
                      "{} è minore di {}.",
                      of, value, limit)};
    case Kind::contact_on_fillet:
      return {fmt::format("The tips {} need the flank {} down to the radius {}, but it begins at {}: they run on the "
                          "fillet.",
                          other, of, value + mm, limit + mm),
              fmt::format("Le teste {} richiedono il fianco {} fino al raggio {}, ma esso inizia a {}: toccano il "
                          "raccordo.",
                          other, of, value + mm, limit + mm)};
    case Kind::corner_in_root:
      return {
          fmt::format("Too little clearance: beside the line of action the corners of the tips {} dig into the root "
                      "curve {}, by {}.",
                      other, of, value + mm),
          fmt::format("Gioco in testa insufficiente: fuori dalla linea d'azione gli spigoli delle teste {} "
                      "penetrano nel raccordo {}, di {}.",
                      other, of, value + mm)};
    case Kind::negative_clearance:
      return {
          fmt::format("No clearance: the tips {} dig into the roots {} by {}.", of, other, value + mm),
          fmt::format("Manca il gioco in testa: le teste {} penetrano nel fondo {} di {}.", of, other, value + mm)};
    case Kind::interference_approach:
      return {fmt::format("Interference: contact would begin before $T_{{1}}$, for $P_{{0}}A$ = {} is longer than "
                          "$P_{{0}}T_{{1}}$ = {}.",
                          value + mm, limit + mm),
              fmt::format("Interferenza: il contatto inizierebbe prima di $T_{{1}}$, perché $P_{{0}}A$ = {} supera "
                          "$P_{{0}}T_{{1}}$ = {}.",
                          value + mm, limit + mm)};
    case Kind::interference_recess:
      return {fmt::format("Interference: contact would end beyond $T_{{2}}$, for $P_{{0}}E$ = {} is longer than "
                          "$P_{{0}}T_{{2}}$ = {}.",
                          value + mm, limit + mm),
              fmt::format("Interferenza: il contatto finirebbe oltre $T_{{2}}$, perché $P_{{0}}E$ = {} supera "
                          "$P_{{0}}T_{{2}}$ = {}.",
                          value + mm, limit + mm)};
    case Kind::contact_ratio_below_one:
      return {fmt::format("The contact ratio {} is below 1: one pair of teeth parts before the next touches.", value),
              fmt::format("Il fattore di ricoprimento {} è minore di 1: una coppia di denti si distacca prima che la "
                          "successiva si tocchi.",
                          value)};
    case Kind::pointed_cutter:
      return {fmt::format("No such cutter: its tip roundings overlap by {}.", value + mm),
              fmt::format("L'utensile non esiste: i raccordi di testa si sovrappongono di {}.", value + mm)};
    case Kind::tips_collide:
      return {
          fmt::format("The ring is too small: beside the mesh the tips run into each other by {}.", value + mm),
          fmt::format("La corona è troppo piccola: fuori dall'ingranamento le teste si urtano, di {}.", value + mm)};
  }
  return {};
}

Words doubt(const Fault& fault, Language language) {
  const std::string what = mark_of(fault.kind, language);
  return {fmt::format("Undecided: {} (no number could tell: {}).", what, fault.reason.english),
          fmt::format("Non deciso: {} (nessun numero ha potuto dirlo: {}).", what, fault.reason.italian)};
}

bool counts(Kind kind) {
  return kind == Kind::undercut || kind == Kind::undercut_by_edge || kind == Kind::contact_ratio_below_one;
}

// What is said to be missing or to overlap is said by its size.
bool says_a_size(Kind kind) {
  return kind == Kind::corner_in_root || kind == Kind::negative_clearance || kind == Kind::pointed_cutter ||
         kind == Kind::tips_collide;
}

}  // namespace

std::string name_of(int wheel, const DrawnPair& pair, Language language) {
  const bool english = language == Language::english;
  if (wheel == 2 && pair.is_rack()) return english ? "the rack" : "la dentiera";
  if (wheel == 2 && pair.is_ring()) return english ? "the ring" : "la corona";
  return fmt::format("{} {}", english ? "wheel" : "la ruota", wheel);
}

std::string mark_of(Kind kind, Language language) {
  const auto words = [&]() -> Words {
    switch (kind) {
      case Kind::tip_inside_base:
        return {"no flank", "nessun fianco"};
      case Kind::pointed:
        return {"pointed", "a punta"};
      case Kind::undercut:
      case Kind::undercut_by_edge:
        return {"undercut", "sottotaglio"};
      case Kind::contact_on_fillet:
        return {"contact on the fillet", "contatto sul raccordo"};
      case Kind::corner_in_root:
        return {"tip corner in the root", "spigolo nel raccordo"};
      case Kind::negative_clearance:
        return {"no clearance", "senza gioco"};
      case Kind::interference_approach:
      case Kind::interference_recess:
        return {"interference", "interferenza"};
      case Kind::contact_ratio_below_one:
        return {"no continuous contact", "contatto non continuo"};
      case Kind::pointed_cutter:
        return {"no such cutter", "utensile impossibile"};
      case Kind::tips_collide:
        return {"tips collide", "urto delle teste"};
    }
    return {};
  };
  return words().in(language);
}

std::string sentence(const Fault& fault, const DrawnPair& pair, Language language) {
  if (fault.undecided) return doubt(fault, language).in(language);
  const auto written = [&](double x) {
    if (fault.kind == Kind::undercut || fault.kind == Kind::undercut_by_edge) return short_number(x, language);
    const double shown = (counts(fault.kind) ? 1 : 1000) * (says_a_size(fault.kind) ? std::abs(x) : x);
    return figures(shown, 4, language);
  };
  const std::string limit = fault.kind == Kind::undercut || fault.kind == Kind::undercut_by_edge
                                ? figures(fault.limit, 4, language)
                                : written(fault.limit);
  return sentence_of(fault, pair, written(fault.value), limit, language).in(language);
}

void add_faults(DrawnSheet& onto, const DrawnPair& pair, Language language) {
  if (pair.faults.empty()) return;
  const bool several = pair.faults.size() > 1;
  onto.sheet.column.push_back(drawings::Heading{language == Language::english ? (several ? "Faults" : "Fault")
                                                                              : (several ? "Difetti" : "Difetto")});
  for (const Fault& fault : pair.faults)
    onto.sheet.column.push_back(drawings::Paragraph{sentence(fault, pair, language)});
}

}  // namespace epure::gear_pair
