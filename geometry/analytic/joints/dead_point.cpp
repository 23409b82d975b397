#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "geometry/analytic/joints/beginning.h"
#include "geometry/analytic/joints/enclosed.h"
#include "geometry/analytic/joints/in_doubles.h"
#include "geometry/analytic/joints/sides.h"

namespace epure::geometry::analytic {
namespace {

using namespace joints;

// The links' places, and how they move while all drives stand still (solve_dead_point).
template <class T>
class AtDeadPoint {
 public:
  AtDeadPoint(const Linkage& linkage, int drive, std::size_t kept_one)
      : linkage_(linkage), drive_(static_cast<std::size_t>(drive)), kept_one_(kept_one) {}

  std::vector<Equation<T>> operator()(const Column<T>& places_and_motion) const {
    const auto half = static_cast<std::ptrdiff_t>(places_and_motion.size() / 2);
    const Column<T> q(places_and_motion.begin(), places_and_motion.begin() + half),
        n(places_and_motion.begin() + half, places_and_motion.end());
    const std::vector<Equation<T>> rows = equations(linkage_, q);
    const std::size_t driven = row_of_drive(linkage_, rows, drive_);
    std::vector<Equation<T>> all;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (i != driven) all.push_back({.residual = rows[i].residual, .slopes = rows[i].slopes});
    const std::size_t first = all.size();
    for (const Equation<T>& row : rows) {
      Equation<T>& still = all.emplace_back(Equation<T>{.residual = along(row, n), .slopes = {}});
      for (const auto& [column, slope] : row.slopes) still.slopes.emplace_back(column + half, slope);
    }
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Column<T> with = second_along(q, n, j, T(1)), without = second_along(q, n, j, T(-1));
      for (std::size_t i = 0; i < rows.size(); ++i)
        all[first + i].slopes.emplace_back(static_cast<int>(j), quotient(with[i] - without[i], T(4)));
    }
    all.push_back({.residual = n[kept_one_] - T(1), .slopes = {{half + static_cast<int>(kept_one_), T(1)}}});
    return all;
  }

 private:
  // Φ''(n ± e, n ± e): of both 4 Φ''(n, e) is left.
  Column<T> second_along(const Column<T>& q, Column<T> n, std::size_t j, const T& sense) const {
    n[j] += sense;
    Column<T> all;
    for (const Equation<T>& row : equations(linkage_, moving(q, n))) all.push_back(row.quadratic);
    return all;
  }

  const Linkage& linkage_;
  std::size_t drive_, kept_one_;
};

// The motion that all equations let be, as nearly as doubles have it.
Column<Fast> motion_at_rest(const Linkage& linkage, const Column<Fast>& q) {
  const Eigen::VectorXd n =
      Eigen::JacobiSVD<Eigen::MatrixXd>(matrix(equations(linkage, q)), Eigen::ComputeFullV).matrixV().rightCols(1);
  return {n.data(), n.data() + n.size()};
}

}  // namespace

template <class T>
std::vector<LinkState<T>> solve_dead_point(const Linkage& linkage, int drive, const Beginning<T>& beginning) {
  Column<T> start = moving_links(linkage, beginning);
  Column<Fast> place;
  for (const T& x : start) place.push_back(near(x));
  const Column<Fast> motion = motion_at_rest(linkage, place);
  const auto kept =
      std::max_element(motion.begin(), motion.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (const double rate : motion) start.push_back(from_rational<T>(Rational(rate / *kept)));
  const AtDeadPoint<T> system(linkage, drive, static_cast<std::size_t>(kept - motion.begin()));
  const Column<T> last = refined<T>(system, start);
  const Preconditioner<T> Y(system(last));
  const Column<T> box = proved_box<T>(system, Y, last, std::vector<bool>(last.size()));
  demand_regular(Y, system(box));
  const auto half = static_cast<std::ptrdiff_t>(box.size() / 2);
  std::vector<LinkState<T>> links =
      moving(Column<T>(box.begin(), box.begin() + half), Column<T>(box.begin() + half, box.end()));
  if (Sides<T>(linkage, links, all_links(linkage)).are_as_meant() == Truth::no)
    throw Undecided("the iteration came to the place of a joint on the other side than was said",
                    "l'iterazione è arrivata al posto di un nodo dalla parte opposta a quella detta");
  return links;
}
template std::vector<LinkState<Deep>> solve_dead_point<Deep>(const Linkage&, int, const Beginning<Deep>&);

template <class T>
T place_of_drive(const Linkage& linkage, int drive, const std::vector<LinkState<T>>& links) {
  const Drive& of = linkage.drives[static_cast<std::size_t>(drive)];
  const auto state = [&](int link) -> const LinkState<T>& { return links[static_cast<std::size_t>(link)]; };
  const auto at = [&](int point) {
    const int link = linkage.links_at(point).front();
    return point_of(state(link), linkage.place(link, point)).z;
  };
  if (const auto* turned = std::get_if<TurnedLink>(&of)) return state(turned->link).theta;
  if (const auto* cylinder = std::get_if<Stretched>(&of)) return modulus(at(cylinder->to) - at(cylinder->from));
  const auto& slid = std::get<SlidPoint>(of);
  const LinkLine& guide = linkage.line(slid.guide);
  const LinkState<T>& body = state(linkage.link_of_line(slid.guide));
  return dot(direction(guide, body), at(slid.point) - point_of(body, guide.through).z);
}
template Deep place_of_drive<Deep>(const Linkage&, int, const std::vector<LinkState<Deep>>&);

}  // namespace epure::geometry::analytic
