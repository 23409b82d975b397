#include "tests/support/unpacked.h"

#include <zlib.h>

#include <array>

#include "tests/support/catch.h"

namespace epure {

std::string unpacked(std::string_view packed) {
  z_stream stream = {};
  REQUIRE(inflateInit(&stream) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib only reads it
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string plain;
  int status = Z_OK;
  while (status == Z_OK) {
    std::array<Bytef, 65536> part;
    stream.next_out = part.data();
    stream.avail_out = part.size();
    status = inflate(&stream, Z_NO_FLUSH);
    plain.append(reinterpret_cast<const char*>(part.data()), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END ? plain : "";
}

std::string with_packed_objects(const std::string& pdf) {
  constexpr std::string_view packed = "/Type /ObjStm", begins = "stream\n";
  std::string all = pdf;
  for (auto at = pdf.find(packed); at != pdf.npos; at = pdf.find(packed, at + 1)) {
    const std::string objects = unpacked(std::string_view(pdf).substr(pdf.find(begins, at) + begins.size()));
    REQUIRE_FALSE(objects.empty());
    all += objects;
  }
  return all;
}

}  // namespace epure
