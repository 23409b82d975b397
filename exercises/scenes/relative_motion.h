// The vectors of a scene's polygons, found twice: as the polygons have them, and as parts, along a line and across
// it, of what the equations of all joints give.
#pragma once

#include "exercises/scenes/dyad_equations.h"
#include "exercises/scenes/scene_states.h"

namespace epure::scenes {

// By the rates of links and drives.
template <class T>
class VectorsConstructed {
 public:
  VectorsConstructed(const Built& built, const Constructed<T>& found)
      : linkage_(built.linkage), found_(found), rates_(rates(built.linkage, found.carried_out)) {}

  geometry::Vector<T> operator()(const VectorSource& of) const {
    using Kind = VectorSource::Kind;
    switch (of.kind) {
      case Kind::on_link_velocity:
        return body(of).velocity(X(of));
      case Kind::on_link_acceleration:
        return body(of).acceleration(X(of));
      case Kind::rod_velocity:
        return body(of).omega * quarter_turn(from_about(of));
      case Kind::rod_normal:
        return -(square(body(of).omega) * from_about(of));
      case Kind::rod_tangential:
        return body(of).alpha * quarter_turn(from_about(of));
      case Kind::sliding_velocity:
        return sliding(of);
      case Kind::coriolis:
        return coriolis(of);
      case Kind::sliding_acceleration:
        return pin(of.point).a - body(of).acceleration(X(of)) - coriolis(of);
      case Kind::stretch_velocity:
        return rate(of).first * from_about(of);
      case Kind::swing_velocity:
        return swing(of) * quarter_turn(from_about(of));
      case Kind::stretch_acceleration:
        return rate(of).second * from_about(of);
      case Kind::stretch_normal:
        return -(square(swing(of)) * from_about(of));
      case Kind::stretch_coriolis:
        return (T(2) * swing(of) * rate(of).first) * quarter_turn(from_about(of));
      case Kind::swing_acceleration:
        break;
    }
    const geometry::Vector<T> PX = from_about(of), a = pin(of.point).a - pin(of.about).a;
    return a - ((rate(of).second - square(swing(of))) * PX + (T(2) * swing(of) * rate(of).first) * quarter_turn(PX));
  }

 private:
  const geometry::LinkageMotion<T>& motion() const { return found_.motion.get(); }
  const geometry::PlaneMotion<T>& body(const VectorSource& of) const {
    return motion().links[static_cast<std::size_t>(of.link)];
  }
  const geometry::Pin<T>& pin(int point) const { return motion().points[static_cast<std::size_t>(point)]; }
  const geometry::Point<T>& X(const VectorSource& of) const {
    return found_.at.points[static_cast<std::size_t>(of.point)];
  }
  geometry::Vector<T> from_about(const VectorSource& of) const {
    return X(of) - found_.at.points[static_cast<std::size_t>(of.about)];
  }
  geometry::Vector<T> sliding(const VectorSource& of) const { return pin(of.point).v - body(of).velocity(X(of)); }
  geometry::Vector<T> coriolis(const VectorSource& of) const {
    return (T(2) * body(of).omega) * quarter_turn(sliding(of));
  }
  // l'/l, l''/l.
  geometry::DriveRates<T> rate(const VectorSource& of) const {
    const auto k = static_cast<std::size_t>(of.drive);
    const T over = geometry::from_rational<T>(1 / std::get<geometry::Stretched>(linkage_.drives[k]).length);
    return {over * rates_[k].first, over * rates_[k].second};
  }
  // How fast the cylinder turns.
  T swing(const VectorSource& of) const {
    const geometry::Vector<T> PX = from_about(of);
    return quotient(cross(PX, pin(of.point).v - pin(of.about).v), length_squared(PX));
  }

  const geometry::Linkage& linkage_;
  const Constructed<T>& found_;
  std::vector<geometry::DriveRates<T>> rates_;
};

// As parts of the differences between two points.
template <class T>
class VectorsByJoints {
 public:
  VectorsByJoints(const Built& built, const ByJoints<T>& found) : linkage_(built.linkage), found_(found) {}

