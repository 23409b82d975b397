// From sheets to files: composing (layout, label placement), and the PDF and SVG writers.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

// A mark so far off the paper (10,000 km) that doubles no longer tell where it crosses the sheet.
struct TooFar : Told {
  using Told::Told;
};
// Throw TooFar for a place (mm) so far off, std::invalid_argument for one that is not finite.
void demand_drawable(double value);
void demand_drawable(Point p);

// One document, a page a sheet; bare sheets get pages of their cropped size. Bytes depend on the sheets alone.
// Throws std::invalid_argument naming the mark when a coordinate is not finite, TooFar when it is too large.
std::string pdf(const std::vector<Sheet>& sheets, const std::string& document_title);
std::string svg(const Sheet& sheet);

// Where labels had to overlap something, in words; empty when every label found room. For tests and reviews.
std::vector<std::string> overlaps(const Sheet& sheet);

// What drawing needs of the machine is not to be had: a font that came with epure, or a thread.
struct Unavailable : Told {
  using Told::Told;
};

struct CannotWrite : Told {
  using Told::Told;
};
// Standard output under any of its names: "-", /dev/stdout, /proc/self/fd/1, or a link that leads to one of them.
bool is_standard_output(const std::filesystem::path& path);

// The whole file or none: written without a name in the folder of `path`, synced, named and renamed. An older file
// stays until the new one is complete; the new one has its permissions and, as far as the system allows, its owner.
// Another hard link to the older file keeps the older bytes. "-" is standard output. Throws CannotWrite with path and
// reason.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

struct File {
  std::filesystem::path path;
  std::string bytes;
};
// The same for each of them. None is renamed before all are written and synced, so that a full disk leaves the old
// ones; what is no ordinary file (a device, standard output) is written last.
void write_whole(const std::vector<File>& files);

// A file that is written piece by piece, of any length, and appears as write_whole has it when it is finished; left
// before, it leaves nothing behind, and an older file as it was. What is no ordinary file (a device) gets each piece
// at once. Not for standard output. All throw CannotWrite. Any thread may write, one at a time.
class GrowingFile {
 public:
  explicit GrowingFile(const std::filesystem::path& path);
  void write(std::string_view bytes) { way_->write(bytes); }
  void finish() { way_->finish(); }

  // How pieces reach the disk.
  class Way {
   public:
    virtual ~Way() = default;
    virtual void write(std::string_view bytes) = 0;
    virtual void finish() = 0;
  };

 private:
  std::unique_ptr<Way> way_;
};

// Makes `folder` if it is missing. Throws CannotWrite, as writing a file there would; leaves no trace in it.
void demand_writable(const std::filesystem::path& folder);

}  // namespace epure::drawings
