// A linkage as other programs tell it: joints where they were drawn, and the names of the links that meet in them.
// Numbers are texts, as they were written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/scenes/file/text_tree.h"

namespace epure::scenes {

inline constexpr const char* ground = "ground";

struct DrawnJoint {
  std::string x, y;
  std::vector<std::string> links;
};
// A line of the carrier, through a place of the drawing, in which a pin runs or which blocks follow without turning.
struct DrawnSlide {
  std::string carrier, x, y, along;
  std::optional<std::size_t> pin = {};  // which of the joints
  std::vector<std::string> blocks = {};
};
struct DrawnLinkage {
  Words source;  // "after a ..."
  std::string length_unit;
  std::vector<DrawnJoint> joints = {};
  std::vector<DrawnSlide> slides = {};
  std::optional<std::size_t> input = {};  // the joint where a link is driven; none: the source does not say it
  std::string speed = "1 rad/s";
  std::vector<Words> notes = {};  // what is taken for granted, or left out
};

// Each throws BadScene for what it cannot read, or a scene cannot say.
DrawnLinkage read_pyslvs(const std::string& expression);
DrawnLinkage read_pmks(const std::string& link);

// The file, which is read once, so that it is one; and the notes.
struct Imported {
  std::string scene;
  std::vector<Words> notes;
};
Imported scene_of(DrawnLinkage linkage, const std::string& id);

// `typed` is an expression of pyslvs, a share link of PMKS+, or the name of a file that holds one ("-": standard
// input). Throws BadScene.
Imported import_scene(const std::string& typed, const std::string& id);

}  // namespace epure::scenes
