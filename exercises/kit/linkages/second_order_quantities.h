// What coupler_routes.h writes down of a plane's motion of second order, by kind.
#pragma once

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/quantity.h"

namespace epure {

inline Quantity inflection_diameter() {
  return {"inflection_diameter",
          "$δ_{F}$",
          "m",
          {"diameter of the inflection circle", "diametro della circonferenza dei flessi"}};
}
inline PointQuantity inflection_centre() {
  return {
      "inflection_centre", {" of the inflection circle's centre", " del centro della circonferenza dei flessi"}, "F"};
}
inline PointQuantity inflection_pole() {
  return {"inflection_pole", {" of the inflection pole J", " del polo dei flessi J"}, "J"};
}
inline Quantity stationarity_diameter() {
  return {"stationarity_diameter",
          "$δ_{S}$",
          "m",
          {"diameter of the stationarity circle", "diametro della circonferenza di stazionarietà"}};
}
inline PointQuantity stationarity_centre() {
  return {"stationarity_centre",
          {" of the stationarity circle's centre", " del centro della circonferenza di stazionarietà"},
          "S"};
}

// Of X', where the ray to X meets the inflection circle.
inline Quantity distance_on_ray(const std::string& X) {
  const std::string letters = point_letters(X);
  return {X + "prime_" + X, "$" + letters + "'" + letters + "$", "m",
          format_words("distance from {}' to {}", "distanza da {}' a {}", X, X)};
}
inline PointQuantity point_on_ray(const std::string& X) {
  return {X + "prime",
          format_words(" of {}', on the inflection circle", " di {}', sulla circonferenza dei flessi", X),
          point_letters(X) + "'"};
}
inline Quantity radius_of_curvature(const std::string& X) {
  return {"rho_" + X, "$ρ_{" + X + "}$", "m",
          format_words("radius of curvature of the path of {}", "raggio di curvatura della traiettoria di {}", X)};
}
inline PointQuantity centre_of_curvature(const std::string& X) {
  return {"curvature_centre_" + X, {" of the centre of curvature", " del centro di curvatura"}, "Ω" + X};
}

// The angle from the acceleration of a point of body 3 to its ray from K.
inline Quantity inclination() { return {"gamma", "$γ$", "rad", {"tan γ = α₃/ω₃²", "tg γ = α₃/ω₃²"}}; }
inline Quantity inclination_in_degrees() { return {"gamma_deg", "$γ$", "deg", {"γ in degrees", "γ in gradi"}}; }

}  // namespace epure
