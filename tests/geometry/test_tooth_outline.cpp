// Tooth outlines against points computed apart (tests/corpus/make_tooth_outlines.py), and against the rack rolled
// past them.
#include "geometry/curves/span.h"
#include "geometry/gears/tooth_form.h"
#include "geometry/gears/tooth_outline.h"
#include "geometry/numbers/enclosure.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace epure::geometry;
using epure::tests::CorpusCase;
using epure::tests::read_corpus;

namespace {

using Kind = OutlinePiece::Kind;
using Place = Point<double>;

const std::vector<CorpusCase>& cases() {
  static const std::vector<CorpusCase> read = read_corpus(EPURE_CORPUS "/tooth_outlines.txt");
  return read;
}

bool is_ring(const CorpusCase& c) { return c.choices.at("body") == "ring"; }
int wheel_of(const CorpusCase& c) { return is_ring(c) ? 2 : 1; }

// The wheel of the case with a mate that leaves its pitch circle the reference circle.
PairData pair_of(const CorpusCase& c) {
  PairData pair;
  const auto whole = [](const Rational& z) { return std::lround(CGAL::to_double(z)); };
  pair.m = c.givens.at("m");
  pair.alpha = Angle{c.givens.at("alpha")};
  pair.ha = c.givens.at("ha");
  pair.hf = c.givens.at("hf");
  pair.rho = c.givens.at("rho");
  pair.j = c.givens.at("j");
  const Rational x = c.givens.at("x");
  const long z = whole(c.givens.at("z"));
  if (is_ring(c)) {
    pair.kind = PairKind::internal;
    pair.z1 = z - 10, pair.z2 = z, pair.x1 = x, pair.x2 = x;
  } else {
    pair.z1 = z, pair.z2 = 40, pair.x1 = x, pair.x2 = -x;
  }
  return pair;
}

double value(const CorpusCase& c, const std::string& name) {
  const std::string text = c.reference(name);
  REQUIRE(!text.empty());
  return std::stod(text);
}

Place on_arc(const BezierArc& a, double s) {
  const double r = 1 - s;
  const auto mix = [&](double p, double q, double u, double v) {
    return r * r * r * p + 3 * r * r * s * q + 3 * r * s * s * u + s * s * s * v;
  };
  return {mix(a.start.x, a.first_control.x, a.second_control.x, a.end.x),
          mix(a.start.y, a.first_control.y, a.second_control.y, a.end.y)};
}

double apart(const Place& P, const Place& Q) { return std::hypot(P.x - Q.x, P.y - Q.y); }

// By thirds about the nearest of a few points of each arc.
double distance_to(const ToothOutline& outline, const Place& P) {
  double least = std::numeric_limits<double>::infinity();
  for (const OutlinePiece& piece : outline.pieces)
    for (const BezierArc& arc : piece.arcs)
      for (int k = 0; k < 4; ++k) {
        double from = k / 4.0, to = (k + 1) / 4.0;
        for (int step = 0; step < 60; ++step) {
          const double third = (to - from) / 3;
          if (apart(on_arc(arc, from + third), P) < apart(on_arc(arc, to - third), P))
            to -= third;
          else
            from += third;
        }
        least = std::min(least, apart(on_arc(arc, from), P));
      }
  return least;
}

// Doubles: a few operations on lengths of at most 5 m.
constexpr double noise = 1e-14;

template <class Take>
void for_right_half(const ToothOutline& outline, const Take& take) {
  for (const OutlinePiece& piece : outline.pieces) {
    if (piece.kind == Kind::tip) return;
    for (const BezierArc& arc : piece.arcs) {
      if (arc.start.x <= 0 || arc.end.x < 0) return;
      take(piece.kind, arc);
    }
  }
}

// The end of the rack's tooth, one side of it: the rounding's centre c beside and d below the pitch point, and alpha.
struct Rack {
  double c, d, rho, alpha;
  // Of a point beside and above the pitch point when the tooth's middle is there; negative inside the rack.
  double distance(double beside, double above) const {
    const double x = std::fabs(beside) - c, y = above + d;
    if (x <= 0) return -y - rho;
    if (x * std::sin(alpha) + y * std::cos(alpha) >= 0) return x * std::cos(alpha) - y * std::sin(alpha) - rho;
    return std::hypot(x, y) - rho;
  }
};

// How far the rack comes to a point of the right half of a tooth while it rolls on the circle r.
double rolled_past(const Rack& rack, double r, double z, const Place& P) {
  const double turn = -M_PI / z;  // to the middle of the space, left for right
  const Place Q{-P.x * std::cos(turn) - P.y * std::sin(turn), -P.x * std::sin(turn) + P.y * std::cos(turn)};
  const auto at = [&](double phi) {
    const double x = Q.x * std::cos(phi) + Q.y * std::sin(phi), y = -Q.x * std::sin(phi) + Q.y * std::cos(phi);
    return rack.distance(x - r * phi, y - r);
  };
  const double reach = std::min(2.5, 40 / z), step = reach / 400;
  double best = -reach;
  for (double phi = -reach; phi <= reach; phi += step)
    if (at(phi) < at(best)) best = phi;
  double from = best - step, to = best + step;
  for (int k = 0; k < 90; ++k) {
    const double third = (to - from) / 3;
    if (at(from + third) < at(to - third))
      to -= third;
    else
      from += third;
  }
  return at(from);
}

}  // namespace

