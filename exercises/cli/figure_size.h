// Figures no larger than a document has room for.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "exercises/kit/proof/exercise.h"

namespace epure {

// mm; none: as the paper has it.
struct FigureSize {
  std::optional<double> width = {}, height = {};
  bool is_asked() const { return width || height; }
};

// A bare figure in a room of this size.
using DrawnIn = std::function<DrawnSheet(const FigureSize& room)>;

// The largest figure that is no larger than `most`; what is drawn in looking for it is kept.
class FigureWithin {
 public:
  FigureWithin(const FigureSize& most, DrawnIn draw);

  // Throws DoesNotFit, with the least size that would do.
  const DrawnSheet& largest();
  // Why it is hard to read, and from which size on it is not; none: it reads well.
  std::optional<Words> hard_to_read();

 private:
  struct Size {
    double width = 0, height = 0;
  };
  struct Figure;
  using Suits = std::function<bool(const Figure&)>;
  std::shared_ptr<const Figure> in(const FigureSize& room);
  std::shared_ptr<const Figure> largest_within(const FigureSize& most);
  std::optional<int> guess(const Suits& suits) const;
  std::optional<int> least_that_suits(const Suits& suits);

  FigureSize most_;
  DrawnIn draw_;
  std::map<std::pair<std::optional<double>, std::optional<double>>, std::shared_ptr<const Figure>> known_ = {};
};

}  // namespace epure
