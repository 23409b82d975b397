// Mohr's circle of a beam's stresses: its diameter, its pole and the principal stresses, and von Mises' equivalent
// stress as the distance from the origin of the equilateral triangle's tip over the principal stresses.
#pragma once

#include <string>
#include <utility>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct MohrPicture {
  std::string unit;  // "MPa"
  double si = 1;     // one unit, in SI
  double sigma = 0, tau = 0;
  double sigma_I = 0, sigma_II = 0;
  std::string sigma_letters, tau_letters;  // "$σ_{z}$"
  std::string direction_letters = {};      // of the angle of σ_I with the beam; empty: it is not told
  // Quantities that a ruler reads; empty: none.
  std::string sigma_name = {}, tau_name = {}, sigma_I_name = {}, sigma_II_name = {}, radius_name = {},
              centre_name = {}, equivalent_name = {};
};

class MohrPanel : public Panel {
 public:
  explicit MohrPanel(MohrPicture picture) : of_(std::move(picture)) {}

  bool is_of_vectors() const override { return true; }
  std::vector<Place> lettered() const override;
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  Place centre() const { return {(of_.sigma_I + of_.sigma_II) / 2, 0}; }
  double radius() const { return (of_.sigma_I - of_.sigma_II) / 2; }
  Place tip() const;
  void draw_direction(Plot& plot, const Place& X, const Place& pole, const Place& I) const;
  void measure(Plot& plot, const std::string& name, const Place& from, const Place& to, Measurement::Kind kind) const;

  MohrPicture of_;
};

}  // namespace epure