TEST_CASE("tooth form: where the flank begins and where it meets the root", "[gears]") {
  for (const CorpusCase& c : cases()) {
    INFO(c.name << ": " << c.why);
    const Arithmetic<Bounded> scope;
    const Arithmetic<Deep> deep_scope(128);
    const ToothForm<Deep> form = tooth_form(pair_of(c), wheel_of(c), 0);
    const double half_angle = value(c, "half_angle"), form_radius_there = value(c, "form_radius");
    CHECK(std::fabs(enclosure(form.flank.half_angle).value - half_angle) <= 2e-16 * std::fabs(half_angle));
    // The crossing is enclosed between neighbouring doubles of its parameter, of the size of 1; the radius changes
    // with it by less than twice the centre's depth.
    const Enclosure radius = enclosure(form_radius(form));
    CHECK(std::fabs(radius.value - form_radius_there) <= 1e-16 + 3e-16 * form_radius_there);
    CHECK(radius.upper - radius.lower <= 1e-16 + 4e-16 * form_radius_there);
  }
}

TEST_CASE("tooth outline: points of fillet and flank lie on the drawing", "[gears]") {
  const double tolerance = GENERATE(1e-6, 1e-9);
  for (const CorpusCase& c : cases()) {
    const ToothOutline outline = tooth_outline(pair_of(c), wheel_of(c), tolerance);
    CHECK(outline.deviation <= tolerance);
    for (const std::string curve : {"fillet_", "flank_"})
      for (int k = 0; k < 7; ++k) {
        const std::string name = curve + std::to_string(k);
        INFO(c.name << " " << name << ": " << c.why);
        const Place P{value(c, name + "_x"), value(c, name + "_y")};
        // Where an undercut root crosses the flank or flank meets tip there is a corner: drawn, it lies farther off
        // by the tolerance halved over the sine of half its angle, of which none here is below 30 degrees.
        CHECK(distance_to(outline, P) <= (k == 6 || (k == 0 && curve == "flank_") ? 2 : 1) * tolerance + noise);
        CHECK(distance_to(outline, P) > 0);
      }
  }
}

TEST_CASE("tooth outline: a drawn flank lies inside the tooth, by the half angle of the involute through its points",
          "[gears]") {
  const double tolerance = GENERATE(1e-6, 1e-7, 1e-10);
  for (const CorpusCase& c : cases()) {
    INFO(c.name << ": " << c.why);
    const PairData pair = pair_of(c);
    const ToothOutline outline = tooth_outline(pair, wheel_of(c), tolerance);
    const double z = CGAL::to_double(c.givens.at("z")), m = CGAL::to_double(c.givens.at("m"));
    const double r_b = m * z / 2 * std::cos(2 * M_PI * CGAL::to_double(c.givens.at("alpha")));
    double least = 1, most = -1;
    for_right_half(outline, [&](Kind kind, const BezierArc& arc) {
      if (kind != Kind::flank) return;
      for (int k = 0; k <= 200; ++k) {
        const Place Q = on_arc(arc, k / 200.0);
        const double squared = (std::hypot(Q.x, Q.y) - r_b) * (std::hypot(Q.x, Q.y) + r_b);
        if (squared < 0) continue;
        const double t = std::sqrt(squared) / r_b, inv = t - std::atan(t);
        const double half = std::atan2(Q.x, Q.y) + (is_ring(c) ? -inv : inv);
        least = std::min(least, r_b * (value(c, "half_angle") - half));
        most = std::max(most, r_b * (value(c, "half_angle") - half));
      }
    });
    CHECK(least >= 0 - noise);
    CHECK(most <= tolerance + noise);
    CHECK(most > least);
  }
}

