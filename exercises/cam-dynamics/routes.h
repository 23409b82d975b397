// The cam by its routes: relative motion and polar diagrams, the equivalent slider-crank, poles; bodies cut free,
// virtual work; closed form; and the least acceleration over the turn by roots of a polynomial and by branch and
// bound.
#pragma once

#include <memory>

#include "exercises/cam-dynamics/cam.h"
#include "exercises/cam-dynamics/quantities.h"
#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "geometry/curves/follower_sweep.h"

namespace epure::cam_dynamics {

using geometry::quotient;
using geometry::square;
using geometry::Vector;

inline constexpr Phrase contact_is_lost{
    "contact is lost: the cam would have to pull the follower (P + P_3 + m_3 a_B3 < 0)",
    "il contatto si perde: la camma dovrebbe tirare il cedente (P + P_3 + m_3 a_B3 < 0)"};
inline constexpr Phrase never_lost{"contact is never lost there: the follower has no mass",
                                   "lì il contatto non si perde mai: il cedente non ha massa"};
inline constexpr Phrase pulled_off{"P and the weight together do not press: contact is lost at any speed",
                                   "P e il peso insieme non premono: il contatto si perde a qualsiasi velocità"};
inline constexpr Phrase cam_at_rest{"the cam rests: no angle needs more force than another",
                                    "la camma è ferma: nessun angolo richiede più forza di un altro"};
inline constexpr Phrase no_relative_pole{"P23 is at infinity", "P23 è all'infinito"};

template <class T>
T in_degrees(const T& radians) {
  return quotient(number<T>(180) * radians, geometry::pi<T>());
}
// The angle of a direction, in degrees; for signs the ordinate.
template <class T>
T degrees_of(const Vector<T>& v) {
  if constexpr (signs_only<T>) {
    return v.y;
  } else {
    return in_degrees<T>(geometry::arc_tangent(v.y, v.x));
  }
}
// Of the same angle twice that on the circumference: tan(α/2) = y/(x + |v|).
template <class T>
T degrees_by_half(const Vector<T>& v) {
  if constexpr (signs_only<T>) {
    return v.y;
  } else {
    return degrees_of<T>({v.x + geometry::length(v), v.y}) * T(2);
  }
}

class Routes {
 public:
  explicit Routes(const Cam& cam)
      : of(cam),
        rooted_(
            once([formulas = cam.formulas()] { return geometry::analytic::LeastFollowerAcceleration(formulas); })),
        swept_(once([f = cam.formulas()] { return geometry::FollowerSweep(f.r, f.l, f.e); })) {}

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    drawn_position(ledger);
    maximum_lift(ledger);
    cycle(ledger);
    return ledger;
  }

 private:
  template <class T>
  static Vector<T> upwards() {
    return {T(0), T(1)};
  }
  template <class T>
  T omega(const Angle& speed) const {
    return geometry::radians<T>(speed);
  }
  // P and the follower's weight together, which may just balance.
  template <class T>
  T load() const {
    return number<T>(Rational(of.P + of.m_3 * of.g));
  }
  template <class T>
  T weight(const Rational& m) const {
    return number<T>(Rational(m * of.g));
  }

  template <class T>
  struct Formulas {
    geometry::analytic::FollowerLift<T> lift;
    T r, l, c, s, omega;

    T sine_of_pressure() const { return quotient(lift.d, l); }
    T cosine_of_pressure() const { return quotient(lift.u, l); }
    // δ' = r sin θ/u: how fast AB turns clockwise, over ω.
    T turning() const { return quotient(r * s, lift.u); }
  };
  template <class T>
  Formulas<T> formulas(const T& c, const T& s, const T& at) const {
    return {geometry::analytic::follower_lift<T>(of.formulas(), c, s),
            number<T>(of.lengths.eccentricity),
            number<T>(of.lengths.reach()),
            c,
            s,
            at};
  }

  template <class T>
  void motion_of_polygon(Ledger<T>& ledger, const geometry::RollerCamMotion<T>& m) const {
    ledger.put_length(moving("v_B3"), m.v_B3);
    ledger.put_length(moving("a_B3"), m.a_B3);
    ledger.put(moving("a_B3").y(), m.a_B3.y);
    ledger.put_length(moving("a_B32_n"), m.normal);
  }