  geometry::Vector<T> operator()(const VectorSource& of) const {
    using Kind = VectorSource::Kind;
    const auto plane = [](const Complex& z) { return geometry::Vector<T>{z.re, z.im}; };
    switch (of.kind) {
      case Kind::on_link_velocity:
        return plane(under(of, UpTo::velocity).v);
      case Kind::on_link_acceleration:
        return plane(under(of, UpTo::acceleration).a);
      case Kind::rod_velocity:
        return plane(far(of, UpTo::velocity).v - at(of.about, UpTo::velocity).v);
      case Kind::rod_normal:
        return plane(along_rod(acceleration(of), rod(of)));
      case Kind::rod_tangential:
        return plane(along_rod(acceleration(of), times_i(rod(of))));
      case Kind::sliding_velocity:
        return plane(along(at(of.point, UpTo::velocity).v - under(of, UpTo::velocity).v, slot(of)));
      case Kind::coriolis:
        return plane(along(acceleration_beside(of), times_i(slot(of))));
      case Kind::sliding_acceleration:
        return plane(along(acceleration_beside(of), slot(of)));
      case Kind::stretch_velocity:
        return plane(along(velocity(of), rod(of)));
      case Kind::swing_velocity:
        return plane(along(velocity(of), times_i(rod(of))));
      case Kind::stretch_normal:
        return plane(normal(of));
      case Kind::stretch_acceleration:
        return plane(along(acceleration(of), rod(of)) - normal(of));
      case Kind::stretch_coriolis:
        return plane(coriolis(of));
      case Kind::swing_acceleration:
        break;
    }
    return plane(along(acceleration(of), times_i(rod(of))) - coriolis(of));
  }

 private:
  using Complex = geometry::analytic::Complex<T>;
  using State = geometry::analytic::PointState<T>;

  const LinkState<T>& link(int i, UpTo order) const { return found_.link(static_cast<std::size_t>(i), order); }
  State at(int point, UpTo order) const {
    const int on = linkage_.links_at(point).front();
    return geometry::analytic::point_of(link(on, order), linkage_.place(on, point));
  }
  // The link's own point where X is.
  State under(const VectorSource& of, UpTo order) const {
    const LinkState<T>& body = link(of.link, order);
    const Complex X = at(of.point, UpTo::place).z, r = X - body.O;
    return {X, body.v + body.omega * times_i(r), body.a + Complex{-square(body.omega), body.alpha} * r};
  }
  bool has(int link, int point) const {
    const std::vector<int> there = linkage_.links_at(point);
    return std::find(there.begin(), there.end(), link) != there.end();
  }
  State far(const VectorSource& of, UpTo order) const {
    return of.link == geometry::nothing || has(of.link, of.point) ? at(of.point, order) : under(of, order);
  }
  Complex rod(const VectorSource& of) const { return at(of.point, UpTo::place).z - at(of.about, UpTo::place).z; }
  Complex velocity(const VectorSource& of) const {
    return far(of, UpTo::velocity).v - at(of.about, UpTo::velocity).v;
  }
  Complex acceleration(const VectorSource& of) const {
    return far(of, UpTo::acceleration).a - at(of.about, UpTo::acceleration).a;
  }
  Complex acceleration_beside(const VectorSource& of) const {
    return at(of.point, UpTo::acceleration).a - under(of, UpTo::acceleration).a;
  }
  Complex slot(const VectorSource& of) const {
    const geometry::Direction& own = linkage_.line(of.line).along;
    const Complex& x = link(of.link, UpTo::place).x;
    if (const auto* angle = std::get_if<geometry::Angle>(&own))
      return Complex{geometry::cosine<T>(*angle), geometry::sine<T>(*angle)} * x;
    const auto& [u, w] = std::get<geometry::Own>(own);
    return Complex{geometry::from_rational<T>(u), geometry::from_rational<T>(w)} * x;
  }
  // What of z is along the direction u.
  static Complex along(const Complex& z, const Complex& u) { return quotient(dot(z, u), squared_modulus(u)) * u; }
  // Of two points of one link, that may lie in one place. Then z is nothing, and what is along a line at most all of
  // it.
  static Complex along_rod(const Complex& z, const Complex& u) {
    if (sign(squared_modulus(u)) == geometry::Sign::positive) return along(z, u);
    if constexpr (std::is_same_v<T, geometry::Bounded> || std::is_same_v<T, geometry::Deep>) {
      const T all = root(square(z.re)) + root(square(z.im));
      return {widened(T(0), all), widened(T(0), all)};
    } else {
      return {T(0), T(0)};
    }
  }
  // v²/l towards P.
  Complex normal(const VectorSource& of) const {
    const Complex PX = rod(of), swing = along(velocity(of), times_i(PX));
    return -(quotient(squared_modulus(swing), squared_modulus(PX)) * PX);
  }
  // 2 l'/l times the velocity across.
  Complex coriolis(const VectorSource& of) const {
    const Complex PX = rod(of), v = velocity(of);
    return (T(2) * quotient(dot(v, PX), squared_modulus(PX))) * along(v, times_i(PX));
  }

  const geometry::Linkage& linkage_;
  const ByJoints<T>& found_;
};

}  // namespace epure::scenes
