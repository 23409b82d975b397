#include "exercises/kit/linkages/driving_crank.h"

#include <cmath>

#include "exercises/kit/statement/format_words.h"

namespace epure {

GivenSpec instant_given(const std::string& stated, Range range, const std::vector<std::string>& also) {
  return {.symbol = "t",
          .meaning = {"instant, counted from the crank on +x", "istante, dalla manovella sul semiasse +x"},
          .unit = "s",
          .stated = stated,
          .range = range,
          .letters = "$t$",
          .also = also};
}

GivenSpec crank_angle_given() {
  return {
      .symbol = "phi",
      .meaning = {"crank angle from +x, in place of the instant", "angolo di manovella da +x, in luogo dell'istante"},
      .unit = "deg",
      .stated = "",
      .range = Range::any,
      .letters = "$φ$",
      .turned = TurnedThrough{.instant = "t", .speed = "n"}};
}

namespace {

// An end of a range, with as many digits as part it from the crank, which is not there.
Words end_in_words(double end, double inwards, double crank) {
  const double apart = end == crank ? std::nextafter(end, inwards) : end;
  int digits = 6;
  constexpr int all_digits = 17;
  while (digits < all_digits && decimal(apart, digits) == decimal(crank, digits)) ++digits;
  return decimal(apart, digits);
}

}  // namespace

Words where_it_closes(const std::vector<AngleRange>& ranges, const Angle& crank) {
  const double at = geometry::degrees(crank);
  Words text;
  for (const AngleRange& range : ranges) {
    const double turned = 360 * std::trunc((at - (range.from + range.to) / 2) / 360);
    const double first = range.from + turned, last = range.to + turned, middle = (first + last) / 2;
    const Words from = end_in_words(first, middle, at), to = end_in_words(last, middle, at);
    text = text + (text.empty() ? Words{"; it closes ", "; si chiude "} : Words{" and ", " e "}) +
           (range.from == range.to ? format_words("at {}° only", "solo a {}°", from)
            : from == to           ? format_words("within {}° of {}° only", "solo entro {}° da {}°",
                                                  decimal((range.to - range.from) / 2, 2), decimal(middle, 15))
                                   : format_words("from {}° to {}°", "da {}° a {}°", from, to));
  }
  return text;
}

void require_turning(const Angle& n, const Angle& alpha_2) {
  if (!is_zero(n)) return;
  const Words at_rest{"n = 0 rpm: the crank must turn, n must differ from 0",
                      "n = 0 rpm: la manovella deve girare, n dev'essere diverso da 0"};
  if (is_zero(alpha_2)) throw BadGivens(at_rest);
  throw BadGivens(at_rest +
                  Words{", also where alpha_2 is given: poles, circles and curvature are those of a motion; for the "
                        "accelerations with which it starts from rest take a speed as small as n = 1e-9",
                        ", anche quando è dato alpha_2: poli, cerchi e curvatura sono quelli di un moto; per le "
                        "accelerazioni con cui parte da fermo prendere una velocità piccola come n = 1e-9"});
}

}  // namespace epure