  template <class T>
  void drawn_position(Ledger<T>& ledger) const {
    const Vector<T> towards{geometry::cosine<T>(of.angle), geometry::sine<T>(of.angle)};
    const auto at = geometry::roller_cam<T>(of.lengths, towards, upwards<T>());
    const T w = omega<T>(of.omega);
    const auto motion = geometry::relative_motion(at, w);
    places(ledger, at);
    ledger.put(quantity("omega_2"), w);
    ledger.put(point("A"), at.A);
    ledger.put(quantity("B_y"), at.B.y);
    ledger.put(quantity("A0B"), [&] { return size(at.B - at.A0); });
    ledger.put(quantity("pressure_angle_deg"), [&] { return degrees_of<T>({at.AB().y, at.AB().x}); });
    ledger.put(contact(), at.contact(of.lengths));
    ledger.route("polar diagram");
    whole_motion(ledger, motion);
    ledger.route("equivalent mechanism");
    whole_motion(ledger, geometry::motion_by_equivalent(at, w));
    by_poles(ledger, at, w);
    by_free_bodies(ledger, at, motion);
    analysis(ledger, formulas<T>(towards.x, towards.y, w));
  }
  static PointQuantity contact() { return {"contact", {" of the contact", " del contatto"}, "C"}; }

  template <class T>
  void places(Ledger<T>& ledger, const geometry::RollerCam<T>& at) const {
    ledger.draws_point("A0", at.A0);
    ledger.draws_point("A_at", at.A);
    ledger.draws_point("B_at", at.B);
    ledger.draws_point("contact_at", at.contact(of.lengths));
  }

  template <class T>
  void whole_motion(Ledger<T>& ledger, const geometry::RollerCamMotion<T>& m) const {
    motion_of_polygon(ledger, m);
    ledger.put(moving("v_B2"), m.v_B2);
    ledger.put(moving("v_B32"), m.v_B32);
    ledger.put_length(moving("v_A"), m.v_A);
    ledger.put(moving("v_A").y(), m.v_A.y);
    ledger.put(moving("a_B2"), m.a_B2);
    ledger.put(moving("a_B32_t"), m.tangential);
    ledger.put(moving("a_coriolis"), m.coriolis);
    ledger.put_length(moving("a_G2"), m.a_A);
  }

  template <class T>
  void by_poles(Ledger<T>& ledger, const geometry::RollerCam<T>& at, const T& w) const {
    const auto pole = at.relative_pole();
    const auto P23_x = [&] { return Ledger<T>::ratio(pole.x, pole.w, no_relative_pole); };
    ledger.route("poles");
    ledger.put(quantity("P23_x"), P23_x);
    ledger.put(moving("v_B3").length(), [&] { return magnitude_of<T>(w * P23_x()); });
    ledger.draws_point("P23", pole, no_relative_pole);
    // The work of P, the weights and the force of inertia of the follower, for a unit turn of the cam.
    ledger.route("virtual work");
    ledger.put(quantity("M_m_virtual_work"), [&] {
      const auto equivalent = geometry::motion_by_equivalent(at, w);
      return weight<T>(of.m_2) * at.A.x + pressing(equivalent.a_B3.y) * P23_x();
    });
  }

  // What presses the follower on the cam. Throws Impossible where nothing does.
  template <class T>
  T pressing(const T& a_B3_y) const {
    const T force = load<T>() + number<T>(of.m_3) * a_B3_y;
    const geometry::Sign sign = geometry::sign(force);
    if (sign == geometry::Sign::negative) throw geometry::Impossible(contact_is_lost);
    if (sign == geometry::Sign::undecided)
      throw geometry::Undecided("whether follower and cam stay in contact", "se cedente e camma restino in contatto");
    return force;
  }

  template <class T>
  void put_if_pressed(Ledger<T>& ledger, const VectorQuantity& quantity,
                      const std::function<Vector<T>()>& find) const {
    ledger.put(quantity.x(), [=] { return find().x; });
    ledger.put(quantity.y(), [=] { return find().y; });
    ledger.put(quantity.length(), [=] { return size(find()); });
  }

