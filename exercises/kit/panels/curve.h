// From traced loci to marks.
#pragma once

#include <vector>

#include "exercises/kit/panels/plot.h"
#include "geometry/curves/asymptotes.h"
#include "geometry/curves/trace.h"

namespace epure {

// How far, on paper, a drawn curve may be from the true one.
inline constexpr double curve_tolerance_mm = 0.01;

// What of the plane of `plot` a box of the paper shows, as a frame for the tracer.
geometry::Frame frame_of(const Plot& plot, const drawings::Box& room);

// Traces the locus within the room and draws its branches.
template <class Locus>
geometry::Trace draw_locus(Plot& plot, const Locus& locus, const drawings::Box& room, Meaning meaning,
                           const std::string& name);
void draw_branches(Plot& plot, const geometry::Trace& trace, Meaning meaning, const std::string& name);

// Draws a line right across the drawing area.
void draw_line(Plot& plot, const geometry::Line<double>& line, Meaning meaning);

template <class Locus>
geometry::Trace draw_locus(Plot& plot, const Locus& locus, const drawings::Box& room, Meaning meaning,
                           const std::string& name) {
  const double tolerance = curve_tolerance_mm / plot.scale().mm_per_unit;
  const geometry::Arithmetic<geometry::Bounded> scope;
  const geometry::Trace trace = geometry::trace(locus, frame_of(plot, room), tolerance);
  draw_branches(plot, trace, meaning, name);
  return trace;
}

}  // namespace epure
