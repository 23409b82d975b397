// What is drawn of an instant: the construction run on Deep, then rounded once.
#include "exercises/kit/panels/rounded.h"

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/cycloid-involute/figure.h"
#include "exercises/kit/panels/curve.h"
#include "geometry/numbers/enclosure.h"

namespace epure::cycloid_involute {
namespace {

using geometry::Deep;
using Instant = geometry::RollingInstant<Deep>;
using Contact = geometry::Point<Deep>;

// Where M stands on the sheet that shows the contact there.
DrawnInstant drawn(const Instant& at, const Contact& contact, const InstantNames& names) {
  const auto placed = [&](const geometry::Point<Deep>& X) { return to_double(contact + (X - at.motion.A)); };
  const auto sides = at.tangential_component();
  DrawnInstant figure{.names = names,
                      .P0 = to_double(contact),
                      .M = placed(at.M),
                      .J = placed(at.J),
                      .M_prime = placed(at.M_prime()),
                      .centre = placed(geometry::finite(at.centre_of_curvature())),
                      .v = to_double(at.velocity()),
                      .a = to_double(at.acceleration()),
                      .a_n = to_double(at.normal_acceleration()),
                      .a_t = to_double(at.tangential_acceleration()),
                      .along_before = to_double(sides.before),
                      .along_after = to_double(sides.after),
                      .rho = to_double(at.radius_of_curvature()),
                      .is_at_cusp = at.is_at_cusp};
  return figure;
}

double seconds(const Deep& phi, const Angle& omega) {
  return to_double(geometry::quotient(phi, geometry::radians<Deep>(omega)));
}

// The start of the arch in which the wheel stands, so that the figure is the same in every arch.
Contact within_arch(const Deep& phi, const Rational& arches, const Rational& r) {
  const Deep since_cusp = phi - geometry::radians<Deep>(Angle{arches});
  return {geometry::from_rational<Deep>(r) * since_cusp, Deep(0)};
}

}  // namespace

DrawnInstant drawn_at_phi(const Problem& of) {
  return deeply([&] {
    const Deep omega = geometry::radians<Deep>(of.omega_1), phi = geometry::radians<Deep>(of.phi);
    const Rational arches = geometry::whole_turns(of.phi);
    DrawnInstant figure = drawn(geometry::rolling_instant<Deep>(of.wheel(), of.phi, omega, Deep(0)),
                                within_arch(phi, arches, of.r), at_phi);
    figure.phi = to_double(phi);
    figure.t = seconds(phi, of.omega_1);
    figure.s = to_double(geometry::arc_length<Deep>(of.wheel(), of.phi));
    figure.is_first_arch = arches == 0;
    return figure;
  });
}

DrawnInstant drawn_at_s(const Problem& of) {
  return deeply([&] {
    const geometry::CycloidArc arc = of.travelled();
    const Deep phi = geometry::turned_angle<Deep>(arc);
    DrawnInstant figure = drawn(geometry::rolling_instant<Deep>(arc, geometry::radians<Deep>(of.omega_1)),
                                within_arch(phi, arc.arches(), of.r), at_s);
    figure.phi = to_double(phi);
    figure.t = seconds(phi, of.omega_1);
    figure.s = to_double(geometry::from_rational<Deep>(of.s));
    figure.is_first_arch = arc.arches() == 0;
    return figure;
  });
}

DrawnInstant drawn_on_involute(const Problem& of, const Angle& phi, const InstantNames& names) {
  return deeply([&] {
    DrawnInstant figure =
        drawn(geometry::rolling_instant<Deep>(of.line(), phi, geometry::radians<Deep>(of.omega_2), Deep(0)),
              geometry::contact_point<Deep>(of.line(), phi), names);
    figure.phi = to_double(geometry::radians<Deep>(phi));
    figure.t = to_double(geometry::quotient_of<Deep>(phi, of.omega_2));
    figure.s = to_double(geometry::arc_length<Deep>(of.line(), phi));
    return figure;
  });
}

double draw_path(Plot& plot, const geometry::Rolling& rolling, double from, double to, const std::string& name) {
  const double tolerance = curve_tolerance_mm / plot.scale().mm_per_unit;
  const geometry::Arithmetic<geometry::Bounded> scope;
  const geometry::SpanTrace span = geometry::trace_span(geometry::Roulette{rolling}, from, to, tolerance);
  drawings::Path path{plot.at(span.arcs.front().start), {}, false};
  for (const geometry::BezierArc& arc : span.arcs)
    path.pieces.push_back({false, plot.at(arc.first_control), plot.at(arc.second_control), plot.at(arc.end)});
  plot.mark(drawings::Line{path, Meaning::locus, name});
  return span.deviation * plot.scale().mm_per_unit;
}

}  // namespace epure::cycloid_involute