  template <class T>
  void by_free_bodies(Ledger<T>& ledger, const geometry::RollerCam<T>& at,
                      const geometry::RollerCamMotion<T>& m) const {
    const T none(0);
    const Vector<T> level{T(1), none}, AB = at.AB();
    const Vector<T> P_2{none, -weight<T>(of.m_2)}, P_3{none, -weight<T>(of.m_3)}, loaded{none, -load<T>()};
    const Vector<T> F_2 = -(number<T>(of.m_2) * m.a_A), F_3 = -(number<T>(of.m_3) * m.a_B3);
    // P + P_3 + F_3 + x AB = y (1, 0), as if the cam could pull too.
    const auto [along_AB, along_x] = geometry::close_polygon(loaded + F_3, AB, level);
    const Vector<T> R_23 = along_AB * AB, R_13 = -(along_x * level), R_12 = -(P_2 + F_2 - R_23);
    const auto pressed = [=, this](const Vector<T>& force) -> std::function<Vector<T>()> {
      return [=, this] {
        pressing(m.a_B3.y);
        return force;
      };
    };
    ledger.route("free bodies");
    ledger.put_length(force("P_3"), P_3);
    ledger.put_length(force("P_2"), P_2);
    ledger.put_length(force("F_3_in"), F_3);
    ledger.put(force("F_3_in").y(), F_3.y);
    ledger.put(force("F_2_in"), F_2);
    ledger.put(force("R_13").x(), [=] { return pressed(R_13)().x; });
    ledger.put(force("R_13").length(), [=] { return size(pressed(R_13)()); });
    put_if_pressed<T>(ledger, force("R_23"), pressed(R_23));
    put_if_pressed<T>(ledger, force("R_12"), pressed(R_12));
    const geometry::Point<T> down{at.A.x, at.A.y - T(1)};
    ledger.put(quantity("d_2"), [&] { return arm(at.A0, at.A, down); });
    ledger.put(quantity("d_32"), [&] { return arm(at.A0, at.A, at.B); });
    ledger.put(quantity("M_m"), [&] {
      return -(geometry::cross(at.A - at.A0, P_2) + geometry::cross(at.A - at.A0, -pressed(R_23)()));
    });
    ledger.tells({"P_kept", "$\\it{P}_{0}$", "N", {}}, [&] { return (F_3 + P_3).y; });
    for (const auto& [name, v] : std::initializer_list<std::pair<const char*, Vector<T>>>{
             {"P", Vector<T>{none, -number<T>(of.P)}}, {"held_R_13", R_13}, {"held_R_23", R_23}, {"held_R_12", R_12}})
      ledger.draws_vector(name, v);
  }
  // Of the line XY about O, from the foot of its perpendicular.
  template <class T>
  static T arm(const geometry::Point<T>& O, const geometry::Point<T>& X, const geometry::Point<T>& Y) {
    return size(geometry::foot(O, geometry::line(X, Y)) - O);
  }

  template <class T>
  void analysis(Ledger<T>& ledger, const Formulas<T>& f) const {
    const auto& [d, u, y, y1, y2] = f.lift;
    const T w = f.omega, w2 = square(w), B_y = y, e = number<T>(of.offset);
    const T A_x = f.r * f.c, A_y = f.r * f.s, relative = -(T(1) + f.turning());  // of AB seen from the cam, over ω
    ledger.route("analytic");
    ledger.put(quantity("omega_2"), [&] { return turned_per_second<T>(of.omega); });
    ledger.put(point("A"), geometry::Point<T>{A_x, A_y});
    ledger.put(quantity("B_y"), B_y);
    ledger.put(quantity("A0B"), [&] { return size_by_cosines(f); });
    ledger.put(quantity("pressure_angle_deg"), [&] { return degrees_by_half<T>({f.lift.u, f.lift.d}); });
    const T rho = number<T>(of.lengths.roller);
    ledger.put(contact(), geometry::Point<T>{e - rho * f.sine_of_pressure(), B_y - rho * f.cosine_of_pressure()});
    ledger.put(quantity("P23_x"), y1);
    analysed_motion(ledger, f);
    ledger.put(moving("v_B2"), Vector<T>{-(w * B_y), w * e});
    ledger.put(moving("v_B32"), Vector<T>{-(w * relative) * u, (w * relative) * d});
    ledger.put(moving("v_A").length(), [&] { return magnitude_of<T>(w * f.r); });
    ledger.put(moving("v_A").y(), w * A_x);
    ledger.put(moving("a_B2"), Vector<T>{-(w2 * e), -(w2 * B_y)});
    const T growth = w2 * relative_growth(f);
    ledger.put(moving("a_B32_t"), Vector<T>{-(growth * u), growth * d});
    ledger.put(moving("a_coriolis"), Vector<T>{-(T(2) * w2 * relative) * d, -(T(2) * w2 * relative) * u});
    ledger.put(moving("a_G2").length(), w2 * f.r);
    analysed_forces(ledger, f);
    const T W_2 = weight<T>(of.m_2);
    const auto S = [&] { return pressing<T>(w2 * f.lift.y2); };
    ledger.put(quantity("d_2"), [&] { return magnitude_of<T>(A_x); });
    ledger.put(quantity("d_32"),
               [&] { return magnitude_of<T>(A_x * f.cosine_of_pressure() - A_y * f.sine_of_pressure()); });
    ledger.put(quantity("M_m"), [&] { return W_2 * A_x + S() * (A_x - A_y * quotient(f.lift.d, f.lift.u)); });
    ledger.put(quantity("M_m_virtual_work"), [&] { return W_2 * A_x + S() * f.lift.y1; });
  }

