// The flanks mesh: over a whole cycle the drawn outlines never meet and are never farther apart than both tolerances.
#include "geometry/gears/faults.h"
#include "geometry/gears/mesh_check.h"
#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace epure::geometry;

namespace {

const Angle deg_22{Rational(11, 180)}, deg_30{Rational(1, 12)};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double horizon = 1e-3;

PairData external(long z1, long z2, Rational x1 = 0, Rational x2 = 0) {
  PairData pair;
  pair.z1 = z1, pair.z2 = z2;
  pair.m = {1, 100};
  pair.alpha = deg_22;
  pair.x1 = x1, pair.x2 = x2;
  return pair;
}
// With a cutter that is sharp enough for the ring's tips.
PairData internal(long z1, long z2) {
  PairData pair = external(z1, z2);
  pair.kind = PairKind::internal;
  pair.rho = {1, 10};
  return pair;
}
PairData rack(long z1, Rational x1 = 0) {
  PairData pair = external(z1, 0, x1);
  pair.kind = PairKind::rack;
  return pair;
}
PairData at_undercut_limit() {
  PairData pair = external(8, 20);
  pair.alpha = deg_30;
  pair.hf = {11, 10}, pair.rho = {1, 5};
  return pair;
}
PairData with_backlash(PairData pair) {
  pair.j = {1, 5000};
  return pair;
}

double base_pitch(const PairData& pair) {
  return M_PI * CGAL::to_double(pair.m) * std::cos(2 * M_PI * CGAL::to_double(pair.alpha.turns));
}

struct Worst {
  double low = infinity, high = 0;
  void cover(const ArcGap& gap) { low = std::min(low, gap.low), high = std::max(high, gap.high); }
};

// Over one base pitch.
Worst cycle(const PairData& pair, double tolerance, int positions, Flanks flanks) {
  const ToothOutline wheel1 = tooth_outline(pair, 1, tolerance), wheel2 = tooth_outline(pair, 2, tolerance);
  Worst worst;
  for (int k = 0; k < positions; ++k) {
    const double xi = base_pitch(pair) * (static_cast<double>(k) / positions - 0.5);
    worst.cover(mesh_gap(pair, wheel1, wheel2, mesh_angles(pair, xi), flanks, tolerance / 32, horizon));
  }
  return worst;
}

bool has(const PairData& pair, Fault::Kind kind) {
  const std::vector<Fault> all = faults(pair);
  return std::any_of(all.begin(), all.end(), [&](const Fault& fault) { return fault.kind == kind; });
}

}  // namespace

TEST_CASE("mesh angles: against values computed apart", "[gears]") {
  // mpmath, 30 digits: at ξ = 0 half a tooth stands between its flank and the line of centres, and the wheels turn by
  // ξ/r_b; with Σx != 0 by the involute function inverted.
  const MeshAngles source = mesh_angles(external(20, 40), 1e-3);
  CHECK(std::fabs(source.wheel1 - -0.0677544689129689965) <= 2e-17);
  CHECK(std::fabs(source.wheel2 - 3.09693007170653290576) <= 5e-16);
  const MeshAngles shifted = mesh_angles(external(20, 40, {1, 2}, {-3, 10}), -4e-3);
  CHECK(std::fabs(shifted.wheel1 - -0.13918900916637163052) <= 4e-17);
  CHECK(std::fabs(shifted.wheel2 - 3.13264734183323422276) <= 5e-16);
  const MeshCentres centres = mesh_centres(external(20, 40, {1, 2}, {-3, 10}));
  CHECK(std::fabs((centres.wheel2.y - centres.wheel1.y).inf() - 0.301961475048261695734) <= 2e-16);
  const MeshAngles ring = mesh_angles(internal(20, 60), 2e-3);
  CHECK(std::fabs(ring.wheel1 - -0.05696912148619316209) <= 2e-17);
  CHECK(std::fabs(ring.wheel2 - 0.03337017039776549994) <= 1e-17);
  const MeshAngles on_rack = mesh_angles(rack(20, {2, 5}), 3e-3);
  CHECK(std::fabs(on_rack.wheel1 - -0.06234482309282360010) <= 2e-17);
  CHECK(std::fabs(on_rack.wheel2 - -0.00947348095866660618) <= 4e-18);
}

