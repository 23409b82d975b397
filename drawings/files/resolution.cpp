#include "drawings/files/resolution.h"

#include <boost/crc.hpp>
#include <cmath>
#include <cstdint>

#include "drawings/files/big_endian.h"
#include "drawings/page.h"
#include "drawings/paths/grid.h"

namespace epure::drawings {
namespace {

// Its length, what it is, its content, and the checksum of the latter two.
std::string chunk(const std::string& kind, const std::string& content) {
  std::string bytes;
  add_number(bytes, static_cast<std::uint32_t>(content.size()));
  const std::string checked = kind + content;
  boost::crc_32_type checksum;
  checksum.process_bytes(checked.data(), checked.size());
  bytes += checked;
  add_number(bytes, checksum.checksum());
  return bytes;
}

}  // namespace

Pixels pixels(const Page& page, double dots_per_inch) {
  const auto rounded = [&](double mm) { return std::lround(mm * points_per_mm / points_per_inch * dots_per_inch); };
  return {rounded(page.extent.width()), rounded(page.extent.height())};
}

std::string with_resolution(std::string png, double dots_per_inch) {
  constexpr std::size_t behind_header = 33;  // the signature of 8 bytes and the chunk IHDR of 25
  constexpr double inches_per_metre = 1 / 0.0254;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dots_per_inch * inches_per_metre));
  std::string density;
  add_number(density, per_metre);
  add_number(density, per_metre);
  density += '\1';  // a metre
  return png.insert(behind_header, chunk("pHYs", density));
}

}  // namespace epure::drawings
