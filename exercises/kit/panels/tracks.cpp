#include "exercises/kit/panels/tracks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawings/labels/candidates.h"
#include "drawings/paths/vectors.h"

namespace epure {
namespace {

using drawings::Point;

constexpr double between_tracks = 1.5;  // mm: the heads of two neighbours, 1.1 mm wide, do not touch

VectorOnPaper moved(const VectorOnPaper& v, Point by) { return {v.first + by, v.second + by}; }

// From one point in one sense, the second one's head well before the first one's.
bool ends_before(const VectorOnPaper& a, const VectorOnPaper& b) {
  constexpr double one_point = 0.9, heads_apart = 6;  // mm
  return drawings::distance(a.first, b.first) < one_point && dot(a.second - a.first, b.second - b.first) > 0 &&
         drawings::distance(b.first, b.second) < drawings::distance(a.first, a.second) - heads_apart;
}

// At so small an angle that the eye does not tell which goes on where.
bool cross_slimly(const VectorOnPaper& a, const VectorOnPaper& b) {
  constexpr double slim = 0.1;  // rad
  return drawings::cross(a, b) && std::abs(dot(drawings::left_of(drawings::unit(a.first, a.second)),
                                               drawings::unit(b.first, b.second))) < slim;
}

// Across a vector, away from the middle of the figure; from a middle on its line, to the left.
Point outwards(const VectorOnPaper& v, Point middle) {
  constexpr double on_line = 0.2;  // mm
  const Point left = drawings::left_of(drawings::unit(v.first, v.second));
  return dot(middle - v.first, left) > on_line ? -1 * left : left;
}

}  // namespace

std::optional<std::pair<double, double>> covered(const VectorOnPaper& a, const VectorOnPaper& b) {
  constexpr double shortest = 3, told_apart = 0.9;  // mm: a head's length, and more than a line's width
  const Point along = drawings::unit(a.first, a.second), aside = drawings::left_of(along);
  const double start = dot(b.first - a.first, along), end = dot(b.second - a.first, along);
  const double from = std::max(0.0, std::min(start, end)),
               to = std::min(drawings::distance(a.first, a.second), std::max(start, end));
  if (to - from < shortest) return {};
  for (const double there : {from, to}) {
    const Point p = drawings::between(b.first, b.second, (there - start) / (end - start));
    if (std::abs(dot(p - a.first, aside)) >= told_apart) return {};
  }
  return std::pair{from, to};
}

std::vector<Track> tracks(const std::vector<VectorOnPaper>& vectors, Point middle, LyingOver which,
                          const std::vector<std::size_t>& stay) {
  std::vector<std::size_t> order(vectors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return std::find(stay.begin(), stay.end(), i) != stay.end(); });
  std::vector<Track> all(vectors.size());
  std::vector<std::size_t> before;
  for (const std::size_t n : order) {
    const VectorOnPaper& v = vectors[n];
    const auto is_free = [&](Point by) {
      return std::none_of(before.begin(), before.end(), [&](std::size_t i) {
        const VectorOnPaper there = moved(vectors[i], all[i].by), here = moved(v, by);
        if (drawings::length(by) > 0 && cross_slimly(there, here)) return true;
        return covered(there, here) && !(which == LyingOver::of_a_polygon && ends_before(there, here));
      });
    };
    const Point out = outwards(v, middle);
    Track& track = all[n];
    for (int lane = 1; !is_free(track.by); lane = lane > 0 ? -lane : 1 - lane) {
      track.by = lane * between_tracks * out;
      track.letters = lane > 0 ? out : -1 * out;
    }
    // Where it runs along another's middle, where its letters would be, these stand on the other side.
    for (const std::size_t i : before) {
      const auto common = covered(vectors[i], v);
      const double half = drawings::distance(vectors[i].first, vectors[i].second) / 2;
      if (track.letters && common && common->first < half && half < common->second && !all[i].letters)
        all[i].letters = -1 * *track.letters;
    }
    before.push_back(n);
  }
  return all;
}

}  // namespace epure
