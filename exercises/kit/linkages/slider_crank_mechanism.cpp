#include "exercises/kit/linkages/slider_crank_mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/linkages/slider_crank_routes.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {

std::shared_ptr<const Mechanism> slider_crank_mechanism(const Solution& solution, const SliderCrankInstant& instant,
                                                        const CouplerTurning& coupler) {
  using Joint = Mechanism::Joint;
  const double delta = geometry::to_double(instant.guide), r = CGAL::to_double(instant.lengths.r),
               e = CGAL::to_double(instant.lengths.e);
  const Arrow2 along{std::cos(delta), std::sin(delta)}, left{-along.y, along.x};
  const Place A0 = solution.place("A0"), foot = A0 + e * left, B = solution.place("B");
  const double b = dot(B - foot, along);
  Mechanism mechanism;
  mechanism.point("A0", A0, Joint::fixed, "$A_{0}$")
      .point("A", solution.place("A"), Joint::hinge, "$A$")
      .point("B", B, Joint::block, "$B$")
      .point("C", solution.place("C"), Joint::none, "$C$")
      .point("M", solution.place("M"), coupler.marks_M ? Joint::none : Joint::corner, coupler.marks_M ? "$M$" : "")
      .body({"A0", "A"}, 2)
      .body({"A", "B", "C"}, 3)
      .guide("B", delta)
      .axis(foot + std::min(-r, b) * along, foot + std::max(r, b) * along)
      .path("A0", "A")
      .turning("A0", "A", sign_of(instant.n), "$ω_{2}$");
  if (coupler.sense != 0) mechanism.turning_found("A", "B", coupler.sense, coupler.symbol);
  if (instant.is_offset()) mechanism.offset("A0", foot, b > 0 ? delta + std::numbers::pi : delta, r, "$e$");
  if (coupler.marks_phi && !instant.is_offset() && !instant.is_inclined())
    mechanism.angle("A0", 0, std::fmod(geometry::to_double(instant.crank), 2 * std::numbers::pi), "$φ$");
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

std::string swing_in_words(const Solution& solution, Language language) {
  std::string text;
  for (std::size_t i = 0; solution.has(crank_limit(i).name); i += 2) {
    const Words sentence = text.empty() ? Words{"The crank cannot turn fully: $φ$ from {}° to {}°",
                                                "La manovella non compie il giro: $φ$ da {}° a {}°"}
                                        : Words{" or from {}° to {}°", " o da {}° a {}°"};
    text += fmt::format(fmt::runtime(sentence.in(language)), figures(solution[crank_limit(i).name], 4, language),
                        figures(solution[crank_limit(i + 1).name], 4, language));
  }
  return text.empty() ? text : text + ".";
}

std::string parallel_to_guide(const SliderCrankInstant& at, Language language) {
  if (!at.is_offset()) return "∥ $A_{0}B$";
  return Words{"∥ guide", "∥ guida"}.in(language);
}

}  // namespace epure
