// https://app.pmksplus.com/?2P.Ay,1E8.K,0.1011.MA,A,0mv,0VU,0.KD,D,....YRAB,AB,Fe,Fe,0ix,08i,c5cae9,A,B,,....N_v:
// flags, scale, speed and units, then joints, links and forces, each list ended by an empty entry, and a last letter
// that counts the others. Numbers have 64 digits, and are thousandths; one that begins with 0 is negative. The format
// is that of src/app/services/transcoding of PMKS-Web/PMKSWeb.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/import/drawn_linkage.h"

namespace epure::scenes {
namespace {

constexpr std::string_view digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";

[[noreturn]] void refuse(const Words& sentence) {
  throw BadScene(format_words("the link of PMKS+: {}", "il collegamento di PMKS+: {}", sentence));
}
[[noreturn]] void refuse_damaged() {
  refuse({"it is damaged, cut short or of an older PMKS+; copy it from there again",
          "è guasto, tronco o di un PMKS+ più vecchio; copiarlo di nuovo da lì"});
}

long long magnitude(std::string_view text) {
  constexpr std::size_t most_digits = 8;  // 48 bits
  if (text.size() > most_digits) refuse_damaged();
  long long value = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) refuse_damaged();
    value = 64 * value + static_cast<long long>(digit);
  }
  return value;
}
long long whole(std::string_view text) {
  if (text.empty()) refuse_damaged();
  return text.front() == '0' ? -magnitude(text.substr(1)) : magnitude(text);
}
std::string thousandths(long long n) {
  return fmt::format("{}{}.{:03}", n < 0 ? "-" : "", std::abs(n) / 1000, std::abs(n) % 1000);
}

// PMKS+ rounds angles to thousandths of a radian; whole degrees lie 17 of these apart, so one that is the rounding of
// so many degrees is taken for these. (No multiple of π lies within a double's error of half a thousandth.)
std::string angle(long long n) {
  constexpr double degrees_each = 180 / (1000 * std::numbers::pi);
  const long long degrees = std::llround(static_cast<double>(n) * degrees_each);
  const bool is_rounding = std::llround(static_cast<double>(degrees) / degrees_each) == n;
  return is_rounding ? fmt::format("{} deg", degrees) : thousandths(n) + " rad";
}

std::vector<std::string> parted_at(char mark, const std::string& text) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t to; (to = text.find(mark, from)) != std::string::npos; from = to + 1)
    parts.push_back(text.substr(from, to - from));
  parts.push_back(text.substr(from));
  return parts;
}

// Behind the question mark; %20 is a blank.
std::string payload(const std::string& link) {
  const std::size_t mark = link.find('?');
  if (mark == std::string::npos)
    refuse({"nothing stands behind a question mark", "dopo un punto interrogativo non c'è nulla"});
  std::string bytes;
  for (std::size_t i = mark + 1; i < link.size(); ++i) {
    const std::string_view hex = "0123456789ABCDEFabcdef";
    const bool is_escaped = link[i] == '%' && i + 2 < link.size() &&
                            hex.find(link[i + 1]) != std::string_view::npos &&
                            hex.find(link[i + 2]) != std::string_view::npos;
    bytes += is_escaped ? static_cast<char>(std::stoi(link.substr(i + 1, 2), nullptr, 16)) : link[i];
    if (is_escaped) i += 2;
  }
  return bytes;
}

// In the units of UTF-16, in which PMKS+ counts.
std::size_t length_in_utf16(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }) +
                                  std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xf8) == 0xf0; }));
}

class Link {
 public:
  explicit Link(const std::string& link) : all_(parted_at('.', counted(payload(link)))) {}

  DrawnLinkage linkage() {
    read_.source = {"after a link of PMKS+", "da un collegamento di PMKS+"};
    read_settings();
    while (const std::string* entry = next()) read_joint(parted_at(',', *entry));
    while (const std::string* entry = next()) read_link(parted_at(',', *entry));
    for (const Slider& slider : sliders_) read_slide(slider);
    demand_no_welds();
    if (at_ < all_.size() && !all_[at_].empty())
      read_.notes.push_back(
          {"forces are left out; write loads: into the file", "le forze sono tralasciate; scrivere loads: nel file"});
    return std::move(read_);
  }

 private:
  enum Flags { prismatic = 1, input = 2, grounded = 4, welded = 8, sealed = 32 };
  struct Joint {
    std::string id;
    long long x, y;     // thousandths
    std::size_t drawn;  // which of what is read
    bool is_welded;
  };
  struct Slider {
    std::string id;
    DrawnSlide drawn;
    std::vector<std::string> slot = {};  // its link and two of the link's joints; empty: it is the ground's
    std::string pin = {};
  };

  static std::string counted(std::string text) {
    constexpr std::size_t count_of_letters = 62;
    if (text.empty()) refuse_damaged();
    const char last = text.back();
    text.pop_back();
    if (digits[length_in_utf16(text) % count_of_letters] != last) refuse_damaged();
    return text;
  }
  // The next entry of a list; none at its end.
  const std::string* next() {
    if (at_ == all_.size()) refuse_damaged();
    const std::string& entry = all_[at_++];
    return entry.empty() ? nullptr : &entry;
  }
  static const std::string& field(const std::vector<std::string>& of, std::size_t i) {
    if (i >= of.size()) refuse_damaged();
    return of[i];
  }

