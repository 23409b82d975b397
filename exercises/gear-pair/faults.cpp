#include "exercises/gear-pair/faults.h"

#include <cmath>
#include <utility>

#include "exercises/kit/panels/scale.h"
#include "exercises/kit/statement/given_number.h"

namespace epure::gear_pair {
namespace {

using geometry::Fault;
using Kind = Fault::Kind;

Words sentence_of(Kind kind, const Words& of, const Words& other, const Words& value, const Words& limit) {
  switch (kind) {
    case Kind::tip_inside_base:
      return format_words(
          "The tip circle {} ({}\u00a0mm) lies inside its base circle ({}\u00a0mm): it has no involute flank there.",
          "La circonferenza di testa {} ({}\u00a0mm) è interna a quella di base ({}\u00a0mm): lì non c'è fianco a "
          "evolvente.",
          of, value, limit);
    case Kind::pointed:
      return format_words(
          "The teeth {} are pointed: their flanks meet before the tip circle, where the thickness would be "
          "{}\u00a0mm.",
          "I denti {} sono a punta: i fianchi si incontrano prima della circonferenza di testa, dove lo spessore "
          "sarebbe {}\u00a0mm.",
          of, value);
    case Kind::undercut:
      return format_words("The cutter undercuts the teeth {}: z = {} is less than {}.",
                          "L'utensile produce sottotaglio nei denti {}: z = {} è minore di {}.", of, value, limit);
    case Kind::undercut_by_edge:
      return format_words(
          "The cutter's straight edge reaches deeper than its addendum and undercuts the teeth {}: z = {} is less "
          "than {}.",
          "Il tagliente rettilineo dell'utensile scende oltre l'addendum e produce sottotaglio nei denti {}: z = {} "
          "è minore di {}.",
          of, value, limit);
    case Kind::contact_on_fillet:
      return format_words(
          "The tips {} need the flank {} down to the radius {}\u00a0mm, but it begins at {}\u00a0mm: they run on the "
          "fillet.",
          "Le teste {} richiedono il fianco {} fino al raggio {}\u00a0mm, ma esso inizia a {}\u00a0mm: toccano il "
          "raccordo.",
          other, of, value, limit);
    case Kind::corner_in_root:
      return format_words(
          "Too little clearance: beside the line of action the corners of the tips {} dig into the root curve {}, by "
          "{}\u00a0mm.",
          "Gioco in testa insufficiente: fuori dalla linea d'azione gli spigoli delle teste {} penetrano nel "
          "raccordo {}, di {}\u00a0mm.",
          other, of, value);
    case Kind::negative_clearance:
      return format_words("No clearance: the tips {} dig into the roots {} by {}\u00a0mm.",
                          "Manca il gioco in testa: le teste {} penetrano nel fondo {} di {}\u00a0mm.", of, other,
                          value);
    case Kind::interference_approach:
      return format_words(
          "Interference: contact would begin before $T_{{1}}$, for $P_{{0}}A$ = {}\u00a0mm is longer than "
          "$P_{{0}}T_{{1}}$ = {}\u00a0mm.",
          "Interferenza: il contatto inizierebbe prima di $T_{{1}}$, perché $P_{{0}}A$ = {}\u00a0mm supera "
          "$P_{{0}}T_{{1}}$ = {}\u00a0mm.",
          value, limit);
    case Kind::interference_recess:
      return format_words(
          "Interference: contact would end beyond $T_{{2}}$, for $P_{{0}}E$ = {}\u00a0mm is longer than "
          "$P_{{0}}T_{{2}}$ = {}\u00a0mm.",
          "Interferenza: il contatto finirebbe oltre $T_{{2}}$, perché $P_{{0}}E$ = {}\u00a0mm supera "
          "$P_{{0}}T_{{2}}$ = {}\u00a0mm.",
          value, limit);
    case Kind::contact_ratio_below_one:
      return format_words("The contact ratio {} is below 1: one pair of teeth parts before the next touches.",
                          "Il fattore di ricoprimento {} è minore di 1: una coppia di denti si distacca prima che la "
                          "successiva si tocchi.",
                          value);
    case Kind::pointed_cutter:
      return format_words("No such cutter: its tip roundings overlap by {}\u00a0mm.",
                          "L'utensile non esiste: i raccordi di testa si sovrappongono di {}\u00a0mm.", value);
    case Kind::tips_collide:
      return format_words("The ring is too small: beside the mesh the tips run into each other by {}\u00a0mm.",
                          "La corona è troppo piccola: fuori dall'ingranamento le teste si urtano, di {}\u00a0mm.",
                          value);
  }
  return {};
}

// What stands beside the place in the figure.
Words mark_of(Kind kind) {
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
}

class Marker {
 public:
  Marker(Plot& plot, const Pair& pair, Language language) : plot_(plot), pair_(pair), language_(language) {}

