#include "exercises/kit/statement/quantity.h"

#include <algorithm>
#include <cctype>

#include "exercises/kit/statement/format_words.h"

namespace epure {
namespace {

// "a B", "ad A".
std::string to_in_italian(const std::string& point) { return (point.starts_with("A") ? "ad " : "a ") + point; }

// "of B", or "of B relative to A".
Words of_points(const std::string& of) {
  const std::vector<std::string> points = points_in(of);
  if (points.size() == 2)
    return format_words(" of {} relative to {}", " di {} rispetto {}", points[0],
                        Words{points[1], to_in_italian(points[1])});
  return format_words(" of {}", " di {}", of);
}

VectorQuantity vector(const std::string& name, const std::string& letters, const std::string& of,
                      const std::string& unit, const Words& meaning, const Words& size) {
  return {name, letters, of, unit, meaning + of_points(of), size + of_points(of)};
}

}  // namespace

std::vector<std::string> points_in(const std::string& of) {
  std::vector<std::string> points;
  for (const char c : of) {
    if (points.empty() || (std::isupper(static_cast<unsigned char>(c)) != 0)) points.emplace_back();
    points.back() += c;
  }
  return points;
}

std::string point_letters(const std::string& name) {
  const std::string prime = "prime";
  if (name.ends_with(prime)) return point_letters(name.substr(0, name.size() - prime.size())) + "'";
  std::size_t digits = name.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(name[digits - 1])) != 0) --digits;
  if (digits == name.size()) return name;
  const std::size_t letters = digits > 1 && name[digits - 1] == '_' ? digits - 1 : digits;  // "H_2" as "H2"
  return name.substr(0, letters) + "_{" + name.substr(digits) + "}";
}

Quantity VectorQuantity::component(const std::string& axis, const Words& along) const {
  return {name + "_" + axis, "$" + fmt::format(fmt::runtime(letters), of + axis) + "$", unit, meaning + along};
}

Quantity VectorQuantity::length() const {
  return {name, "$" + fmt::format(fmt::runtime(letters), of) + "$", unit, size};
}

std::string VectorQuantity::arrow() const {
  const std::string written = fmt::format(fmt::runtime(letters), of);
  const std::size_t scripts = std::min(written.find_first_of("_^"), written.size());
  return "$\\vec{" + written.substr(0, scripts) + "}" + written.substr(scripts) + "$";
}

Quantity PointQuantity::x() const {
  return {name + "_x", "$x_{" + (letters.empty() ? name : letters) + "}$", "m", Words{"abscissa", "ascissa"} + of};
}
Quantity PointQuantity::y() const {
  return {name + "_y", "$y_{" + (letters.empty() ? name : letters) + "}$", "m", Words{"ordinate", "ordinata"} + of};
}

VectorQuantity velocity(const std::string& of) {
  return vector("v_" + of, "v_{{{}}}", of, "m/s", {"velocity", "velocità"}, {"speed", "velocità"});
}
VectorQuantity acceleration(const std::string& of) {
  const Words meaning{"acceleration", "accelerazione"};
  return vector("a_" + of, "a_{{{}}}", of, "m/s^2", meaning, meaning);
}
VectorQuantity normal_acceleration(const std::string& of) {
  const Words meaning{"normal part of the acceleration", "parte normale dell'accelerazione"};
  return vector("a_" + of + "_n", "a^{{n}}_{{{}}}", of, "m/s^2", meaning, meaning);
}
VectorQuantity tangential_acceleration(const std::string& of) {
  const Words meaning{"tangential part of the acceleration", "parte tangenziale dell'accelerazione"};
  return vector("a_" + of + "_t", "a^{{t}}_{{{}}}", of, "m/s^2", meaning, meaning);
}

PointQuantity point(const std::string& name) { return {name, of_points(name)}; }
PointQuantity pole(const std::string& name) { return {name, {" of the pole", " del polo"}}; }
PointQuantity acceleration_pole() { return {"K", {" of the acceleration pole", " del polo delle accelerazioni"}}; }

Quantity distance(const std::string& P, const std::string& X) {
  return {P + X, "$" + point_letters(P) + point_letters(X) + "$", "m",
          format_words("distance of {} from {}", "distanza di {} da {}", X, P)};
}

Quantity angular_velocity(int body) {
  const std::string i = std::to_string(body);
  return {"omega_" + i, "$ω_{" + i + "}$", "rad/s",
          format_words("angular velocity of link {}, counter-clockwise",
                       "velocità angolare del membro {}, antioraria", i)};
}
Quantity angular_acceleration(int body) {
  const std::string i = std::to_string(body);
  return {"alpha_" + i, "$α_{" + i + "}$", "rad/s^2",
          format_words("angular acceleration of link {}, counter-clockwise",
                       "accelerazione angolare del membro {}, antioraria", i)};
}

}  // namespace epure