TEST_CASE("tooth outline: the rack that rolls past comes as near as the tolerance, and never into the tooth",
          "[gears]") {
  const double tolerance = 1e-6;
  for (const CorpusCase& c : cases()) {
    if (is_ring(c)) continue;
    INFO(c.name << ": " << c.why);
    const auto given = [&](const std::string& name) { return CGAL::to_double(c.givens.at(name)); };
    const double m = given("m"), z = given("z"), alpha = 2 * M_PI * given("alpha"), rho = given("rho") * m;
    const double below = (given("hf") - given("rho")) * m;
    const Rack rack{M_PI * m / 4 + given("j") / 4 - below * std::tan(alpha) - rho / std::cos(alpha),
                    below - given("x") * m, rho, alpha};
    double least = 1, most = -1;
    for_right_half(tooth_outline(pair_of(c), 1, tolerance), [&](Kind, const BezierArc& arc) {
      for (const double s : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
        const double distance = rolled_past(rack, m * z / 2, z, on_arc(arc, s));
        least = std::min(least, distance);
        most = std::max(most, distance);
      }
    });
    CHECK(least >= -1e-12);
    CHECK(most <= tolerance + 1e-12);
  }
}

TEST_CASE("tooth outline: pieces join, left mirrors right, copies join up", "[gears]") {
  for (const CorpusCase& c : cases()) {
    INFO(c.name);
    const ToothOutline outline = tooth_outline(pair_of(c), wheel_of(c), 1e-6);
    std::vector<BezierArc> arcs;
    std::string kinds;
    for (const OutlinePiece& piece : outline.pieces) {
      REQUIRE(!piece.arcs.empty());
      kinds += "RFLT"[static_cast<int>(piece.kind)];
      arcs.insert(arcs.end(), piece.arcs.begin(), piece.arcs.end());
    }
    CHECK(kinds == "RFLTLFR");
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const BezierArc &a = arcs[i], &mirror = arcs[arcs.size() - 1 - i];
      CHECK(a.start.y == mirror.end.y);
      CHECK(a.start.x == -mirror.end.x);
      if (i + 1 < arcs.size()) CHECK(apart(a.end, arcs[i + 1].start) == 0);
    }
    const double half_pitch = M_PI / CGAL::to_double(c.givens.at("z"));
    const Place start = arcs.front().start;
    CHECK(std::fabs(std::atan2(start.x, start.y) - half_pitch) <= 1e-15);
  }
}

TEST_CASE("tooth outline: a rack", "[gears]") {
  PairData pair;
  pair.kind = PairKind::rack;
  pair.z1 = 20;
  pair.m = {1, 100};
  pair.alpha = Angle{Rational(11, 180)};
  const double tolerance = 1e-9;
  const ToothOutline outline = tooth_outline(pair, 2, tolerance);
  REQUIRE(outline.pieces.size() == 7);
  const auto start = [&](std::size_t k) { return outline.pieces[k].arcs.front().start; };
  // mpmath: half the pitch; half the root's flat, 0.01 (π/4 - tan α - 0.25/cos α), from there; half the tip's width,
  // 0.01 (π/4 - tan α).
  CHECK(std::fabs(start(0).x - 0.015707963267948966) <= 1e-17);
  CHECK(std::fabs(start(0).y - 0.0125) <= tolerance);
  CHECK(std::fabs(start(1).x - (0.015707963267948966 - 0.00111738251892896)) <= tolerance);
  CHECK(std::fabs(start(3).x - 0.00381371937562291) <= tolerance);
  CHECK(std::fabs(start(3).y + 0.01) <= tolerance);
  CHECK(outline.pieces[2].arcs.size() == 1);
  pair.j = {1, 5000};  // thinner by 0.05 mm on each side
  CHECK(std::fabs(tooth_outline(pair, 2, tolerance).pieces[3].arcs.front().start.x - 0.00376371937562291) <=
        tolerance);
}

