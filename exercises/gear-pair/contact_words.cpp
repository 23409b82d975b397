#include "exercises/gear-pair/contact_words.h"

#include <cmath>

#include "exercises/gear-pair/faults.h"

namespace epure::gear_pair {
namespace {

const Words of_whole_flanks{" of whole flanks", " di fianchi interi"};

// "$F_{1}$, 3.2 mm before $P_{0}$".
Words place_of(const PathEnd& end) {
  return format_words("${}$, {}\u00a0mm {} $P_{{0}}$", "${}$, {}\u00a0mm {} $P_{{0}}$", end.letters(),
                      in_mm(std::abs(end.xi)), end.xi < 0 ? Words{"before", "prima di"} : Words{"after", "dopo"});
}

Words shortened(const Pair& pair) {
  Words text;
  if (pair.begins.point == "F1") text = Words{"flank 1 begins only in ", "il fianco 1 inizia solo in "};
  if (pair.begins.point == "V2")
    text = name_of(2, pair.of) + Words{", pointed, touches only from ", ", a punta, tocca solo da "};
  if (pair.begins.is_short()) text = text + place_of(pair.begins);
  if (!pair.ends.is_short()) return text;
  if (!text.empty()) text = text + Words{", and ", ", e "};
  return text +
         (pair.ends.point == "F2"
              ? Words{"flank 2 reaches only to ", "il fianco 2 arriva solo a "}
              : Words{"wheel 1, pointed, touches only to ", "la ruota 1, a punta, tocca solo fino a "}) +
         place_of(pair.ends);
}

// Of the path that is left: "$f$ = $F_{1}E$/$p_{b}$ = 1.021".
Words true_contact_ratio(const Pair& pair) {
  const Words below = pair.is_continuous ? Words{} : Words{", below 1", ", minore di 1"};
  return format_words("$f$ = ${}$/$p_{{b}}$ = {}{}", "$f$ = ${}$/$p_{{b}}$ = {}{}", pair.name_of_path(),
                      written(pair.s["true_contact_ratio"]), below);
}

}  // namespace

// On working circles that are not the reference circles the pitch is not p: then by the line of action.
Words about_ratio(const Pair& pair) {
  const std::string quotient = pair.is_shifted() ? "$AE$/$p_{b}$" : "$e$/$p$";
  const Words value = written(pair.s["contact_ratio"]);
  const Words text =
      format_words("Contact ratio $f$ = {} = {}", "Fattore di ricoprimento $f$ = {} = {}", quotient, value);
  if (!pair.is_whole()) return text + of_whole_flanks + ".";
  if (!pair.is_continuous) return text + ".";
  return text + Words{" ≥ 1: the next teeth touch before these part, the motion is continuous.",
                      " ≥ 1: i denti seguenti si toccano prima che questi si stacchino, il moto è continuo."};
}

Words both_contact_ratios(const Pair& pair) {
  const Words whole = written(pair.s["contact_ratio"]);
  if (pair.is_whole()) return "$f$ = " + whole;
  if (!pair.is_known || !pair.touches) return "$f$ = " + whole + of_whole_flanks;
  return true_contact_ratio(pair) + " (" + whole + of_whole_flanks + ")";
}

Words about_path(const Pair& pair, const Words& whole) {
  if (!pair.is_known) return whole + ".";
  const Words left = pair.touches
                         ? format_words("contact ${}$ = {}\u00a0mm, {}", "contatto ${}$ = {}\u00a0mm, {}",
                                        pair.name_of_path(), in_mm(pair.s["contact"]), true_contact_ratio(pair))
                         : Words{"they never touch", "non si toccano mai"};
  return format_words("{}, but {}: {}.", "{}, ma {}: {}.", whole, shortened(pair), left);
}

}  // namespace epure::gear_pair
