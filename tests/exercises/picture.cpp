#include "tests/exercises/picture.h"

#include <png.h>

#include <algorithm>

#include "tests/support/catch.h"

namespace epure {
namespace {

bool differs(const Picture& one, const Picture& other, int x, int y) {
  for (int channel = 0; channel < 3; ++channel) {
    int low = 255, high = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        low = std::min(low, other.at(x + dx, y + dy, channel));
        high = std::max(high, other.at(x + dx, y + dy, channel));
      }
    const int here = one.at(x, y, channel);
    if (here < low - 64 || here > high + 64) return true;
  }
  return false;
}

}  // namespace

Picture::Picture(const std::filesystem::path& png) {
  INFO(png);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, png.c_str()) != 0);
  image.format = PNG_FORMAT_RGB;
  width_ = static_cast<int>(image.width);
  height_ = static_cast<int>(image.height);
  channels_.resize(PNG_IMAGE_SIZE(image));
  const png_color white{255, 255, 255};
  REQUIRE(png_image_finish_read(&image, &white, channels_.data(), 0, nullptr) != 0);
}

int Picture::at(int x, int y, int channel) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return 255;
  return channels_[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
                       3 +
                   static_cast<std::size_t>(channel)];
}

double worst_difference(const Picture& one, const Picture& other, int side) {
  const int width = std::max(one.width(), other.width()), height = std::max(one.height(), other.height());
  const auto row = static_cast<std::size_t>(width) + 1;
  // How many differ above and to the left of each corner.
  std::vector<int> before(row * (static_cast<std::size_t>(height) + 1));
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x); };
  int most = 0;
  for (int y = 1; y <= height; ++y)
    for (int x = 1; x <= width; ++x) {
      const bool here = differs(one, other, x - 1, y - 1) || differs(other, one, x - 1, y - 1);
      before[index(x, y)] = before[index(x - 1, y)] + before[index(x, y - 1)] - before[index(x - 1, y - 1)] + here;
      if (x >= side && y >= side)
        most = std::max(most, before[index(x, y)] - before[index(x - side, y)] - before[index(x, y - side)] +
                                  before[index(x - side, y - side)]);
    }
  return most / static_cast<double>(side * side);
}

}  // namespace epure
