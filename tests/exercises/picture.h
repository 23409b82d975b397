// A picture made of pixels, and how it is held against another one.
#pragma once

#include <filesystem>
#include <vector>

namespace epure {

class Picture {
 public:
  // Of a PNG file, on white. Fails the test when there is none.
  explicit Picture(const std::filesystem::path& png);

  int width() const { return width_; }
  int height() const { return height_; }
  // Red, green or blue of a pixel; white outside.
  int at(int x, int y, int channel) const;

 private:
  int width_ = 0, height_ = 0;
  std::vector<unsigned char> channels_;
};

// The largest part of pixels that differ, in any square of `side` pixels. A pixel differs when its colour is more
// than a quarter of the way from black to white off all that the other picture shows within one pixel: where two
// programs smooth the same edge, each in its way, they are one pixel apart at most, and what they mix lies between
// its sides.
double worst_difference(const Picture& one, const Picture& other, int side);

}  // namespace epure