TEST_CASE("mesh: over a cycle the outlines never meet and both flanks stay as near as the tolerances", "[gears]") {
  const double tolerance = 1e-6;
  const struct {
    std::string name;
    PairData pair;
  } pairs[] = {{"the source's", external(20, 40)},
               {"shifted", external(20, 40, {1, 2}, {-3, 10})},
               {"shifted, reference centre distance", external(20, 40, {3, 10}, {-3, 10})},
               {"shifted together", external(20, 40, {-1, 5}, {-1, 5})},
               {"near the limit of undercut: 15", external(15, 40)},
               {"14", external(14, 40)},
               {"13", external(13, 40)},
               {"exactly at it", at_undercut_limit()},
               {"1000 teeth", external(20, 1000)},
               {"ring", internal(20, 60)},
               {"ring, near in size", internal(17, 50)},
               {"rack", rack(20)},
               {"rack, shifted wheel", rack(20, {2, 5})}};
  for (const auto& [name, pair] : pairs) {
    INFO(name);
    const Worst all = cycle(pair, tolerance, 48, Flanks::all);
    CHECK(all.low > 0);
    CHECK(all.high <= 2 * tolerance);
    const Worst driving = cycle(pair, tolerance, 48, Flanks::driving);
    CHECK(driving.low > 0);
    CHECK(driving.high <= 2 * tolerance);
    const Worst coasting = cycle(pair, tolerance, 48, Flanks::coasting);
    CHECK(coasting.low > 0);
    CHECK(coasting.high <= 2 * tolerance);
  }
}

TEST_CASE("mesh: at a tolerance of a hundredth of a nanometre", "[gears]") {
  const double tolerance = 1e-11;
  for (const PairData& pair : {external(20, 40), external(20, 40, {1, 2}, {-3, 10}), internal(20, 60), rack(20)}) {
    const Worst all = cycle(pair, tolerance, 2, Flanks::all);
    CHECK(all.low > 0);
    CHECK(all.high <= 2 * tolerance);
  }
}

TEST_CASE("mesh: a billionth of a radian is seen, as overlap one way and as a gap the other way", "[gears]") {
  const double tolerance = 1e-11;
  for (const PairData& pair : {external(20, 40), internal(20, 60)}) {
    const ToothOutline wheel1 = tooth_outline(pair, 1, tolerance), wheel2 = tooth_outline(pair, 2, tolerance);
    MeshAngles angles = mesh_angles(pair, 1e-3);
    const auto driving = [&] {
      return mesh_gap(pair, wheel1, wheel2, angles, Flanks::driving, tolerance / 32, horizon);
    };
    angles.wheel1 += 1e-9;  // further the way it drives
    CHECK(driving().high <= 0);
    angles.wheel1 -= 2e-9;
    // r_b1 times the angle: 0.1 cos 22° 1e-9.
    CHECK(driving().low >= 0.0927e-9 - tolerance);
    CHECK(driving().high <= 0.0928e-9 + 2 * tolerance);
  }
}

TEST_CASE("mesh: backlash opens the other flanks by j cos α_w", "[gears]") {
  const double tolerance = 1e-6;
  // mpmath: 0.2 mm cos 22°.
  const double play = 0.000185436770913357480;
  for (const PairData& pair :
       {with_backlash(external(20, 40)), with_backlash(internal(20, 60)), with_backlash(rack(20))}) {
    const Worst driving = cycle(pair, tolerance, 12, Flanks::driving),
                coasting = cycle(pair, tolerance, 12, Flanks::coasting);
    CHECK(driving.low > 0);
    CHECK(driving.high <= 2 * tolerance);
    CHECK(coasting.low >= play);
    CHECK(coasting.high <= play + 2 * tolerance);
  }
}

TEST_CASE("mesh: undercut wheels of 5 to 10 teeth never overlap their mate", "[gears]") {
  const double tolerance = 1e-6;
  for (long z = 5; z <= 10; ++z) {
    INFO(z);
    CHECK(has(external(z, 40), Fault::Kind::undercut));
    CHECK(cycle(external(z, 40), tolerance, 16, Flanks::all).low > 0);
    CHECK(cycle(external(z, z), tolerance, 16, Flanks::all).low > 0);
  }
}

