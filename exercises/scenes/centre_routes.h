// The instant centres of all pairs of a scene's links, as they are written down: where they are, or that two links
// turn alike or rest against each other.
#pragma once

#include <memory>
#include <string>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/route_plan.h"

namespace epure::scenes {

struct CentreRoutes {
  std::shared_ptr<const Built> built;
  std::shared_ptr<const RoutePlan> plan;

  // The velocity of the body's point in the origin of the plane.
  template <class T>
  static Vector<T> of_origin(const PlaneMotion<T>& body) {
    return body.velocity({T(0), T(0)});
  }

  // P with c + ω k x P = 0.
  template <class T>
  static ProjectivePoint<T> at_rest_against(const T& omega, const Vector<T>& c) {
    const Vector<T> n = quarter_turn(c);
    return {n.x, n.y, omega};
  }

  // The joint of two links one of which rolls on the other, as a wheel does on a wheel or a line: where they touch is
  // their centre however they move, and at an instant at which they rest, as that of a hinge is. Null: no such joint.
  const PermanentCentre* touching(std::size_t i, std::size_t j) const {
    const PermanentCentre* joint = plan->centres.permanent_of(static_cast<int>(i), static_cast<int>(j));
    return joint && joint->is_of_touching() && !plan->alike.turn_alike(i, j) ? joint : nullptr;
  }

  // Of all pairs of links: what a joint gives, or what `find` finds of the two.
  template <class T, class OfPoint, class OfTouching, class Find>
  void put_centres(Ledger<T>& ledger, const OfPoint& of_point, const OfTouching& of_touching,
                   const Find& find) const {
    const std::size_t count = built->linkage.links.size();
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) {
        const PermanentCentre* joint = plan->centres.permanent_of(static_cast<int>(i), static_cast<int>(j));
        if (!joint || joint->is_of_touching())
          put_centre(ledger, i, j, [&, i, j] {
            const PermanentCentre* const touch = touching(i, j);
            return touch ? of_touching(*touch) : find(i, j);
          });
        else if (joint->point != nothing)
          put_centre(ledger, i, j, [&] { return of_point(joint->point); });
        else
          put_centre(ledger, i, j, [&]() -> ProjectivePoint<T> {
            throw Impossible(format_words("it is at infinity, square to {}, on which the two slide",
                                          "è all'infinito, normale a {}, su cui i due scorrono",
                                          built->letters.lines[index(joint->line)]));
          });
      }
  }

  template <class T, class Find>
  void put_centre(Ledger<T>& ledger, std::size_t i, std::size_t j, const Find& find) const {
    const PointQuantity P = instant_centre(built->letters.links[i], built->letters.links[j]);
    const auto found = [this, i, j, &find] {
      if (plan->alike.move_as_one(i, j)) refuse_at_rest(i, j);
      return find();
    };
    ledger.put(P.x(), [this, i, j, found] {
      const auto centre = found();
      return coordinate(i, j, centre, centre.x);
    });
    ledger.put(P.y(), [this, i, j, found] {
      const auto centre = found();
      return coordinate(i, j, centre, centre.y);
    });
  }

  // One of P's. Throws Impossible, with the direction in which it is, where the links are proved not to turn against
  // each other.
  template <class T>
  T coordinate(std::size_t i, std::size_t j, const ProjectivePoint<T>& P, const T& of_P) const {
    const Sign turns = plan->alike.turn_alike(i, j) ? Sign::zero : sign(P.w);
    if (turns == Sign::positive || turns == Sign::negative) return quotient(of_P, P.w);
    const std::string a = std::to_string(built->letters.links[i]), b = std::to_string(built->letters.links[j]);
    if (turns == Sign::undecided)
      throw Undecided(i == 0 ? format_words("whether link {} turns", "se il membro {} ruoti", b)
                             : format_words("whether links {} and {} turn alike",
                                            "se i membri {} e {} ruotino ugualmente", a, b));
    demand_motion(i, j, P);
    if (i != 0)
      throw Impossible(format_words("it is at infinity: links {} and {} turn alike",
                                    "è all'infinito: i membri {} e {} ruotano ugualmente", a, b));
    const auto& points = built->linkage.links[j].points;
    const Words whose = points.empty() ? Words{"its velocity", "sua velocità"}
                                       : Words{"the velocity of ", "velocità di "} +
                                             built->letters.points[index(points.front().point)];
    throw Impossible(format_words("it is at infinity, square to {}: link {} does not turn",
                                  "è all'infinito, normale alla {}: il membro {} non ruota", whose, b));
  }

  // Throws where the two are proved to rest against each other, or that cannot be told: then each point is one.
  template <class T>
  void demand_motion(std::size_t i, std::size_t j, const ProjectivePoint<T>& P) const {
    bool is_at_rest = true;
    for (const T& x : {P.x, P.y, plan->alike.turn_alike(i, j) ? T(0) : P.w}) {
      const Sign moves = sign(x);
      if (moves == Sign::positive || moves == Sign::negative) return;
      is_at_rest = is_at_rest && moves == Sign::zero;
    }
    if (is_at_rest) refuse_at_rest(i, j);
    const std::string a = std::to_string(built->letters.links[i]), b = std::to_string(built->letters.links[j]);
    throw Undecided(i == 0 ? format_words("whether link {} rests", "se il membro {} sia fermo", b)
                           : format_words("whether links {} and {} move against each other",
                                          "se i membri {} e {} si muovano l'uno rispetto all'altro", a, b));
  }

  [[noreturn]] void refuse_at_rest(std::size_t i, std::size_t j) const {
    const std::string a = std::to_string(built->letters.links[i]), b = std::to_string(built->letters.links[j]);
    throw Impossible(i == 0 ? format_words("link {} rests: each of its points is one",
                                           "il membro {} è fermo: ogni suo punto lo è", b)
                            : format_words("links {} and {} do not move against each other",
                                           "i membri {} e {} non si muovono l'uno rispetto all'altro", a, b));
  }
};

}  // namespace epure::scenes
