#include "exercises/kit/linkages/driving_crank.h"

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

Words where_it_closes(const std::vector<AngleRange>& ranges) {
  Words text;
  for (const AngleRange& range : ranges) {
    const Words from = decimal(range.from, 6), to = decimal(range.to, 6);
    text = text + (text.empty() ? Words{"; it closes ", "; si chiude "} : Words{" and ", " e "}) +
           (from == to ? format_words("at {}° only", "solo a {}°", from)
                       : format_words("from {}° to {}°", "da {}° a {}°", from, to));
  }
  return text;
}

}  // namespace epure
