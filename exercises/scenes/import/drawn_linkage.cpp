#include "exercises/scenes/import/drawn_linkage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/scene_exercise.h"

namespace epure::scenes {
namespace {

constexpr std::size_t most_bytes = 64 << 10, alphabet = 26, most_joints = 10 * alphabet;

class SceneWriter {
 public:
  SceneWriter(DrawnLinkage& linkage, std::string id) : of_(linkage), id_(std::move(id)) {
    if (of_.joints.size() > most_joints)
      throw BadScene(format_words("{} joints are too many: {} at most are imported",
                                  "{} nodi sono troppi: se ne importano al più {}", of_.joints.size(), most_joints));
    number_of(ground);
    for (std::size_t i = 0; i < of_.joints.size(); ++i)
      for (const std::string& link : of_.joints[i].links) add(link, letter(i));
    for (const DrawnSlide& slide : of_.slides) add(slide);
  }

  std::string text() {
    const auto [link, speed] = drive();
    std::string text = fmt::format(
        "epure: 1\nid: {}\ntitle: {{en: Imported mechanism, it: Meccanismo importato}}\n"
        "source: {{en: \"{}\", it: \"{}\"}}\nunits: {{length: {}}}\npoints:\n",
        id_, of_.source.english, of_.source.italian, of_.length_unit);
    for (std::size_t i = 0; i < of_.joints.size(); ++i)
      text += fmt::format("  {}: [{}, {}]\n", letter(i), of_.joints[i].x, of_.joints[i].y);
    text += lines_ + "links:\n";
    for (std::size_t i = 0; i < links_.size(); ++i)
      text += fmt::format("  {}: {}  # {}\n", i + 1, fmt::join(members_[i], " "), links_[i]);
    if (!slides_.empty()) text += "slides:\n";
    for (const auto& [what, guides] : slides_) text += fmt::format("  {}: [{}]\n", what, fmt::join(guides, ", "));
    return text + fmt::format("drive: {{link: {}, speed: {}}}\n", link, speed);
  }
  // "1 = ground, 2 = L1".
  std::string links() const {
    std::string all;
    for (std::size_t i = 0; i < links_.size(); ++i)
      all += fmt::format("{}{} = {}", i == 0 ? "" : ", ", i + 1, links_[i]);
    return all;
  }

 private:
  static std::string letter(std::size_t joint) {
    return numbered(std::string(1, static_cast<char>('A' + joint % alphabet)), joint / alphabet);
  }
  static std::string numbered(const std::string& letter, std::size_t number) {
    return number == 0 ? letter : letter + std::to_string(number);
  }
  std::size_t number_of(const std::string& link) {
    const auto place = static_cast<std::size_t>(std::find(links_.begin(), links_.end(), link) - links_.begin());
    if (place == links_.size()) {
      links_.push_back(link);
      members_.emplace_back();
    }
    return place + 1;
  }
  void add(const std::string& link, const std::string& member) { members_[number_of(link) - 1].push_back(member); }
  std::string add_line(const DrawnSlide& slide, const std::string& link, const std::string& name) {
    lines_ += fmt::format("  {}: {{through: [{}, {}], along: {}}}\n", name, slide.x, slide.y, slide.along);
    add(link, name);
    return name;
  }
  void add(const DrawnSlide& slide) {
    const std::string guide = add_line(slide, slide.carrier, numbered("g", guides_++));
    if (slide.pin) slides_[letter(*slide.pin)].push_back(guide);
    for (const std::string& block : slide.blocks)
      slides_[add_line(slide, block, numbered("b", blocks_++))].push_back(guide);
  }

  struct Driven {
    std::size_t link;
    std::string speed;
  };
  static bool has_ground(const DrawnJoint& joint) {
    return std::find(joint.links.begin(), joint.links.end(), ground) != joint.links.end();
  }
  Driven drive() {
    std::size_t at = of_.input.value_or(0);
    if (!of_.input)
      while (at < of_.joints.size() && !(has_ground(of_.joints[at]) && of_.joints[at].links.size() > 1)) ++at;
    if (at < of_.joints.size())
      for (const std::string& link : of_.joints[at].links) {
        if (link == ground) continue;
        if (!of_.input)
          of_.notes.push_back(
              format_words("the input is not told: link {} is driven in {} at {}; see drive: in the file",
                           "il movente non è detto: si muove il membro {} in {} a {}; vedere drive: nel file",
                           number_of(link), letter(at), of_.speed));
        return {number_of(link), of_.speed};
      }
    throw BadScene("no link is hinged to the ground: there is none to drive",
                   "nessun membro è incernierato al telaio: non ce n'è uno da muovere");
  }

  DrawnLinkage& of_;
  std::string id_;
  std::vector<std::string> links_;                 // the ground first
  std::vector<std::vector<std::string>> members_;  // the letters of each
  std::string lines_;
  std::map<std::string, std::vector<std::string>> slides_;
  std::size_t guides_ = 0, blocks_ = 0;
};

std::string without_blanks_around(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

bool is_expression(const std::string& text) { return text.starts_with("M["); }
bool is_link(const std::string& text) {
  return text.starts_with("https://") || text.starts_with("http://") || text.find("/?") != std::string::npos;
}

}  // namespace

Imported scene_of(DrawnLinkage linkage, const std::string& id) {
  SceneWriter writer(linkage, id);
  Imported made{.scene = writer.text(), .notes = {}};
  made.notes = std::move(linkage.notes);
  try {
    scene_exercise(std::make_shared<const Scene>(id, made.scene));
  } catch (const BadScene& bad) {
    // The file whose place it tells is not there.
    if (bad.without_place.empty()) throw;
    throw BadScene(format_words(
        "{}: {} (its joints are A, B, C ... in their order; its links: {})",
        "{}: {} (i suoi nodi sono A, B, C ... nel loro ordine; i suoi membri: {})",
        Words{"the mechanism that this describes is refused", "il meccanismo che questo descrive è rifiutato"},
        bad.without_place, writer.links()));
  }
  return made;
}

Imported import_scene(const std::string& typed, const std::string& id) {
  std::string text = without_blanks_around(typed);
  if (!is_expression(text) && !is_link(text))
    text = without_blanks_around(bytes_of(typed == "-" ? standard_input : typed));
  if (text.size() > most_bytes)
    throw BadScene(format_words("the text has {} bytes; {} at most are imported",
                                "il testo ha {} byte; se ne importano al più {}", text.size(), most_bytes));
  if (is_expression(text)) return scene_of(read_pyslvs(text), id);
  if (is_link(text)) return scene_of(read_pmks(text), id);
  throw BadScene(
      "this is neither an expression of pyslvs, M[J[...], ...], nor a share link of PMKS+, https://...?...",
      "non è né un'espressione di pyslvs, M[J[...], ...], né un collegamento di PMKS+, https://...?...");
}

}  // namespace epure::scenes
