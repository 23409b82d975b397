// The joint B of the four-bar of docs/scenes/four-bar.yaml over a turn of its crank, by the solver of SolveSpace
// (which python-solvespace and pyslvs wrap), beside epure: what a position costs, and how far it is from the true
// one.
//
//   g++ -O2 -std=c++20 bench/beside/solvespace.cpp -lslvs -o /tmp/solvespace && /tmp/solvespace
//   time epure sweep docs/scenes/four-bar.yaml --over theta=0deg..360deg/3601 --quantity B_x > /dev/null
//
// Needs libslvs1-dev. Each position begins at the one before, as a sketch that is dragged does. B is held against two
// circles that meet, in long doubles.
#include <cstring>

#include <slvs.h>  // which uses memset

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

constexpr int positions = 3600;
constexpr double r = 120, l = 350, s = 280, d = 400;  // mm: A0A, AB, B0B, A0B0

struct Place {
  long double x, y;
};

// Left of the way from A to B0.
Place true_B(long double angle) {
  const Place A{r * std::cos(angle), r * std::sin(angle)};
  const long double dx = d - A.x, dy = -A.y, squared = dx * dx + dy * dy;
  const long double along = (squared + l * l - s * s) / (2 * squared);
  const long double aside = std::sqrt(l * l / squared - along * along);
  return {A.x + along * dx - aside * dy, A.y + along * dy + aside * dx};
}

// The plane, and in it the points with their two parameters each: what does not move in group 1, B in group 2.
class FourBar {
 public:
  FourBar() {
    for (const double of_plane : {0., 0., 0., 1., 0., 0., 0.}) add_parameter(1, of_plane);
    entities_.push_back(Slvs_MakePoint3d(origin, 1, 1, 2, 3));
    entities_.push_back(Slvs_MakeNormal3d(normal, 1, 4, 5, 6, 7));
    entities_.push_back(Slvs_MakeWorkplane(plane, 1, origin, normal));
    add_point(B0, 1, d, 0);
    add_point(A, 1, r, 0);
    const Place B_now = true_B(0);
    add_point(B, 2, static_cast<double>(B_now.x), static_cast<double>(B_now.y));
    add_distance(1, A, B, l);
    add_distance(2, B0, B, s);
  }

  // Whether it was found.
  bool turn_to(double angle) {
    parameters_[9].val = r * std::cos(angle);
    parameters_[10].val = r * std::sin(angle);
    Slvs_System system{};
    system.param = parameters_.data();
    system.params = static_cast<int>(parameters_.size());
    system.entity = entities_.data();
    system.entities = static_cast<int>(entities_.size());
    system.constraint = constraints_.data();
    system.constraints = static_cast<int>(constraints_.size());
    Slvs_Solve(&system, 2);
    return system.result == SLVS_RESULT_OKAY;
  }
  double B_x() const { return parameters_[11].val; }
  double B_y() const { return parameters_[12].val; }

 private:
  enum : Slvs_hEntity { origin = 100, normal, plane, B0, A, B };
  Slvs_hParam add_parameter(Slvs_hGroup group, double value) {
    const auto number = static_cast<Slvs_hParam>(parameters_.size() + 1);
    parameters_.push_back(Slvs_MakeParam(number, group, value));
    return number;
  }
  void add_point(Slvs_hEntity name, Slvs_hGroup group, double x, double y) {
    const Slvs_hParam u = add_parameter(group, x), v = add_parameter(group, y);
    entities_.push_back(Slvs_MakePoint2d(name, group, plane, u, v));
  }
  void add_distance(Slvs_hConstraint name, Slvs_hEntity P, Slvs_hEntity Q, double mm) {
    constraints_.push_back(Slvs_MakeConstraint(name, 2, SLVS_C_PT_PT_DISTANCE, plane, mm, P, Q, 0, 0));
  }

  std::vector<Slvs_Param> parameters_;
  std::vector<Slvs_Entity> entities_;
  std::vector<Slvs_Constraint> constraints_;
};

}  // namespace

int main() {
  FourBar four_bar;
  long double worst = 0;
  int failed = 0;
  double seconds = 0;
  for (int i = 0; i < positions; ++i) {
    const double angle = 2 * std::numbers::pi * i / positions;
    const auto begin = std::chrono::steady_clock::now();
    const bool is_found = four_bar.turn_to(angle);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!is_found) {
      ++failed;
      continue;
    }
    const Place B = true_B(angle);
    worst = std::max(worst, std::hypot(four_bar.B_x() - B.x, four_bar.B_y() - B.y));
  }
  std::printf("%.1f us a position, B at most %.1Le mm off, %d of %d not found\n", 1e6 * seconds / positions, worst,
              failed, positions);
}
