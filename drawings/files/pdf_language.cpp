#include "drawings/files/pdf_language.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cstdlib>
#include <new>
#include <string_view>

#include "drawings/files/big_endian.h"

namespace epure::drawings {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view catalogue = "/Type /Catalog";

// The catalogue is plain, and the last object: only the table of objects moves, and one place says where it is.
std::string put_in(std::string pdf, std::size_t catalogue_at, const std::string& added) {
  constexpr std::string_view end = "endobj\n", start = "startxref\n";
  const auto table = pdf.find(end, catalogue_at) + end.size();
  const auto told = pdf.find(start, table);
  if (pdf.compare(table, 5, "xref\n") != 0 || told == std::string::npos) return pdf;
  const auto place = told + start.size(), line_end = pdf.find('\n', place);
  if (pdf.substr(place, line_end - place) != fmt::format("{}", table)) return pdf;
  pdf.replace(place, line_end - place, fmt::format("{}", table + added.size()));
  return pdf.insert(catalogue_at + catalogue.size(), added);
}

// What `bytes` begin with; what follows it does not matter.
std::string unpacked(std::string_view bytes) {
  z_stream stream = {};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib only reads it
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string plain;
  int status = Z_OK;
  while (status == Z_OK) {
    std::array<char, 4096> part;
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = part.size();
    status = inflate(&stream, Z_NO_FLUSH);
    plain.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  return plain;
}

std::string packed(const std::string& plain) {
  uLongf size = compressBound(plain.size());
  std::string bytes(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
               plain.size()) != Z_OK)
    throw std::bad_alloc();  // there is room for what comes of it
  bytes.resize(size);
  return bytes;
}

std::string_view behind(std::string_view text, std::size_t at, std::string_view word) {
  return at == text.npos ? ""sv : text.substr(at + word.size());
}
std::string_view behind_first(std::string_view text, std::string_view word) {
  return behind(text, text.find(word), word);
}
std::string_view behind_last(std::string_view text, std::string_view word) {
  return behind(text, text.rfind(word), word);
}
unsigned long number_behind(std::string_view text, std::string_view word) {
  return std::strtoul(std::string(behind_first(text, word).substr(0, 20)).c_str(), nullptr, 10);
}

// The catalogue is the last of the objects packed last. It is written once more behind them all, and then a table of
// two objects, it and the table itself, which goes before that of the others.
std::string put_behind(std::string pdf, const std::string& added) {
  const std::string objects = unpacked(behind_first(behind_last(pdf, "/Type /ObjStm"), "stream\n"));
  const auto found = objects.rfind(catalogue);
  const std::string_view table = behind_last(pdf, "/Type /XRef");
  if (found == std::string::npos || table.empty()) return pdf;
  const unsigned long root = number_behind(table, "/Root "), info = number_behind(table, "/Info "),
                      size = number_behind(table, "/Size "), others = number_behind(table, "startxref\n");

  std::string places;
  const auto add_place = [&] {
    places += '\1';  // in the file, at this byte
    add_number(places, static_cast<std::uint32_t>(pdf.size()));
  };
  add_place();
  pdf += fmt::format("{} 0 obj\n<< {}{}{}endobj\n", root, catalogue, added, objects.substr(found + catalogue.size()));
  add_place();
  const std::string stream = packed(places);  // Adobe Reader takes no plain one
  return fmt::format(
      "{}{} 0 obj\n<< /Type /XRef\n   /Length {}\n   /Filter /FlateDecode\n   /Size {}\n   /W [1 4 0]\n"
      "   /Index [{} 1 {} 1]\n   /Prev {}\n   /Root {} 0 R\n   /Info {} 0 R\n>>\nstream\n{}\nendstream\nendobj\n"
      "startxref\n{}\n%%EOF\n",
      pdf, size, stream.size(), size + 1, root, size, others, root, info, stream, pdf.size());
}

}  // namespace

std::string in_language(std::string pdf, Language language) {
  const std::string added = fmt::format("\n   /Lang ({})", language == Language::english ? "en" : "it");
  const auto at = pdf.rfind(catalogue);
  return at == std::string::npos ? put_behind(std::move(pdf), added) : put_in(std::move(pdf), at, added);
}

}  // namespace epure::drawings