  // 2π n: by turns, where it is given in turns.
  template <class T>
  static T turned_per_second(const Angle& speed) {
    return T(2) * geometry::pi<T>() * number<T>(speed.turns) + number<T>(speed.radians);
  }
  // By the cosine rule, A₀B² = r² + l² + 2 r l cos(angle between A₀A and AB).
  template <class T>
  static T size_by_cosines(const Formulas<T>& f) {
    const T squared = square(f.r) + square(f.l) + T(2) * f.r * (f.c * f.lift.d + f.s * f.lift.u);
    if constexpr (signs_only<T>) {
      return squared;
    } else {
      return geometry::root(squared);
    }
  }
  // Of the relative turning of AB: -(r sin θ/u)' = -(r cos θ u² + r² sin² θ d)/u³.
  template <class T>
  static T relative_growth(const Formulas<T>& f) {
    const T u2 = square(f.lift.u);
    return -quotient(f.r * f.c * u2 + square(f.r * f.s) * f.lift.d, f.lift.u * u2);
  }

  template <class T>
  void analysed_motion(Ledger<T>& ledger, const Formulas<T>& f) const {
    const T w = f.omega, w2 = square(w);
    ledger.put(moving("v_B3").length(), [&] { return magnitude_of<T>(w * f.lift.y1); });
    ledger.put(moving("a_B3").length(), [&] { return magnitude_of<T>(w2 * f.lift.y2); });
    ledger.put(moving("a_B3").y(), w2 * f.lift.y2);
    ledger.put(moving("a_B32_n").length(), w2 * square(T(1) + f.turning()) * f.l);
  }

  template <class T>
  void analysed_forces(Ledger<T>& ledger, const Formulas<T>& f) const {
    const T w2 = square(f.omega), m_2 = number<T>(of.m_2), m_3 = number<T>(of.m_3), g = number<T>(of.g);
    const Vector<T> F_2{m_2 * w2 * f.r * f.c, m_2 * w2 * f.r * f.s};
    ledger.put(force("P_3").length(), m_3 * g);
    ledger.put(force("P_2").length(), m_2 * g);
    ledger.put(force("F_3_in").length(), [&] { return magnitude_of<T>(m_3 * w2 * f.lift.y2); });
    ledger.put(force("F_3_in").y(), -(m_3 * w2 * f.lift.y2));
    ledger.put(force("F_2_in").x(), F_2.x);
    ledger.put(force("F_2_in").y(), F_2.y);
    ledger.put(force("F_2_in").length(), m_2 * w2 * f.r);
    const T lean = quotient(f.lift.d, f.lift.u);  // tan δ
    const auto S = [=, this] { return pressing<T>(w2 * f.lift.y2); };
    ledger.put(force("R_13").x(), [=] { return -(lean * S()); });
    ledger.put(force("R_13").length(), [=] { return magnitude_of<T>(lean * S()); });
    ledger.put(force("R_23").x(), [=] { return lean * S(); });
    ledger.put(force("R_23").y(), S);
    ledger.put(force("R_23").length(), [=] { return magnitude_of<T>(quotient(S() * f.l, f.lift.u)); });
    ledger.put(force("R_12").x(), [=] { return lean * S() - F_2.x; });
    ledger.put(force("R_12").y(), [=] { return S() + m_2 * g - F_2.y; });
    ledger.put(force("R_12").length(), [=] { return size(Vector<T>{lean * S() - F_2.x, S() + m_2 * g - F_2.y}); });
  }

