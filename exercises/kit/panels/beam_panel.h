// A beam cut free, and diagrams along it one below the other, their abscissae in line with it: funicular polygons and
// elastic lines, whose ordinates are lengths, and diagrams at the scale of the sheet's vectors.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

// A diagram: points (ξ, ordinate).
struct BeamDiagram {
  struct Run {
    std::vector<Place> points;
    Meaning meaning = Meaning::construction;
    bool is_area = false;     // filled, and its border drawn
    bool is_cubic = false;    // four points: the ends of a cubic and where its tangents there cross the thirds
    std::string letter = {};  // beside its middle, away from a point or not
    std::optional<Place> away_from = {};
  };
  // A length that a ruler reads along the ordinate: times `worth` (SI per unit of ordinate) the quantity.
  struct Ordinate {
    std::string quantity, label;
    double at, from, to, worth;
    bool is_arrow = false;
    Meaning meaning = Meaning::force;
    double aside = 0;  // mm to the right: of several in one line one stands beside the others
  };
  struct Letter {
    std::string text;
    Place at, away_from;
  };
  struct Load {
    std::string label;
    double at;
    double sense;           // up or down
    bool is_given = false;  // and stands on the sheet to be solved too
  };
  bool of_vectors = false;  // ordinates in the unit of the sheet's vectors; else in metres
  std::string name = {};    // left of the axis
  std::vector<Run> runs = {};
  std::vector<Ordinate> ordinates = {};
  std::vector<Letter> letters = {};
  std::vector<Load> loads = {};  // arrows on the axis
  bool is_beam = false;          // the axis is the beam itself
};

class BeamPanel : public Panel {
 public:
  // `vectors`: of the diagrams that have any.
  BeamPanel(double length, std::vector<BeamDiagram> diagrams, Vectors vectors = {})
      : length_(length), diagrams_(std::move(diagrams)), vectors_(std::move(vectors)) {}

  // Lines down through all diagrams: of supports and loads.
  BeamPanel& lines_at(std::vector<double> abscissae) {
    lines_ = std::move(abscissae);
    return *this;
  }
  BeamPanel& step(std::size_t diagram, const Place& at, const Words& text) {
    steps_.push_back({diagram, at, text, false});
    return *this;
  }
  // Of what the steps of all other panels have found.
  BeamPanel& last_step(std::size_t diagram, const Place& at, const Words& text) {
    steps_.push_back({diagram, at, text, true});
    return *this;
  }

  double reach() const override { return length_; }
  Vectors vectors() const override { return vectors_; }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  struct Step {
    std::size_t diagram;
    Place at;
    Words text;
    bool needs_all_others;
  };
  // How far the axis of each stands below the first one, and the lower end of the last, in mm.
  std::vector<double> axes(double mm_of_lengths, double mm_of_vectors) const;
  Place place(const Plot& plot, std::size_t diagram, const Place& at) const;
  void draw(Plot& plot, std::size_t diagram) const;
  void draw_axis(Plot& plot, std::size_t diagram) const;
  void draw_ordinate(Plot& plot, std::size_t diagram, const BeamDiagram::Ordinate& each) const;
  void draw_load(Plot& plot, std::size_t diagram, const BeamDiagram::Load& load) const;
  void draw_letters(Plot& plot, std::size_t diagram) const;
  void draw_lines(Plot& plot) const;

  double length_;
  std::vector<BeamDiagram> diagrams_;
  Vectors vectors_;
  std::vector<double> lines_ = {};
  std::vector<Step> steps_ = {};
};

}  // namespace epure
