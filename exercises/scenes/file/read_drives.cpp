#include "exercises/scenes/file/sections.h"

#include <array>

#include "exercises/kit/statement/format_words.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

// drive:, assembly:.
class DrivesReader : SectionReader {
 public:
  using SectionReader::SectionReader;

  void drives() {
    const Tree* drive = root_.find("drive");
    if (!drive)
      refuse(root_, {"drive: is missing; what moves the mechanism?", "manca drive:; che cosa muove il meccanismo?"});
    if (drive->kind == Tree::Kind::list)
      for (const Tree& one : drive->items) this->drive(one);
    else
      this->drive(*drive);
  }
  void assembly() {
    const Tree* all = root_.find("assembly");
    if (!all) return;
    file_.map(*all, {"assembly: {B: left of A B0}", "assembly: {B: left of A B0}"});
    for (const auto& [key, value] : all->entries) {
      const std::vector<std::string> words = parted(file_.text(
          value, {"a side is asked here, such as: left of A B0", "qui si chiede un lato, come: left of A B0"}));
      of_.chosen_at.push_back(&key);
      built_.linkage.chosen.push_back(choice(key, value, words));
    }
  }

 private:
  void drive(const Tree& at) {
    file_.map(at,
              {"drive: {link: 2, angle: 30 deg, speed: 60 rpm}", "drive: {link: 2, angle: 30 deg, speed: 60 rpm}"});
    if (at.find("link")) return turned(at);
    if (at.find("slide")) return slid(at);
    if (at.find("length")) return stretched(at);
    refuse(at, {"a drive has link:, slide: or length:", "drive vuole link:, slide: o length:"});
  }
  Rational rate(const Tree& drive, const std::string& key, Kind kind) const {
    const Tree* value = drive.find(key);
    return value ? amount(*value, kind).value : Rational(0);
  }
  // Where a drive stands ("angle of link 2", under this key), and its rates.
  void tell_of(const Tree& drive, const Words& stands, const Words& of, const char* key,
               const std::array<Kind, 3>& kinds) const {
    tell(stands + of, drive.find(key), kinds[0]);
    tell(Words{"speed", "velocità"} + of, drive.find("speed"), kinds[1]);
    tell(Words{"acceleration", "accelerazione"} + of, drive.find("acceleration"), kinds[2]);
  }
  void turned(const Tree& at) {
    file_.demand_keys(at, {"link", "angle", "speed", "acceleration"});
    const Tree& number = demand(at, "link");
    tell_of(at, {"angle", "angolo"}, format_words(" of link {}", " del membro {}", number.text), "angle",
            {Kind::angle, Kind::angular_velocity, Kind::angular_acceleration});
    built_.linkage.drives.push_back(TurnedLink{
        moving_link_of_number(number, number.text), turning(at, "angle", Kind::angle),
        turning(at, "speed", Kind::angular_velocity), turning(at, "acceleration", Kind::angular_acceleration)});
  }
  void slid(const Tree& at) {
    file_.demand_keys(at, {"slide", "on", "at", "speed", "acceleration"});
    const Tree &joint = demand(at, "slide"), &on = demand(at, "on");
    const Words what{"a letter is asked here", "qui si chiede una lettera"};
    tell_of(at, {"place", "posizione"},
            format_words(" of ${}$ on ${}$", " di ${}$ su ${}$", point_letters(joint.text), point_letters(on.text)),
            "at", {Kind::length, Kind::velocity, Kind::acceleration});
    built_.linkage.drives.push_back(SlidPoint{point(joint, file_.text(joint, what)), line(on, file_.text(on, what)),
                                              length(demand(at, "at")), rate(at, "speed", Kind::velocity),
                                              rate(at, "acceleration", Kind::acceleration)});
  }
  void stretched(const Tree& at) {
    file_.demand_keys(at, {"length", "is", "speed", "acceleration"});
    const Tree& ends_at = demand(at, "length");
    const std::vector<std::string> ends =
        parted(file_.text(ends_at, {"two letters are asked, such as A0 B", "si chiedono due lettere, come A0 B"}));
    if (ends.size() != 2)
      refuse(ends_at, {"two letters are asked, such as A0 B", "si chiedono due lettere, come A0 B"});
    const Tree& is = demand(at, "is");
    const Rational far = length(is);
    if (far <= 0)
      refuse(is, format_words("the cylinder {} must be longer than zero",
                              "il cilindro {} dev'essere più lungo di zero", ends_at.text));
    const std::string cylinder = point_letters(ends[0]) + point_letters(ends[1]);
    tell_of(at, {"length", "lunghezza"}, format_words(" of ${}$", " di ${}$", cylinder), "is",
            {Kind::length, Kind::velocity, Kind::acceleration});
    built_.linkage.drives.push_back(Stretched{point(ends_at, ends[0]), point(ends_at, ends[1]), far,
                                              rate(at, "speed", Kind::velocity),
                                              rate(at, "acceleration", Kind::acceleration)});
  }
  Chosen choice(const Tree& key, const Tree& value, const std::vector<std::string>& words) const {
    const auto is = [&](std::size_t k, const char* word) { return k < words.size() && words[k] == word; };
    if (words.size() == 4 && (is(0, "left") || is(0, "right")) && is(1, "of"))
      return BesideLine{point(key, key.text), point(value, words[2]), point(value, words[3]), is(0, "left")};
    if (words.size() == 3 && (is(0, "ahead") || is(0, "behind")) && is(1, "on")) {
      return OnGuide{point(key, key.text), is(0, "ahead"), line(value, words[2])};
    }
    if (words.size() == 4 && is(0, "from") && is(2, "towards"))
      return SlotPoints{line(key, key.text), true, point(value, words[1]), point(value, words[3])};
    if (words.size() == 5 && is(0, "from") && is(2, "away") && is(3, "from"))
      return SlotPoints{line(key, key.text), false, point(value, words[1]), point(value, words[4])};
    refuse(
        value,
        {"a side reads: left of A B0, right of A B0, ahead on g, behind on g, from O towards A, from O away from A",
         "un lato si scrive: left of A B0, right of A B0, ahead on g, behind on g, from O towards A, from O away "
         "from A"});
  }
};

}  // namespace

void read_drives(FileReading& of) {
  DrivesReader reader(of);
  reader.drives();
  reader.assembly();
}

}  // namespace epure::scenes
