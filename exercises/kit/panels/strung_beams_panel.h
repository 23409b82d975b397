// Beams side by side, each with its diagram of bending, the polygon of its elastic weights with the pole, and Mohr's
// second funicular polygon, which that makes: from the tangent where the beam begins, which is drawn level, to its
// end.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct StrungBeam {
  double length;                  // m
  std::string from, to;           // rich text
  std::array<double, 2> moments;  // at the ends, in N m: positive where the lower fibres are in tension
  std::array<double, 2> weights;  // of the diagram's two triangles, in rad
  std::array<Place, 4> corners;   // of the polygon: from the beam's beginning along it, and upwards, in m
  std::string weight;             // their letters
  std::string quantity, letters;  // what the polygon's end shows ...
  bool counts_down;               // ... downwards
};

class StrungBeamsPanel : public Panel {
 public:
  // `told`: of diagrams, weights with pole, strings, and what the last string ends in.
  StrungBeamsPanel(std::vector<StrungBeam> beams, std::array<Words, 4> told, Language language);

  double reach() const override;
  Vectors vectors() const override;
  std::vector<Scale> own_scales() const override { return {moments_, weights_}; }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  // Heights on paper, mm above the level tangents of the polygons, and where the beams begin, mm from the first.
  struct Places {
    double diagrams, poles;
    std::vector<double> begin;
  };
  double pole_distance(double mm_per_metre, double mm_per_mm) const;  // mm
  Places places(double mm_per_metre, double mm_per_mm) const;
  void draw_diagram(Plot& plot, const StrungBeam& beam, double level, double begin, Language language) const;
  void draw_pole(Plot& plot, const StrungBeam& beam, double level, double begin, Language language) const;
  void draw_polygon(Plot& plot, const StrungBeam& beam, double begin) const;

  std::vector<StrungBeam> beams_;
  std::array<Words, 4> told_;
  Scale moments_, weights_;
};

}  // namespace epure
