#include "geometry/gears/tooth_outline.h"

#include "geometry/curves/span.h"
#include "geometry/gears/flank_fit.h"
#include "geometry/gears/rack_form.h"
#include "geometry/gears/tooth_form.h"
#include "geometry/numbers/enclosure.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace epure::geometry {

namespace {

using Kind = OutlinePiece::Kind;

constexpr long bits_of_outline = 128;

// Of the half of the tolerance that is left to either side: the rest is for joining pieces whose ends differ by the
// rounding of doubles.
constexpr double share = 0.98;

double nearest(const Deep& x) { return enclosure(x).value; }

// A circle by the angle from +y, which begins at `from` and decreases.
struct Circular {
  Point<Bounded> centre;
  Bounded radius, from;
  template <class X>
  Point<X> operator()(const X& s) const {
    const X angle = X(from) - s;
    return {X(centre.x) + X(radius) * sine_of_angle(angle), X(centre.y) + X(radius) * cosine_of_angle(angle)};
  }
};
Circular about_origin(const Deep& radius, const Deep& from) { return {{0, 0}, to_bounded(radius), to_bounded(from)}; }

BezierArc reversed(const BezierArc& a) { return {a.end, a.second_control, a.first_control, a.start}; }
void reverse(std::vector<BezierArc>& arcs) {
  std::reverse(arcs.begin(), arcs.end());
  for (BezierArc& arc : arcs) arc = reversed(arc);
}
Point<double> mirrored(const Point<double>& P) { return {-P.x, P.y}; }
BezierArc mirrored(const BezierArc& a) {
  return {mirrored(a.start), mirrored(a.first_control), mirrored(a.second_control), mirrored(a.end)};
}
BezierArc straight(const Point<double>& P, const Point<double>& Q) {
  const double third = 1.0 / 3;
  const Vector<double> step = third * (Q - P);
  return {P, P + step, Q + -step, Q};
}

std::array<BezierArc, 2> halves(const BezierArc& a) {
  const Point<double> ab = midpoint(a.start, a.first_control), bc = midpoint(a.first_control, a.second_control),
                      cd = midpoint(a.second_control, a.end), abc = midpoint(ab, bc), bcd = midpoint(bc, cd),
                      on = midpoint(abc, bcd);
  return {BezierArc{a.start, ab, abc, on}, BezierArc{on, bcd, cd, a.end}};
}

// Whether an arc of the right half, its end apart, comes to the middle of the tooth.
bool reaches_middle(const BezierArc& arc) {
  if (!(arc.start.x > 0)) return true;
  if (arc.first_control.x > 0 && arc.second_control.x > 0) return false;
  const auto [first, second] = halves(arc);
  return reaches_middle(first) || reaches_middle(second);
}

// The right half of a tooth from the middle of the space, and its tip.
class HalfTooth {
 public:
  explicit HalfTooth(double tolerance) : band_(share * tolerance / 2) {}

  double band() const { return band_; }

  // Begins at the very double the piece before ends at. A piece without arcs is left out.
  void add(Kind kind, std::vector<BezierArc> arcs, double deviation) {
    if (arcs.empty()) return;
    if (!pieces_.empty()) arcs.front().start = pieces_.back().arcs.back().end;
    pieces_.push_back({kind, std::move(arcs)});
    deviation_ = std::max(deviation_, deviation);
  }
  // A curve that may have no length.
  template <class Curve>
  void add(Kind kind, const Curve& curve, double from, const Deep& last) {
    const double to = nearest(last);
    if (!(to > from)) return;
    SpanTrace traced = trace_span(curve, from, to, band_);
    add(kind, std::move(traced.arcs), traced.deviation);
  }

  // `tip` is the whole tip from right to left, without arcs for a pointed tooth: its flanks then end on the y axis.
  ToothOutline close(std::vector<BezierArc> tip, double tip_deviation, double tolerance) && {
    BezierArc& last = pieces_.back().arcs.back();
    if (tip.empty()) last.end.x = 0;
    ToothOutline whole;
    for (const OutlinePiece& piece : pieces_)
      for (const BezierArc& arc : piece.arcs)
        if (reaches_middle(arc))
          throw Impossible("the cutter cuts the tooth off at its root", "l'utensile taglia via il dente al piede");
    std::vector<OutlinePiece> left = pieces_;
    std::reverse(left.begin(), left.end());
    for (OutlinePiece& piece : left) {
      reverse(piece.arcs);
      for (BezierArc& arc : piece.arcs) arc = mirrored(arc);
    }
    if (!tip.empty()) {
      tip.front().start = last.end;
      tip.back().end = mirrored(last.end);
    }
    whole.deviation = tolerance / 2 + std::max(deviation_, tip_deviation) + (1 - share) * tolerance / 2;
    whole.pieces = std::move(pieces_);
    if (!tip.empty()) whole.pieces.push_back({Kind::tip, std::move(tip)});
    whole.pieces.insert(whole.pieces.end(), left.begin(), left.end());
    return whole;
  }

