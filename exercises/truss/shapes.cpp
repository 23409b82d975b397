#include "exercises/truss/shapes.h"

#include <algorithm>

namespace epure::truss {
namespace {

using geometry::Point;

class Builder {
 public:
  Builder(const Rational& x_B, const Rational& y_B) : built_{{{Rational(0), Rational(0)}, {x_B, y_B}}, {}, {}, {}} {}

  std::size_t joint(const Rational& x, const Rational& y) {
    built_.joints.push_back({x, y});
    return built_.joints.size() - 1;
  }
  Builder& bar(std::size_t from, std::size_t to) {
    built_.bars.push_back({from, to});
    return *this;
  }
  Built loaded(std::vector<std::size_t> by_P, std::vector<std::size_t> by_W) {
    built_.loaded = std::move(by_P);
    built_.windward = std::move(by_W);
    return built_;
  }

 private:
  Built built_;
};

enum class Diagonals { fall_inwards, rise_inwards };
enum class Loads { above, below };

// Posts on a level lower chord of n panels, n even; `top(i)` is the height of the i-th, 0 < i < n. The diagonals of
// both halves are mirror images.
template <class Top>
Built with_posts(const Rational& span, int n, Diagonals diagonals, Loads loads, const Top& top) {
  Builder truss(span, 0);
  std::vector<std::size_t> low{0}, high{0};
  for (int i = 1; i < n; ++i) {
    const Rational x = span * i / n;
    low.push_back(truss.joint(x, 0));
    high.push_back(truss.joint(x, top(i)));
  }
  low.push_back(1);
  high.push_back(1);
  const bool fall = diagonals == Diagonals::fall_inwards;
  for (std::size_t i = 0; i < low.size() - 1; ++i) {
    const bool is_end = i == 0 || i == low.size() - 2, is_left = 2 * i + 1 < low.size();
    truss.bar(low[i], low[i + 1]).bar(high[i], high[i + 1]);
    if (!is_end) {
      if (is_left == fall)
        truss.bar(high[i], low[i + 1]);
      else
        truss.bar(low[i], high[i + 1]);
    }
    if (i + 1 < low.size() - 1) truss.bar(low[i + 1], high[i + 1]);
  }
  const auto inner = [](const std::vector<std::size_t>& chord) {
    return std::vector<std::size_t>(chord.begin() + 1, chord.end() - 1);
  };
  const auto middle = high.begin() + n / 2 + 1;
  return truss.loaded(
      inner(loads == Loads::above ? high : low),
      loads == Loads::above ? std::vector<std::size_t>(high.begin() + 1, middle) : std::vector<std::size_t>{high[1]});
}

Built polonceau(const Rational& L, const Rational& h) {
  Builder truss(L, 0);
  // The struts stand square on the middles of the rafters; their feet lie a sixth of the height above the supports.
  const Rational foot_x = L / 4 + 2 * h * h / (3 * L), foot_y = h / 6;
  const std::size_t left = truss.joint(L / 4, h / 2), top = truss.joint(L / 2, h);
  const std::size_t right = truss.joint(3 * L / 4, h / 2);
  const std::size_t left_foot = truss.joint(foot_x, foot_y), right_foot = truss.joint(L - foot_x, foot_y);
  truss.bar(0, left).bar(left, top).bar(top, right).bar(right, 1);
  truss.bar(0, left_foot).bar(left, left_foot).bar(left_foot, top).bar(left_foot, right_foot);
  truss.bar(top, right_foot).bar(right_foot, right).bar(right_foot, 1);
  return truss.loaded({left, top, right}, {left, top});
}

Built warren(const Rational& L, const Rational& h, int n) {
  Builder truss(L, 0);
  std::vector<std::size_t> low{0}, high;
  for (int i = 0; i < n; ++i) {
    high.push_back(truss.joint(L * (2 * i + 1) / (2 * n), h));
    low.push_back(i + 1 < n ? truss.joint(L * (i + 1) / n, 0) : 1);
  }
  for (std::size_t i = 0; i < high.size(); ++i) {
    truss.bar(low[i], low[i + 1]).bar(low[i], high[i]).bar(high[i], low[i + 1]);
    if (i + 1 < high.size()) truss.bar(high[i], high[i + 1]);
  }
  return truss.loaded({low.begin() + 1, low.end() - 1}, {high.front()});
}

Built bracket(const Rational& L, const Rational& h, int n) {
  Builder truss(0, -h);
  std::vector<std::size_t> high{0}, low{1};
  for (int i = 1; i <= n; ++i) {
    high.push_back(truss.joint(L * i / n, 0));
    low.push_back(i < n ? truss.joint(L * i / n, -h * (n - i) / n) : high.back());
  }
  truss.bar(0, 1);
  for (std::size_t i = 0; i + 1 < high.size(); ++i) {
    truss.bar(high[i], high[i + 1]).bar(low[i], low[i + 1]);
    if (i + 2 < high.size()) truss.bar(high[i], low[i + 1]).bar(high[i + 1], low[i + 1]);
  }
  return truss.loaded({high.begin() + 1, high.end()}, {high.back()});
}

// Mast, back stay, sill, jib and tie.
Built crane(const Rational& L, const Rational& h) {
  Builder truss(-L / 2, 0);
  const std::size_t head = truss.joint(0, h), tip = truss.joint(L, 4 * h / 3);
  truss.bar(0, 1).bar(1, head).bar(0, head).bar(0, tip).bar(head, tip);
  return truss.loaded({tip}, {head});
}

}  // namespace

bool has_panels(Shape shape) { return shape != Shape::polonceau && shape != Shape::crane; }
bool needs_even_panels(Shape shape) { return shape == Shape::roof || shape == Shape::pratt || shape == Shape::howe; }
bool stands_on_wall(Shape shape) { return shape == Shape::bracket; }

Built built(Shape shape, const Rational& span, const Rational& height, int panels) {
  const auto level = [&](int) { return height; };
  switch (shape) {
    case Shape::roof:
      return with_posts(span, panels, Diagonals::fall_inwards, Loads::above,
                        [&](int i) -> Rational { return height * 2 * std::min(i, panels - i) / panels; });
    case Shape::polonceau:
      return polonceau(span, height);
    case Shape::warren:
      return warren(span, height, panels);
    case Shape::pratt:
      return with_posts(span, panels, Diagonals::fall_inwards, Loads::below, level);
    case Shape::howe:
      return with_posts(span, panels, Diagonals::rise_inwards, Loads::below, level);
    case Shape::bracket:
      return bracket(span, height, panels);
    case Shape::crane:
      break;
  }
  return crane(span, height);
}

}  // namespace epure::truss
