// What is left of the path of contact, against flanks computed apart (tests/corpus/make_tooth_outlines.py).
#include "geometry/gears/contact_path.h"
#include "geometry/gears/faults.h"
#include "geometry/numbers/enclosure.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

#include <cmath>

using namespace epure::geometry;
using epure::tests::CorpusCase;

namespace {

using By = EndOfContact::By;

// Wheel 1, no ring, of a case of the corpus, with a mate whose tips reach as deep as the rack's.
PairData against_rack(const CorpusCase& c) {
  PairData pair{.kind = PairKind::rack};
  pair.z1 = std::lround(CGAL::to_double(c.givens.at("z")));
  pair.m = c.givens.at("m");
  pair.alpha = Angle{c.givens.at("alpha")};
  pair.x1 = c.givens.at("x");
  pair.ha = c.givens.at("ha");
  pair.hf = c.givens.at("hf");
  pair.rho = c.givens.at("rho");
  pair.j = c.givens.at("j");
  return pair;
}

PairData source() {
  PairData pair{.kind = PairKind::external};
  pair.z1 = 20, pair.z2 = 40, pair.m = {1, 100}, pair.alpha = Angle{{11, 180}};
  return pair;
}

double radius_on_wheel_1(const GearPair<Deep>& pair, const Deep& xi) {
  return enclosure(root(square(pair.wheel1.r_b) + square(xi - pair.position(pair.T1)))).value;
}

}  // namespace

TEST_CASE("contact path: it begins where the cutter left the flank, or at the tip of the mate", "[gears]") {
  const Arithmetic<Bounded> scope;
  const Arithmetic<Deep> deep_scope(128);
  int cut = 0, whole = 0;
  for (const CorpusCase& c : epure::tests::read_corpus(EPURE_CORPUS "/tooth_outlines.txt")) {
    if (c.choices.at("body") == "ring") continue;
    INFO(c.name << ": " << c.why);
    const GearPair<Deep> pair = gear_pair<Deep>(against_rack(c));
    const EndOfContact begins = contact_path(pair.given).begins;
    const double flank = std::stod(c.reference("form_radius")), radius = radius_on_wheel_1(pair, begins.xi);
    if (begins.by == By::root) {
      ++cut;
      CHECK(radius == Approx(flank).epsilon(1e-14));
      CHECK(sign(begins.xi - pair.position(pair.A())) == Sign::positive);
    } else {
      ++whole;
      CHECK(begins.by == By::tip);
      CHECK(radius >= flank * (1 - 1e-14));
      CHECK(enclosure(begins.xi).value == enclosure(pair.position(pair.A())).value);
    }
  }
  CHECK(cut >= 8);
  CHECK(whole >= 5);
}

TEST_CASE("contact path: undercut on either wheel shortens it from the other end", "[gears]") {
  const Arithmetic<Bounded> scope;
  const Arithmetic<Deep> deep_scope(128);
  // z1 = 8: the crossing solved apart with mpmath.
  PairData given = source();
  given.z1 = 8;
  const ContactPath path = contact_path(given);
  CHECK(path.begins.by == By::root);
  CHECK(enclosure(path.begins.xi).value == Approx(-9.32878893529e-3).epsilon(1e-11));
  CHECK(path.ends.by == By::tip);
  CHECK(enclosure(path.length()).value == Approx(27.878510344e-3).epsilon(1e-11));
  std::swap(given.z1, given.z2);
  const ContactPath turned = contact_path(given);
  CHECK(turned.begins.by == By::tip);
  CHECK(turned.ends.by == By::root);
  CHECK(enclosure(turned.ends.xi).value == Approx(9.32878893529e-3).epsilon(1e-11));
}

TEST_CASE("contact path: whole flanks keep all of AE, pointed teeth lose its end", "[gears]") {
  const Arithmetic<Bounded> scope;
  const Arithmetic<Deep> deep_scope(128);
  for (const PairKind kind : {PairKind::external, PairKind::internal, PairKind::rack}) {
    PairData given = source();
    given.kind = kind, given.z1 = 30, given.z2 = 200;
    const GearPair<Deep> pair = gear_pair<Deep>(given);
    const ContactPath path = contact_path(given);
    CHECK(path.begins.by == By::tip);
    CHECK(path.ends.by == By::tip);
    CHECK(enclosure(path.length()).value ==
          Approx(enclosure(pair.position(pair.E()) - pair.position(pair.A())).value).epsilon(1e-14));
  }
  // The tips of a ring reach deeper: below the flank of its pinion of 20 teeth.
  PairData ring = source();
  ring.kind = PairKind::internal, ring.z2 = 60;
  CHECK(contact_path(ring).begins.by == By::root);
  PairData pointed = source();
  pointed.z1 = 12, pointed.x1 = {9, 10}, pointed.alpha = Angle{{25, 360}};
  const ContactPath path = contact_path(pointed);
  CHECK(path.ends.by == By::point);
  CHECK(sign(gear_pair<Deep>(pointed).position(gear_pair<Deep>(pointed).E()) - path.ends.xi) == Sign::positive);
  // The rounding of a rack's roots as large as it is allowed to be ends the contact before E.
  PairData rounded = source();
  rounded.kind = PairKind::rack, rounded.z1 = 60, rounded.rho = {2, 5}, rounded.hf = 1;
  CHECK(contact_path(rounded).ends.by == By::root);
}

// The sheets rely on it: they do not look for the path of an external pair without fault.
TEST_CASE("contact path: what shortens the flanks of an external pair is a fault", "[gears]") {
  const Arithmetic<Bounded> scope;
  const Arithmetic<Deep> deep_scope(128);
  int sound = 0;
  for (const long z1 : {6, 10, 14, 17, 20, 30})
    for (const long z2 : {9, 18, 40, 200})
      for (const Rational& x1 : {Rational(0), Rational(3, 10), Rational(8, 10)})
        for (const Rational& rho : {Rational(0), Rational(1, 4), Rational(2, 5)}) {
          PairData given = source();
          given.z1 = z1, given.z2 = z2, given.x1 = x1, given.x2 = -x1 / 2, given.rho = rho;
          if (!faults(given).empty()) continue;
          ++sound;
          CAPTURE(z1, z2, enclosure(from_rational<Deep>(x1)).value, enclosure(from_rational<Deep>(rho)).value);
          const ContactPath path = contact_path(given);
          CHECK(path.begins.by == By::tip);
          CHECK(path.ends.by == By::tip);
        }
  CHECK(sound > 20);
}