  void mark(const Fault& fault, const Teeth& teeth) const {
    const int wheel = fault.wheel;
    constexpr double aside = 26, off = 36;  // mm
    switch (fault.kind) {
      case Kind::undercut:
      case Kind::undercut_by_edge:
        if (teeth.has(wheel)) at(teeth.foot_of_flank(wheel, free_tooth(wheel)), fault.kind);
        break;
      case Kind::pointed:
        if (teeth.has(wheel)) at(teeth.tip_of_tooth(wheel, free_tooth(wheel)), fault.kind);
        break;
      case Kind::pointed_cutter:
        if (teeth.has(1)) mark_cutter(teeth);
        break;
      case Kind::tip_inside_base:
      case Kind::negative_clearance:
        led(pair_.tip_at_mesh(wheel), fault.kind, {-aside, wheel == 1 ? off : -off});
        break;
      case Kind::contact_on_fillet:
        led(pair_.at(wheel == 1 ? *pair_.A : *pair_.E), fault.kind,
            wheel == 1 ? drawings::Point{14, -off} : drawings::Point{-14, off});
        break;
      case Kind::corner_in_root:
        led(pair_.tip_at_mesh(3 - wheel), fault.kind, {-aside, wheel == 2 ? off : -off});
        break;
      case Kind::interference_approach:
        beyond(pair_.T1, *pair_.A, fault.kind);
        break;
      case Kind::interference_recess:
        beyond(*pair_.T2, *pair_.E, fault.kind);
        break;
      case Kind::contact_ratio_below_one:
        break;  // marked by the path that is left, which may be too short where AE is not
      case Kind::tips_collide:
        mark_crossing_of_tips();
        break;
    }
  }

  // Where the next pair of teeth touches, this one has parted.
  void mark_missed_contact() const {
    plot_.segment(pair_.at(pair_.ends.xi), pair_.at(pair_.D()), fault_ink);
    led(pair_.at(pair_.D()), Kind::contact_ratio_below_one, {-8, 30});
  }

  // On the side to which the teeth leave: with the crossing at the height y over O1, x² + y² = r_a1² and
  // x² + (y - (O2 - O1))² = r_a2².
  void mark_crossing_of_tips() const {
    const double r1 = pair_("r_tip_", 1), r2 = pair_("r_tip_", 2), d = pair_.O(2).y - pair_.O(1).y;
    const double y = (d * d + (r1 - r2) * (r1 + r2)) / (2 * d), squared = (r1 - y) * (r1 + y);
    if (squared < 0) return;
    for (const double side : {-1.0, 1.0}) {
      const Place Q{side * std::sqrt(squared), pair_.O(1).y + y};
      plot_.cross(Q, fault_ink);
      if (side < 0) plot_.label(mark_of(Kind::tips_collide).in(language_), Q, pair_.O(1), fault_ink);
    }
  }

 private:
  void at(const Place& P, Kind kind) const {
    plot_.cross(P, fault_ink);
    plot_.label(mark_of(kind).in(language_), P, {}, fault_ink);
  }

  // In the midst of the mesh there is no room for words: they stand `away` mm from the place, at the end of a line.
  void led(const Place& P, Kind kind, drawings::Point away) const {
    const drawings::Point p = plot_.at(P);
    const Place end = plot_.from_paper({p.x + away.x, p.y + away.y});
    plot_.cross(P, fault_ink);
    plot_.segment(P, end, Meaning::dimension);
    plot_.label(mark_of(kind).in(language_), end, P, fault_ink);
  }