  void read_settings() {
    constexpr std::size_t settings = 4;
    if (all_.size() < settings) refuse_damaged();
    const bool is_clockwise = magnitude(all_[0]) % 2 == 1;
    const long long rpm = whole(parted_at(',', all_[2]).front());
    read_.speed = fmt::format("{} rpm", is_clockwise ? -rpm : rpm);
    const std::string units = "012", names[] = {"in", "cm", "m"};
    const std::size_t unit = units.find(all_[3].substr(0, 1));
    if (all_[3].empty() || unit == std::string::npos) refuse_damaged();
    read_.length_unit = names[unit];
    at_ = settings;
  }
  // [flags][id],[name],[x],[y],[angle], and of a slot in a moving link that link and two of its joints.
  void read_joint(const std::vector<std::string>& fields) {
    if (fields[0].empty()) refuse_damaged();
    const long long flags = magnitude(fields[0].substr(0, 1));
    const std::string id = fields[0].substr(1);
    const long long x = whole(field(fields, 2)), y = whole(field(fields, 3));
    constexpr std::size_t own_speed = 8;
    if ((flags & sealed) != 0) refuse({"cylinders are not imported yet", "i cilindri non si importano ancora"});
    if ((flags & input) != 0) {
      if ((flags & prismatic) != 0 || (flags & grounded) == 0 || fields.size() > own_speed)
        refuse({"only an input that turns on the ground, at the speed of all, is imported",
                "si importa solo un movente che ruota sul telaio, alla velocità di tutti"});
      if (read_.input)
        refuse({"it has several inputs; only one is imported", "ha più moventi; se ne importa uno solo"});
      read_.input = read_.joints.size();
    }
    if ((flags & prismatic) == 0) {
      joints_.push_back({id, x, y, read_.joints.size(), (flags & welded) != 0});
      read_.joints.push_back({thousandths(x), thousandths(y), {}});
      if ((flags & grounded) != 0) read_.joints.back().links.push_back(ground);
      return;
    }
    Slider slider{
        id, {.carrier = ground, .x = thousandths(x), .y = thousandths(y), .along = angle(whole(field(fields, 4)))}};
    if ((flags & grounded) == 0) slider.slot = {field(fields, 5), field(fields, 6), field(fields, 7)};
    sliders_.push_back(slider);
  }
  // [root?][kind][id],[name],[mass],[inertia],[x],[y],[colour],[joints],,[links that are welded into it].
  void read_link(const std::vector<std::string>& fields) {
    if (fields[0].empty()) refuse_damaged();
    if (std::string_view("YAMG0123").find(fields[0].front()) == std::string_view::npos) {
      if (std::string_view("Namg4567").find(fields[0].front()) == std::string_view::npos) refuse_damaged();
      return;  // a part of one that is welded together
    }
    const bool is_real = fields[0].substr(1, 1) == "R";
    const std::string id = fields[0].substr(std::min<std::size_t>(2, fields[0].size()));
    if (id.empty() || id == ground || id.find_first_not_of(digits) != std::string::npos) refuse_damaged();
    constexpr std::size_t first_joint = 7;
    std::vector<std::string> ids;
    for (std::size_t i = first_joint; !field(fields, i).empty(); ++i) ids.push_back(fields[i]);
    if (is_real) {
      for (const std::string& of : ids) read_.joints[joint(of).drawn].links.push_back(id);
    } else {
      if (ids.size() != 2) refuse_damaged();
      if (is_slider(ids[0])) std::swap(ids[0], ids[1]);
      for (Slider& slider : sliders_)
        if (slider.id == ids[1]) slider.pin = ids[0];
    }
  }
  void read_slide(const Slider& slider) {
    DrawnSlide slide = slider.drawn;
    Joint& pin = joint(slider.pin);
    if (!slider.slot.empty()) {
      const Joint &from = joint(slider.slot[1]), &to = joint(slider.slot[2]);
      const auto& carriers = read_.joints[from.drawn].links;
      if (std::find(carriers.begin(), carriers.end(), slider.slot[0]) == carriers.end()) refuse_damaged();
      slide = {slider.slot[0], thousandths(from.x), thousandths(from.y),
               fmt::format("[{}, {}]", thousandths(to.x - from.x), thousandths(to.y - from.y))};
    }
    const std::vector<std::string>& links = read_.joints[pin.drawn].links;
    if (pin.is_welded && links.size() == 1) {
      slide.blocks = links;
      pin.is_welded = false;
    } else {
      slide.pin = pin.drawn;
    }
    read_.slides.push_back(slide);
  }
  // What is welded into one link is that link; other welds hold what a scene tells by joints alone.
  void demand_no_welds() const {
    for (const Joint& each : joints_)
      if (each.is_welded && read_.joints[each.drawn].links.size() != 1)
        refuse(format_words("the weld in {} is not imported", "la saldatura in {} non si importa", each.id));
  }

  bool is_slider(const std::string& id) const {
    return std::any_of(sliders_.begin(), sliders_.end(), [&](const Slider& slider) { return slider.id == id; });
  }
  Joint& joint(const std::string& id) {
    const auto found = std::find_if(joints_.begin(), joints_.end(), [&](const Joint& each) { return each.id == id; });
    if (found == joints_.end()) refuse_damaged();
    return *found;
  }

  std::vector<std::string> all_;
  std::size_t at_ = 0;
  std::vector<Joint> joints_;
  std::vector<Slider> sliders_;
  DrawnLinkage read_ = {};
};

}  // namespace

DrawnLinkage read_pmks(const std::string& link) { return Link(link).linkage(); }

}  // namespace epure::scenes
