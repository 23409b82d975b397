// Coulomb's law, and how the forces are found that obey it; both routes read it, each with its own equilibrium.
//
// Friction holds back whatever presses from either side: its force along the line is
// -sense · coefficient · sense of sliding · N, with the sense that N has, which is not known before N is. So all
// senses are tried, and those hold that agree with the forces that they give.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "geometry/linkages/loads.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry {

// Whether what rubs slides ahead or back along its line: 1 or -1. Throws Impossible where it is at rest.
template <class T>
int sense_of_sliding(const T& velocity) {
  const Sign slides = sign(velocity);
  if (slides == Sign::undecided)
    throw Undecided("which way it slides where there is friction", "in che verso strisci dove c'è attrito");
  if (slides == Sign::zero)
    throw Impossible("nothing slides there at this instant: friction may have any size up to its limit",
                     "lì in questo istante nulla striscia: l'attrito può avere qualunque valore fino al suo limite");
  return slides == Sign::positive ? 1 : -1;
}

// A number that is one of the two: an enclosure of both, or of two doubles the first. Throws Undecided on exact
// numbers.
template <class T>
T either(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, Bounded> || std::is_same_v<T, Deep>)
    return widened(a, root(square(b - a)));
  else if constexpr (std::is_same_v<T, Fast>)
    return a;
  else
    throw Undecided("from which side a guide presses", "da quale parte prema una guida");
}
template <class T>
JointForces<T> either(JointForces<T> a, const JointForces<T>& b) {
  for (std::size_t k = 0; k < a.hinges.size(); ++k) {
    a.hinges[k].x = either(a.hinges[k].x, b.hinges[k].x);
    a.hinges[k].y = either(a.hinges[k].y, b.hinges[k].y);
    a.hinges[k].couple = either(a.hinges[k].couple, b.hinges[k].couple);
  }
  for (std::size_t k = 0; k < a.pins.size(); ++k) {
    a.pins[k] = either(a.pins[k], b.pins[k]);
    a.pin_frictions[k] = either(a.pin_frictions[k], b.pin_frictions[k]);
  }
  for (std::size_t k = 0; k < a.guides.size(); ++k) {
    a.guides[k].force = either(a.guides[k].force, b.guides[k].force);
    a.guides[k].couple = either(a.guides[k].couple, b.guides[k].couple);
    a.guides[k].friction = either(a.guides[k].friction, b.guides[k].friction);
  }
  for (std::size_t k = 0; k < a.teeth.size(); ++k) {
    a.teeth[k].tangential = either(a.teeth[k].tangential, b.teeth[k].tangential);
    a.teeth[k].radial = either(a.teeth[k].radial, b.teeth[k].radial);
  }
  for (std::size_t k = 0; k < a.drives.size(); ++k) a.drives[k] = either(a.drives[k], b.drives[k]);
  return a;
}

// With friction in `count` places: `find` gives the sets of forces for senses of ±1, none or throwing Impossible
// where there are none, `normal` of them what presses in place k, `either` what is one of two. Where nothing presses
// both senses say the same, and a number that cannot tell that it is nothing gets an enclosure of both. Throws
// Impossible where no senses agree, or more than one set of forces does; Undecided.
template <class Found, class Find, class Normal, class Either>
Found forces_with_friction(std::size_t count, const Find& find, const Normal& normal, const Either& either_of) {
  struct Candidate {
    std::vector<int> senses;
    Found found;
    bool is_proved = true;
    std::vector<bool> open = {};  // where from which side it presses is not proved
  };
  std::vector<Candidate> agreeing;
  for (std::size_t k = 0; k < (std::size_t{1} << count); ++k) {
    std::vector<int> senses;
    for (std::size_t i = 0; i < count; ++i) senses.push_back((k >> i) % 2 == 0 ? 1 : -1);
    std::vector<Found> all_found;
    try {
      all_found = find(senses);
    } catch (const Impossible&) {
      if (count == 0) throw;
      continue;
    }
    for (Found& found : all_found) {
      Candidate candidate{senses, std::move(found)};
      bool agrees = true;
      for (std::size_t i = 0; i < count && agrees; ++i) {
        const Sign presses = sign(normal(candidate.found, i));
        candidate.open.push_back(presses == Sign::undecided);
        candidate.is_proved = candidate.is_proved && presses != Sign::undecided;
        agrees = senses[i] > 0 ? presses != Sign::negative : presses == Sign::negative || presses == Sign::undecided;
      }
      if (agrees) agreeing.push_back(std::move(candidate));
    }
  }
  if (agreeing.empty())
    throw Impossible("there is so much friction that the mechanism jams: no forces are in equilibrium",
                     "c'è tanto attrito che il meccanismo si impunta: nessun sistema di forze è in equilibrio");
  Found all = agreeing.front().found;
  for (std::size_t c = 1; c < agreeing.size(); ++c) {
    const Candidate &one = agreeing.front(), &other = agreeing[c];
    if (one.is_proved && other.is_proved)
      throw Impossible("there is so much friction that more than one set of forces is in equilibrium",
                       "c'è tanto attrito che più di un sistema di forze è in equilibrio");
    for (std::size_t i = 0; i < count; ++i)
      if (one.senses == other.senses || (one.senses[i] != other.senses[i] && !(one.open[i] && other.open[i])))
        throw Undecided("from which side a guide presses", "da quale parte prema una guida");
    all = either_of(all, other.found);
  }
  return all;
}

}  // namespace epure::geometry