  // What should not be needed of the line of action.
  void beyond(double from, double to, Kind kind) const {
    plot_.segment(pair_.at(from), pair_.at(to), fault_ink);
    at(pair_.at(to), kind);
  }

  // Away from the teeth in contact and the letters there: wheel 1's to the left, wheel 2's to the right.
  double free_tooth(int wheel) const { return wheel == 1 || pair_.is_rack() || pair_.is_ring() ? 1 : 2; }

  // At a root of wheel 1: of a small wheel one that opens away from the mesh, where words stand outside its teeth.
  void mark_cutter(const Teeth& teeth) const {
    const Place O = pair_.O(1);
    const auto root = [&](const Arrow2& out) { return O + pair_("r_root_", 1) * out; };
    const Arrow2 aside = teeth.direction_of_tooth(1, std::ceil(static_cast<double>(pair_.of.z1) / 6) + 0.5);
    constexpr double away = 26;  // mm
    const drawings::Point p = plot_.at(root(aside)), way{away * aside.x, away * aside.y};
    if (plot_.shows(plot_.from_paper({p.x + way.x, p.y + way.y})))
      led(root(aside), Kind::pointed_cutter, way);
    else
      at(root(teeth.direction_of_tooth(1, 1.5)), Kind::pointed_cutter);
  }

  Plot& plot_;
  const Pair& pair_;
  Language language_;
};

}  // namespace

Words name_of(int wheel, const geometry::PairData& of) {
  if (wheel == 2 && of.kind == geometry::PairKind::rack) return {"the rack", "la dentiera"};
  if (wheel == 2 && of.kind == geometry::PairKind::internal) return {"the ring", "la corona"};
  return format_words("wheel {}", "la ruota {}", wheel);
}

namespace {

// With figures that say which is the greater.
std::pair<Words, Words> both_in_mm(double value, double limit) {
  if (in_mm(value).english != in_mm(limit).english) return {in_mm(value), in_mm(limit)};
  constexpr double mm = 1e3;
  const int figures = figures_that_tell_apart(value, limit).value_or(15);
  return {decimal(mm * value, figures), decimal(mm * limit, figures)};
}

}  // namespace

Words sentence(const Fault& fault, const geometry::PairData& pair) {
  if (fault.undecided)
    return format_words("Undecided: {} (no number could tell: {}).",
                        "Non deciso: {} (nessun numero ha potuto dirlo: {}).", mark_of(fault.kind), fault.reason);
  const Words of{"of ", "del"};  // la ruota, della ruota
  const Words wheel = of + name_of(fault.wheel, pair), other = of + name_of(3 - fault.wheel, pair);
  switch (fault.kind) {
    case Kind::undercut:
    case Kind::undercut_by_edge:
      return sentence_of(fault.kind, wheel, other, decimal(fault.value, 6), written(fault.limit));
    case Kind::contact_ratio_below_one:
      return sentence_of(fault.kind, wheel, other, written(fault.value), {});
    case Kind::pointed:
    case Kind::interference_approach:
    case Kind::interference_recess:
    case Kind::tip_inside_base:
    case Kind::contact_on_fillet: {
      const auto [value, limit] = both_in_mm(fault.value, fault.limit);
      return sentence_of(fault.kind, wheel, other, value, limit);
    }
    default:  // by how much something is missing, or overlaps
      return sentence_of(fault.kind, wheel, other, in_mm(std::abs(fault.value)), {});
  }
}

void mark_faults(Plot& plot, const Pair& pair, const Teeth& teeth, Language language) {
  const Marker marker(plot, pair, language);
  for (const Fault& fault : pair.faults)
    if (!fault.undecided) marker.mark(fault, teeth);
  if (pair.has_contact() && pair.touches && !pair.is_continuous) marker.mark_missed_contact();
}

void mark_colliding_tips(Plot& plot, const Pair& pair, Language language) {
  if (pair.has(Kind::tips_collide)) Marker(plot, pair, language).mark_crossing_of_tips();
}

}  // namespace epure::gear_pair
