#include "exercises/scenes/file/limits.h"

#include <algorithm>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/file/refusals.h"
#include "exercises/scenes/forces/scene_forces.h"
#include "geometry/numbers/climb.h"

namespace epure::scenes {

using namespace geometry;

std::optional<Words> limit_of(const Built& built) {
  for (std::size_t step = 0; step < built.steps.size(); ++step) {
    const auto is_at_limit = [&]<class T>() {
      const CarriedOut<T> carried_out(built.linkage, built.steps);
      const Sign room = sign(carried_out.from_limit(step, carried_out.position_before(step)));
      return room == Sign::undecided ? Truth::undecided : room == Sign::zero ? Truth::yes : Truth::no;
    };
    if (ask(is_at_limit).truth == Truth::yes) return limit_in_words(step, built);
  }
  return {};
}

std::optional<Words> no_forces_with_friction(const Built& built) {
  if (!built.loads) return {};
  const auto& frictions = built.loads->frictions;
  for (std::size_t k = 0; k < frictions.size(); ++k) {
    const auto is_at_rest = [&]<class T>() {
      const Sign slides = sign(sliding_velocities(built, Constructed<T>(built), *built.loads)[k]);
      return slides == Sign::undecided ? Truth::undecided : slides == Sign::zero ? Truth::yes : Truth::no;
    };
    if (ask(is_at_rest).truth != Truth::yes) continue;
    const Contact at = contact(built, frictions[k]);
    return format_words(
        "{} does not slide on {} at this instant: friction there may have any size up to its limit{}",
        "{} in questo istante non scorre su {}: l'attrito lì può avere qualunque valore fino al suo limite{}",
        at.slides, at.line, moves(built) ? Words{} : Words{"; no drive has a speed", "; nessun movente ha velocità"});
  }
  const JointForces<Fast> joints(built.linkage);
  for (std::size_t k = 0; k < joints.hinges.size(); ++k) {
    const auto& hinge = joints.hinges[k];
    if (!has_friction(*built.loads, hinge.point)) continue;
    const auto is_at_rest = [&]<class T>() {
      const Sign turns = sign(turning_in_hinges(built, Constructed<T>(built), *built.loads)[k]);
      return turns == Sign::undecided ? Truth::undecided : turns == Sign::zero ? Truth::yes : Truth::no;
    };
    if (ask(is_at_rest).truth != Truth::yes) continue;
    return format_words(
        "links {} and {} do not turn against each other at this instant: friction in {} may have any size up to its "
        "limit",
        "i membri {} e {} in questo istante non ruotano l'uno sull'altro: l'attrito in {} può avere qualunque valore "
        "fino al suo limite",
        built.letters.links[index(hinge.by)], built.letters.links[index(hinge.on)],
        built.letters.points[index(hinge.point)]);
  }
  std::optional<Words> why;
  const auto jams = [&]<class T>() {
    if (has_inertia_apart<T>(built)) return Truth::undecided;
    try {
      forces_by_groups(built, Constructed<T>(built), *built.loads, has_inertia(built));
      return Truth::no;
    } catch (const Impossible& impossible) {
      why = impossible.words();
      return Truth::yes;
    } catch (const Undecided&) {
      return Truth::undecided;
    }
  };
  if (!built.loads->has_friction() || ask(jams).truth != Truth::yes) return {};
  return why;
}

}  // namespace epure::scenes