TEST_CASE("mesh: overlap is proved where a fault says so, and nowhere else", "[gears]") {
  const double tolerance = 1e-6;
  // The rounding of a cutter of the reference profile is left where the ring's tips pass.
  PairData pair = internal(20, 60);
  pair.rho = {1, 4};
  CHECK(has(pair, Fault::Kind::contact_on_fillet));
  CHECK(cycle(pair, tolerance, 16, Flanks::all).low == -infinity);
  pair.k = {1, 5};  // shorter tips
  CHECK(faults(pair).empty());
  CHECK(cycle(pair, tolerance, 16, Flanks::all).low > 0);
}

// Pairs in which contact ends on the flank and the tips clear the roots, found by drawing 4000 at random: the
// outlines say whether they overlap, the fault whether the corner's path crosses the root curve.
TEST_CASE("mesh: corners of tips in root curves", "[gears]") {
  const auto pair = [](long z1, long z2, const Angle& alpha, Rational x1, Rational x2) {
    PairData of = external(z1, z2, x1, x2);
    of.alpha = alpha;
    return of;
  };
  const Angle deg_15{Rational(1, 24)}, deg_20{Rational(1, 18)}, deg_25{Rational(5, 72)};
  PairData narrow = pair(21, 73, deg_20, {2, 5}, {1, 10});  // by 15 µm
  narrow.hf = {11, 10};
  PairData standard = pair(29, 62, deg_20, {4, 5}, 1);  // by 38 µm, with the clearance of ISO 53
  standard.rho = {3, 10};
  PairData second = pair(20, 38, deg_20, {1, 10}, {9, 10});  // wheel 1's tips in wheel 2
  second.hf = {11, 10};
  PairData with_play = pair(17, 58, deg_25, {3, 5}, {4, 5});
  with_play.ha = {4, 5}, with_play.hf = {9, 10}, with_play.rho = {1, 10}, with_play.j = {1, 5000};
  PairData pointed = pair(26, 22, deg_15, 0, {6, 5});
  pointed.ha = {6, 5}, pointed.hf = {29, 20};

  for (PairData of : {narrow, standard, second, with_play, pointed}) {
    INFO(of.z1 << " " << of.z2);
    CHECK(has(of, Fault::Kind::corner_in_root));
    CHECK(cycle(of, 1e-6, 24, Flanks::all).low == -infinity);
    of.hf += Rational(3, 20);  // deeper roots
    CHECK_FALSE(has(of, Fault::Kind::corner_in_root));
    CHECK(cycle(of, 1e-6, 24, Flanks::all).low > 0);
  }
}

TEST_CASE("arc gap: known distances", "[gears]") {
  const Arithmetic<Bounded> scope;
  const auto straight = [](double x1, double y1, double x2, double y2) {
    const auto at = [&](double s) {
      return Point<Bounded>{Bounded(x1 + s * (x2 - x1)), Bounded(y1 + s * (y2 - y1))};
    };
    return std::vector<EnclosedArc>{{at(0), at(0.25), at(0.75), at(1)}};
  };
  const auto one = straight(0, 0, 1, 0);
  const ArcGap apart = arc_gap(one, straight(0.5, 0.25, 2, 1.75), 1e-9, 10);
  CHECK(apart.low <= 0.25);
  CHECK(apart.high >= 0.25);
  CHECK(apart.high - apart.low <= 1e-9);
  const ArcGap crossing = arc_gap(one, straight(0.25, -1, 0.5, 1), 1e-9, 10);
  CHECK(crossing.low == -infinity);
  CHECK(crossing.high == 0);
  const ArcGap far = arc_gap(one, straight(0, 5, 1, 5), 1e-9, 2);
  CHECK(far.low == 2);
  CHECK(far.high == infinity);
  // They touch: neither apart nor crossing, and that is said.
  const ArcGap touching = arc_gap(one, straight(0.5, 0, 0.75, 1), 1e-9, 10);
  CHECK(touching.low == -infinity);
  CHECK(touching.high >= 0);
}
