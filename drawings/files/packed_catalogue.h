// The catalogue of a PDF whose objects are packed in streams.
#pragma once

#include <optional>
#include <string>

namespace epure::drawings {

struct PackedCatalogue {
  std::string text;         // its dictionary
  std::size_t number;       // of its object
  std::size_t information;  // the object that tells title and author
  std::size_t objects;      // how many numbers are taken, 0 among them
  std::size_t table;        // where the table of objects begins
};

// As Cairo 1.18 packs it: a table that is a stream with its dictionary in plain text, and objects in streams (ISO
// 32000-1, 7.5.7 and 7.5.8). None where it is otherwise.
std::optional<PackedCatalogue> packed_catalogue(const std::string& pdf);

}  // namespace epure::drawings