  // A between A₀ and B: the polygons' closing lines are parallel to what is known, so the follower's velocity is
  // zero.
  template <class T>
  void maximum_lift(Ledger<T>& ledger) const {
    const auto at = geometry::roller_cam_at<T>(geometry::DeadCentre::farthest, of.lengths, upwards<T>());
    const T w = omega<T>(of.fast), w2 = square(w);
    ledger.begin_case("maximum_lift.", {", at maximum lift", ", alla massima alzata"});
    ledger.route("construction");
    places(ledger, at);
    const T A0B = number<T>(Rational(of.lengths.eccentricity + of.lengths.reach()));
    ledger.put(quantity("omega_2"), w);
    ledger.put(quantity("angle_of_A0A_deg"), [&] { return degrees_of<T>(at.A - at.A0); });
    ledger.put(quantity("A0B"), [&] { return size(at.B - at.A0); });
    ledger.put(point("A"), at.A);
    ledger.put(quantity("B_y"), at.B.y);
    ledger.put(quantity("pressure_angle_deg"), [&] { return degrees_of<T>({at.AB().y, at.AB().x}); });
    lifted(ledger, "polar diagram", geometry::relative_motion(at, w));
    lifted(ledger, "equivalent mechanism", geometry::motion_by_equivalent(at, w));

    ledger.route("analytic");
    const T c = number<T>(Rational(of.offset / (of.lengths.eccentricity + of.lengths.reach())));
    const T s = geometry::root(T(1) - square(c)), r = number<T>(of.lengths.eccentricity),
            l = number<T>(of.lengths.reach());
    ledger.put(quantity("omega_2"), [&] { return turned_per_second<T>(of.fast); });
    ledger.put(quantity("angle_of_A0A_deg"), [&] { return degrees_by_half<T>({c, s}); });
    ledger.put(quantity("A0B"), A0B);
    ledger.put(point("A"), geometry::Point<T>{r * c, r * s});
    ledger.put(quantity("B_y"), A0B * s);
    ledger.put(quantity("pressure_angle_deg"), [&] { return degrees_by_half<T>({s, c}); });
    // y'' = -(r/sin θ)(1 + r/l) there, AB turns by r/l of the cam's turning, against it.
    const T back = T(1) + quotient(r, l), y2 = quotient(r * back, s), a = w2 * y2, m_3 = number<T>(of.m_3);
    ledger.put(moving("v_B3").length(), T(0));
    ledger.put(moving("v_B2").length(), [&] { return magnitude_of<T>(w * A0B); });
    ledger.put(moving("v_B32").length(), [&] { return magnitude_of<T>(w * back * l); });
    ledger.put(moving("a_B3").length(), a);
    ledger.put(moving("a_B3").y(), -a);
    ledger.put(moving("a_B2").length(), w2 * A0B);
    ledger.put(moving("a_B32_n").length(), w2 * square(back) * l);
    ledger.put(moving("a_coriolis").length(), T(2) * w2 * back * l);
    // r (1 + r/l) cot θ ω², which a_B3 has across AB.
    ledger.put(moving("a_B32_t").length(), [&] { return magnitude_of<T>(a * c); });
    ledger.put(force("P_3").length(), m_3 * number<T>(of.g));
    ledger.put(force("F_3_in").length(), m_3 * a);
    ledger.put(quantity("P_min"), m_3 * (a - number<T>(of.g)));
    ledger.put(quantity("omega_2_contact_loss"), [&] { return speed_of_loss<T>([&] { return y2; }); });
  }

