#include "exercises/scenes/coincidences.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/statement/format_words.h"
#include "geometry/linkages/carried_out.h"
#include "geometry/numbers/climb.h"

namespace epure::scenes {
namespace {

using namespace geometry;

bool are_of_one_link(const Linkage& linkage, int P, int Q) {
  const std::vector<int> of_P = linkage.links_at(P), of_Q = linkage.links_at(Q);
  return std::any_of(of_P.begin(), of_P.end(),
                     [&](int link) { return std::find(of_Q.begin(), of_Q.end(), link) != of_Q.end(); });
}

// Two points that doubles cannot tell apart.
std::vector<std::pair<int, int>> near_ones(const Built& built) {
  const Arithmetic<Fast> scope;
  constexpr double apart = 1e-9;  // of the greatest distance; only a sieve, exact numbers decide
  const auto points = CarriedOut<Fast>(built.linkage, built.steps).position().points;
  const auto distance = [&](int P, int Q) {
    return std::hypot(points[index(P)].x - points[index(Q)].x, points[index(P)].y - points[index(Q)].y);
  };
  const int count = built.linkage.count_of_points();
  double greatest = 0;
  for (int Q = 1; Q < count; ++Q) greatest = std::max(greatest, distance(0, Q));
  std::vector<std::pair<int, int>> near;
  for (int P = 0; P < count; ++P)
    for (int Q = P + 1; Q < count; ++Q)
      if (distance(P, Q) < apart * greatest && !are_of_one_link(built.linkage, P, Q)) near.emplace_back(P, Q);
  return near;
}

}  // namespace

std::vector<Words> coincidences(const Built& built) {
  std::vector<Words> told;
  const Words doubt = built.linkage.chosen.empty()
                          ? Words{" here.", " qui."}
                          : Words{": is a side under assembly: wrong?", ": un lato sotto assembly: è sbagliato?"};
  try {
    for (const auto& [P, Q] : near_ones(built)) {
      const Decision decided = decide([&, P = P, Q = Q]<class T>() {
        const auto points = CarriedOut<T>(built.linkage, built.steps).position().points;
        return length_squared(points[index(P)] - points[index(Q)]);
      });
      const auto &p = built.letters.points[index(P)], &q = built.letters.points[index(Q)];
      if (decided.sign == Sign::zero)
        told.push_back(format_words(
            "{} and {} lie in one place{} (Where they are a hinge, one letter says so.)",
            "{} e {} stanno in un solo posto{} (Se sono una cerniera, lo dice una lettera sola.)", p, q, doubt));
      if (decided.sign == Sign::undecided)
        told.push_back(format_words("whether {} and {} lie in one place could not be decided",
                                    "non si è potuto decidere se {} e {} stiano in un solo posto", p, q));
    }
  } catch (const Impossible&) {  // it does not close
  } catch (const Undecided&) {
  }
  return told;
}

}  // namespace epure::scenes