 private:
  double band_;
  double deviation_ = 0;
  std::vector<OutlinePiece> pieces_;
};

RightFlank<Bounded> rounded(const RightFlank<Deep>& flank) {
  return {to_bounded(flank.r_b), to_bounded(flank.half_angle), flank.ring};
}
RootCurve<Bounded> rounded(const RootCurve<Deep>& curve) {
  return {to_bounded(curve.r),
          to_bounded(curve.half_pitch),
          {to_bounded(curve.tip.c), to_bounded(curve.tip.d), to_bounded(curve.tip.rho)}};
}

void add_root(HalfTooth& half, const ToothForm<Deep>& form, const GeneratedRoot<Deep>& root) {
  const RootCurve<Deep>& curve = root.curve;
  half.add(Kind::root, about_origin(form.r_root, form.half_pitch), 0, quotient(curve.tip.c, curve.r));
  half.add(Kind::fillet, rounded(curve), 1, root.end);
}

void add_root(HalfTooth& half, const ToothForm<Deep>& form, const RoundedRoot<Deep>& root) {
  half.add(Kind::root, about_origin(form.r_root, form.half_pitch), 0, form.half_pitch - root.direction);
  half.add(Kind::fillet,
           Circular{{to_bounded(root.centre.x), to_bounded(root.centre.y)},
                    to_bounded(root.radius),
                    to_bounded(root.direction)},
           0, root.angle);
}

ToothOutline wheel_tooth(const ToothForm<Deep>& form, double tolerance) {
  HalfTooth half(tolerance);
  std::visit([&](const auto& root) { add_root(half, form, root); }, form.root);
  const double t_form = std::max(0.0, nearest(form.t_form)), t_tip = nearest(form.t_tip);
  FlankArcs flank = flank_arcs(rounded(form.flank), std::min(t_form, t_tip), std::max(t_form, t_tip), half.band());
  if (form.flank.ring) reverse(flank.arcs);
  half.add(Kind::flank, std::move(flank.arcs), flank.deviation);
  SpanTrace tip;
  if (const double length = nearest(Deep(2) * form.tip_half_angle); length > 0)
    tip = trace_span(about_origin(form.r_tip, form.tip_half_angle), 0, length, half.band());
  return std::move(half).close(std::move(tip.arcs), tip.deviation, tolerance);
}

ToothOutline rack_tooth(const RackForm<Deep>& form, double tolerance) {
  HalfTooth half(tolerance);
  const auto at = [](const Deep& x, const Deep& y) { return Point<double>{nearest(x), nearest(y)}; };
  const Circular rounding{
      {to_bounded(form.centre.x), to_bounded(form.centre.y)}, to_bounded(form.radius), Bounded(0)};
  if (const double flat = nearest(form.half_pitch - form.centre.x); flat > 0)
    half.add(Kind::root, {straight(at(form.half_pitch, form.root), at(form.centre.x, form.root))}, 0);
  half.add(Kind::fillet, rounding, 0, form.angle);
  half.add(Kind::flank,
           {straight(at(form.flank_start.x, form.flank_start.y), at(form.flank_end.x, form.flank_end.y))}, 0);
  std::vector<BezierArc> tip;
  if (const Point<double> corner = at(form.flank_end.x, form.flank_end.y); corner.x > 0)
    tip.push_back(straight(corner, mirrored(corner)));
  return std::move(half).close(std::move(tip), 0, tolerance);
}

}  // namespace

ToothOutline tooth_outline(const PairData& of, int wheel, double tolerance) {
  assert((wheel == 1 || wheel == 2) && "wheel 1 or 2");
  assert(tolerance > 0 && "a tolerance that is not positive");
  const Arithmetic<Bounded> scope;
  const Rational back = Rational(tolerance) / 2;
  return doubles_first(bits_of_outline, [&] {
    if (wheel == 2 && of.kind == PairKind::rack) return rack_tooth(rack_form<Deep>(of, back), tolerance);
    return wheel_tooth(tooth_form(of, wheel, back), tolerance);
  });
}

}  // namespace epure::geometry
