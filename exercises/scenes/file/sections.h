// The sections of a scene's file, and what all of them are read with: the file's numbers, letters and refusals.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/file/formula.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// A file that is being read into a linkage, at certain givens.
struct FileReading {
  // The links in this order, by their numbers in the file; in that of the file where it is empty.
  FileReading(const File& in, const TextTree& all, const Givens& givens, std::vector<int> links = {});

  // In which a bare number is.
  std::string unit(geometry::Kind kind) const;

  const File& file;
  const TextTree& root;
  std::vector<int> order;
  Amounts known;                // givens, and names of where:
  std::set<std::string> given;  // the givens alone
  std::string length_unit = "m", angle_unit = {};
  std::map<std::string, geometry::Own> drawn = {};  // points:, and its lines
  std::map<std::string, geometry::LinkLine> drawn_lines = {};
  std::vector<const TextTree*> chosen_at = {}, link_at = {};  // where the file says so
  Built built = {};
};

// In this order; each throws BadScene.
void read_numbers(FileReading& of);            // units, where
void read_links(FileReading& of);              // points, links
void demand_names_of_points(FileReading& of);  // no point is called as something else is
void read_joints(FileReading& of);             // slides, gears, rolls
void read_drives(FileReading& of);             // drive, assembly
void read_questions(FileReading& of);          // offsets, paths, polodes
void read_friction(FileReading& of);           // friction
void read_loads(FileReading& of);              // loads, masses, gravity
void place_links(FileReading& of);             // in which order they are constructed

class SectionReader {
 public:
  explicit SectionReader(FileReading& of) : of_(of), file_(of.file), root_(of.root), built_(of.built) {}

 protected:
  using Tree = TextTree;

  [[noreturn]] void refuse(const Tree& at, const Words& sentence) const { file_.refuse(at, sentence); }

  // --- of the file ---
  const Tree& demand(const Tree& map, const std::string& key) const;
  // The whole file where it has no such section.
  const Tree& section(const char* name) const;

  // --- numbers; bare ones in the file's units ---
  Amount amount(const Tree& at, geometry::Kind kind) const;
  bool reads_as(const Tree& at, geometry::Kind kind) const;
  geometry::Rational length(const Tree& at) const { return amount(at, geometry::Kind::length).value; }
  geometry::Own own(const Tree& at) const;
  // The letters of the given that it is; else "8.02°", "3.5 mm", "0.15", the units in which what is found is told.
  Words words_of_amount(const Tree& at, geometry::Kind kind) const;
  // Told on the sheets beside the givens, unless it is one of these or its opposite; `at` may be none.
  void tell(const Words& what, const Tree* at, geometry::Kind kind) const;
  void tell_once(const Words& told) const;
  // Zero where the map does not say it.
  geometry::Angle turning(const Tree& map, const std::string& key, geometry::Kind kind) const;

  // --- letters and numbers of points, lines and links, as places in the linkage and back ---
  int point(const Tree& at, const std::string& name) const;
  int line(const Tree& at, const std::string& name) const;
  int link_of_number(const Tree& at, const std::string& number) const;
  int moving_link_of_number(const Tree& at, const std::string& number) const;
  bool is_line(const std::string& name) const;
  const std::string& letter(int point) const { return built_.letters.points[index(point)]; }
  std::string number(int link) const { return std::to_string(built_.letters.links[index(link)]); }
  void demand_letter(const Tree& at, const std::string& name) const;

  FileReading& of_;
  const File& file_;
  const Tree& root_;
  Built& built_;

 private:
  int place_of_link(const std::string& number) const;
  // "= 20 N m", with its unit as typed; a formula in SI units, or as the file has it where it turns.
  Words equal_to_amount(const Tree& at, geometry::Kind kind) const;
};

}  // namespace epure::scenes