  template <class T>
  void lifted(Ledger<T>& ledger, const std::string& route, geometry::RollerCamMotion<T> m) const {
    m.v_B3 = {T(0), T(0)};  // A₀, A and B are in line: v_B2 is across AB
    m.v_B32 = -m.v_B2;
    ledger.route(route);
    motion_of_polygon(ledger, m);
    ledger.put_length(moving("v_B2"), m.v_B2);
    ledger.put_length(moving("v_B32"), m.v_B32);
    ledger.put_length(moving("a_B2"), m.a_B2);
    ledger.put_length(moving("a_coriolis"), m.coriolis);
    ledger.put_length(moving("a_B32_t"), m.tangential);
    const Vector<T> P_3{T(0), -weight<T>(of.m_3)}, F_3 = -(number<T>(of.m_3) * m.a_B3);
    if (route != "polar diagram") return;
    ledger.route("free bodies");
    ledger.put_length(force("P_3"), P_3);
    ledger.put_length(force("F_3_in"), F_3);
    ledger.put(quantity("P_min"), (F_3 + P_3).y);
    // The source's: with the acceleration of the drawn position.
    ledger.tells({"F_3_drawn", "$\\it{F}^{in}_{3}$", "N", {}}, [&] { return drawn_inertia<T>(); });
    ledger.tells({"P_drawn", "$\\it{P}$", "N", {}}, [&] { return drawn_inertia<T>() + P_3.y; });
    // The force of inertia at 1 rad/s, as the square of the speed.
    ledger.put(quantity("omega_2_contact_loss"), [&] {
      const auto slow = geometry::relative_motion(
          geometry::roller_cam_at<T>(geometry::DeadCentre::farthest, of.lengths, upwards<T>()), T(1));
      return speed_of_loss<T>([&] { return T(-slow.a_B3.y); });
    });
  }

  template <class T>
  T drawn_inertia() const {
    const Vector<T> towards{geometry::cosine<T>(of.angle), geometry::sine<T>(of.angle)};
    const auto at = geometry::roller_cam<T>(of.lengths, towards, upwards<T>());
    return -(number<T>(of.m_3) * geometry::relative_motion(at, omega<T>(of.fast)).a_B3.y);
  }

  // ω² m_3 |y''| = P + P_3.
  template <class T, class Find>
  T speed_of_loss(const Find& curving) const {
    const Rational closing = of.P + of.m_3 * of.g;
    if (closing < 0 || (closing == 0 && of.m_3 == 0)) throw geometry::Impossible(pulled_off);
    if (of.m_3 == 0) throw geometry::Impossible(never_lost);
    const T squared = quotient(number<T>(Rational(closing / of.m_3)), curving());
    if constexpr (signs_only<T>) {
      return squared;
    } else {
      return geometry::root(squared);
    }
  }

  template <class T>
  void cycle(Ledger<T>& ledger) const {
    ledger.begin_case("cycle.", {", over the turn", ", nel giro"});
    constructed_cycle(ledger);
    analysed_cycle(ledger);
  }

  template <class T>
  T constructed_ordinate(const Angle& angle) const {
    return geometry::roller_cam<T>(of.lengths, {geometry::cosine<T>(angle), geometry::sine<T>(angle)}, upwards<T>())
        .B.y;
  }
  static Angle degrees(int n) { return {Rational(n, 360), 0}; }

  template <class T>
  void constructed_cycle(Ledger<T>& ledger) const {
    ledger.route("construction");
    const auto high = geometry::roller_cam_at<T>(geometry::DeadCentre::farthest, of.lengths, upwards<T>()),
               low = geometry::roller_cam_at<T>(geometry::DeadCentre::nearest, of.lengths, upwards<T>());
    const auto of_high = [&] { return degrees_of<T>(high.A - high.A0); };
    const auto of_low = [&] { return number<T>(180) + degrees_of<T>(low.A0 - low.A); };
    ledger.put(quantity("y_B_max"), high.B.y);
    ledger.put(quantity("y_B_min"), low.B.y);
    ledger.put(quantity("lift"), high.B.y - low.B.y);
    ledger.put(quantity("angle_at_max_lift_deg"), of_high);
    ledger.put(quantity("angle_at_min_lift_deg"), of_low);
    ledger.put(quantity("rise_angle_deg"), [&] { return number<T>(360) + of_high() - of_low(); });
    const auto pressure = [&](int at) {
      const auto there = geometry::roller_cam<T>(of.lengths, {T(at), T(0)}, upwards<T>());
      return degrees_of<T>({there.AB().y, there.AB().x});
    };
    ledger.put(quantity("pressure_angle_max_deg"), [&] { return pressure(-1); });
    ledger.put(quantity("pressure_angle_min_deg"), [&] { return pressure(1); });
    for (int n = 0; n < 360; n += 30)
      ledger.put(lift_at(n), [&] { return constructed_ordinate<T>(degrees(n)) - low.B.y; });
    inversion(ledger, low.B.y);
    least(ledger, "branch and bound", swept_);
  }

