// What is drawn along the film, found with many bits: where the walls are nearly parallel doubles lose what gradient
// and pressure are made of.
#pragma once

#include <functional>
#include <vector>

#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sized_chart.h"
#include "exercises/michell-bearing/problem.h"

namespace epure::michell_bearing {

using DeepWedge = geometry::FilmWedge<geometry::Deep>;
using OfFilm = geometry::Deep (DeepWedge::*)(const geometry::Deep&) const;

inline std::function<double(double)> along(const Film& film, OfFilm of) {
  return [=](double x) {
    return deeply([&] { return to_double((film.wedge<geometry::Deep>().*of)(geometry::Deep::from_double(x))); });
  };
}

inline std::vector<std::vector<drawings::Datum>> run_along(const Film& film, OfFilm of) {
  return run_of(0, geometry::from_rational<double>(film.l), along(film, of));
}

}  // namespace epure::michell_bearing
