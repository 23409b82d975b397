#include "exercises/cli/json_given.h"

namespace epure {

Json json_given(const Givens& givens, const GivenSpec& spec) {
  Json json = {{"symbol", spec.symbol}};
  if (const auto reading = givens.reading(spec.symbol)) {
    json["value"] = givens.text(spec.symbol);
    json["unit"] = reading->unit.symbol;
    if (spec.choices.empty()) json["number"] = json_number(nearest(reading->number));
  }
  if (!spec.also.empty()) json["also"] = spec.also;
  return json;
}

}  // namespace epure