  // The cam held with A₀A along x, the frame turned back instead: where the follower's axis touches the circle of
  // radius |e| about A₀, and on it the roller's centre, now and where it would be at no lift.
  template <class T>
  void inversion(Ledger<T>& ledger, const T& lowest) const {
    const T e = number<T>(of.offset), none(0);
    ledger.draws_point("A", geometry::Point<T>{number<T>(of.lengths.eccentricity), none});
    for (int n = 0; n < 360; n += 30) {
      const T c = geometry::cosine<T>(degrees(n)), s = geometry::sine<T>(degrees(n));
      const auto back = [&](const T& x, const T& y) { return geometry::Point<T>{c * x + s * y, c * y - s * x}; };
      const std::string at = std::to_string(n);
      ledger.draws_point("foot_" + at, [&] { return back(e, none); });
      ledger.draws_point("lowest_" + at, [&] { return back(e, lowest); });
      ledger.draws_point("roller_" + at, [&] { return back(e, constructed_ordinate<T>(degrees(n))); });
    }
  }

  template <class T>
  void analysed_cycle(Ledger<T>& ledger) const {
    ledger.route("analytic");
    const geometry::analytic::RollerCam cam = of.formulas();
    const auto height = [&](const Rational& r, const Rational& d) {
      return geometry::root(number<T>(Rational(r - d)) * number<T>(Rational(r + d)));
    };
    const Rational far = cam.l + cam.r, near = cam.l - cam.r;
    const auto high = [&] { return height(far, cam.e); };
    const auto low = [&] { return height(near, cam.e); };
    // tan(α/2) = √((1 - cos α)/(1 + cos α)).
    const auto angle = [&](const Rational& R) {
      if constexpr (signs_only<T>) {
        return T(1);
      } else {
        return T(2) * degrees_of<T>({T(1), geometry::root(number<T>(Rational((R - cam.e) / (R + cam.e))))});
      }
    };
    ledger.put(quantity("y_B_max"), high);
    ledger.put(quantity("y_B_min"), low);
    // The difference of the squares over the sum.
    ledger.put(quantity("lift"), [&] { return quotient(number<T>(Rational(4 * cam.l * cam.r)), high() + low()); });
    ledger.put(quantity("angle_at_max_lift_deg"), [&] { return angle(far); });
    ledger.put(quantity("angle_at_min_lift_deg"), [&] { return number<T>(180) + angle(near); });
    ledger.put(quantity("rise_angle_deg"), [&] { return number<T>(180) + angle(far) - angle(near); });
    const auto pressure = [&](const Rational& d) { return degrees_by_half<T>({height(cam.l, d), number<T>(d)}); };
    ledger.put(quantity("pressure_angle_max_deg"), [&] { return pressure(cam.e + cam.r); });
    ledger.put(quantity("pressure_angle_min_deg"), [&] { return pressure(cam.e - cam.r); });
    for (int n = 0; n < 360; n += 30)
      ledger.put(lift_at(n), [&] {
        const T c = geometry::cosine<T>(degrees(n)), s = geometry::sine<T>(degrees(n));
        return geometry::analytic::follower_lift<T>(cam, c, s).y - low();
      });
    least(ledger, "roots of the derivative", rooted_);
  }

  // Where y'' is least, by either way of finding it.
  template <class T, class Way>
  void least(Ledger<T>& ledger, const std::string& route, const Way& way) const {
    const T w2 = square(omega<T>(of.fast)), m_3 = number<T>(of.m_3);
    const bool turns = !geometry::is_zero(of.fast);
    const auto acceleration = [=, this] { return turns ? T(w2 * way().template least<T>()) : T(0); };
    ledger.route(route);
    ledger.put(quantity("angle_at_P_min_deg"), [&] {
      if (!turns) throw geometry::Impossible(cam_at_rest);
      return in_degrees<T>(way().template angle<T>());
    });
    ledger.put(quantity("a_B3_y_min"), acceleration);
    ledger.put(quantity("P_min"),
               [&] { return of.m_3 == 0 ? T(0) : T(-(m_3 * acceleration()) - weight<T>(of.m_3)); });
    ledger.put(quantity("omega_2_first_loss"),
               [&] { return speed_of_loss<T>([&] { return T(-way().template least<T>()); }); });
  }

  Cam of;
  // Found once for all numbers.
  std::function<const geometry::analytic::LeastFollowerAcceleration&()> rooted_;
  std::function<const geometry::FollowerSweep&()> swept_;
};

}  // namespace epure::cam_dynamics