TEST_CASE("tooth outline: a pointed tooth ends where its flanks meet", "[gears]") {
  PairData pair = pair_of(cases().front());
  pair.x1 = {6, 5};
  const ToothOutline outline = tooth_outline(pair, 1, 1e-9);
  REQUIRE(outline.pieces.size() == 6);
  const Place tip = outline.pieces[2].arcs.back().end;
  CHECK(tip.x == 0);
  // mpmath: the radius at which inv α_ρ is the half angle. The flanks set back by half a nanometre meet lower by that
  // over the sine of half their angle there, 40 degrees.
  CHECK(std::fabs(tip.y - 0.121911956568898) <= 2e-9);
}

TEST_CASE("tooth outline: a ring's space ends where its flanks meet before the root circle", "[gears]") {
  PairData pair = pair_of(cases().front());
  pair.kind = PairKind::internal;
  pair.z1 = 16, pair.z2 = 41;
  pair.alpha = Angle{Rational(3, 40)};
  pair.x1 = {-1, 10}, pair.x2 = {3, 5};
  pair.hf = {7, 5};
  const ToothOutline outline = tooth_outline(pair, 2, 1e-9);
  REQUIRE(outline.pieces.size() == 3);
  const Place end = outline.pieces.front().arcs.front().start;
  CHECK(std::fabs(std::atan2(end.x, end.y) - M_PI / 41) <= 1e-15);
  // mpmath: the radius at which inv α_ρ + half angle is half a pitch. Set back by half a nanometre: as for the tip.
  CHECK(std::fabs(std::hypot(end.x, end.y) - 0.22367087355570781) <= 2e-9);
}

TEST_CASE("tooth outline: a flank takes few arcs", "[gears]") {
  // The source's driving wheel, 10 mm. Plain Hermite arcs in the roll angle, and uniform sampling, for comparison.
  const CorpusCase& c = cases().front();
  const auto arcs_of = [&](double tolerance) {
    return tooth_outline(pair_of(c), 1, tolerance).pieces[2].arcs.size();
  };
  CHECK(arcs_of(1e-6) == 1);
  CHECK(arcs_of(1e-7) == 2);
  CHECK(arcs_of(1e-9) <= 4);
}

TEST_CASE("tooth outline: undercut may leave next to nothing of a flank", "[gears]") {
  PairData pair = pair_of(cases().front());
  pair.kind = PairKind::rack;
  pair.z1 = 6, pair.x1 = {-3, 5}, pair.alpha = Angle{Rational(17, 360)};
  pair.rho = {3, 10}, pair.hf = {11, 10}, pair.ha = {7, 10}, pair.j = {1, 5000};
  for (const double tolerance : {1e-6, 1e-7, 1e-9}) CHECK(tooth_outline(pair, 1, tolerance).pieces.size() == 7);
}

TEST_CASE("tooth outline: what does not exist is said", "[gears]") {
  const PairData fine = pair_of(cases().front());
  const auto changed = [&](const auto& change) {
    PairData pair = fine;
    change(pair);
    return pair;
  };
  const double tolerance = 1e-6;
  CHECK_THROWS_AS(tooth_outline(changed([](PairData& p) { p.hf = 2; }), 1, tolerance), Impossible);  // pointed cutter
  CHECK_THROWS_AS(tooth_outline(changed([](PairData& p) { p.ha = -1; }), 1, tolerance),
                  Impossible);                                                                       // below the base
  CHECK_THROWS_AS(tooth_outline(changed([](PairData& p) { p.z1 = 2; }), 1, tolerance), Impossible);  // no root
  // A rounding that does not fit is drawn as large as fits.
  CHECK_NOTHROW(tooth_outline(changed([](PairData& p) { p.rho = {1, 2}; }), 1, tolerance));
  CHECK_NOTHROW(tooth_outline(changed([](PairData& p) { p.rho = 0; }), 1, tolerance));
  // Exactly at the limit of undercut: 30 degrees, 8 teeth, a straight edge as deep as the module.
  const auto at_limit = [](PairData& p) {
    p.alpha = Angle{Rational(1, 12)}, p.z1 = 8, p.hf = {11, 10}, p.rho = {1, 5};
  };
  for (const double fine_tolerance : {1e-6, 1e-8, 1e-11})
    CHECK_NOTHROW(tooth_outline(changed(at_limit), 1, fine_tolerance));
}
