// Linkages and roulettes that are special whatever the direction of their links, at directions that are not: with
// angles of 0 to 5 decimals, in fractions of a turn and in radians, with frames on the axes and oblique, hit and
// missed, and with bars of very different sizes.
#pragma once

#include "exercises/kit/statement/givens.h"

#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace epure::tests {

// One question to an exercise.
struct SpecialCase {
  std::string family, exercise;
  std::vector<std::pair<std::string, Rational>> numbers;  // in the givens' units, where `units` has no other
  std::vector<std::string> words;                         // "branch=right"
  std::map<std::string, std::string> units = {};          // by symbol

  // As --set takes them, one after the other.
  std::vector<std::string> assignments() const;
  std::string text() const;
};

using Random = std::mt19937_64;

// A case of a family drawn by lot.
SpecialCase special_case(Random& random);

// The same with every length `times` as long: a similar figure.
SpecialCase scaled(const SpecialCase& one, const Rational& times);
// The same turned as a whole: a four-bar by a right angle, a slider-crank with its guide by any whole degrees. Only
// of an exercise whose frame may point anywhere, and whose crank was not turned by radians.
SpecialCase turned(const SpecialCase& one, Random& random);
bool can_be_turned(const SpecialCase& one);

}  // namespace epure::tests
