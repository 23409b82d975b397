// A mechanism with the vectors of some of its points drawn where they act.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

class VectorsPanel : public Panel {
 public:
  // `vector`: velocity or acceleration. The points must be of the mechanism.
  VectorsPanel(const Solution& solution, std::shared_ptr<const Mechanism> mechanism,
               VectorQuantity (*vector)(const std::string& of), const std::vector<std::string>& points);

  // The vector of a point is perpendicular to the way from it to another: marked.
  VectorsPanel& square_to(const std::string& point, const std::string& other) {
    squares_.emplace_back(point, other);
    return *this;
  }

  // On the paper, in mm.
  VectorsPanel& no_longer_than(double mm) {
    longest_on_paper_ = mm;
    return *this;
  }

  double reach() const override { return mechanism_->reach(); }
  Vectors vectors() const override;
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_->draw_given(plot); }

 protected:
  struct Acting {
    VectorQuantity quantity;
    Place at;
    Arrow2 v;
  };
  // What leads to the vector's tip: drawn before it, so that it is not set aside from there.
  virtual void draw_terms(Plot&, const Acting&) const {}

 private:
  std::shared_ptr<const Mechanism> mechanism_;
  std::vector<Acting> acting_;
  std::vector<std::pair<std::string, std::string>> squares_;
  double longest_on_paper_ = 80;  // mm
};

}  // namespace epure
