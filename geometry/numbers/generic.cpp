#include "geometry/numbers/generic.h"

#include "geometry/numbers/open_directions.h"
#include "geometry/numbers/turn.h"

#include <cassert>
#include <utility>

namespace epure::geometry {

struct GenericNode {
  enum class Kind { rational, cosine, pi, sum, product, quotient, root };

  Kind kind;
  Rational value = 0;                           // of a rational
  Angle angle = {};                             // of a cosine
  std::shared_ptr<GenericNode> a = {}, b = {};  // what a sum, product, quotient or root is made of
  // What was found of it so far.
  std::optional<Deep> ball = {};
  long bits = 0;  // of the ball
  std::optional<OpenDirections::Element> element = {};

  bool is_rational() const { return kind == Kind::rational; }
  bool is(int number) const { return is_rational() && value == number; }
  void becomes_zero() { *this = {.kind = Kind::rational}; }
};

class GenericContext {
 public:
  // Some tenths of a second at most. What mechanisms ask takes a few thousand.
  static constexpr long most_products = 200000000;

  OpenDirections directions;
  FunctionBudget budget{most_products};
};

namespace {

using Node = GenericNode;
using Made = Node::Kind;
using Element = OpenDirections::Element;
using Shared = std::shared_ptr<Node>;

thread_local GenericContext* innermost_generic = nullptr;

GenericContext& current_context() {
  assert(innermost_generic && "Generic is used without an Arithmetic<Generic> scope");
  return *innermost_generic;
}

Shared rational_node(const Rational& value) {
  return std::make_shared<Node>(Node{.kind = Made::rational, .value = value});
}
Shared made_of(Made kind, const Shared& a, const Shared& b) {
  return std::make_shared<Node>(Node{.kind = kind, .a = a, .b = b});
}

const Deep& ball(Node& x);

Deep computed_ball(Node& x) {
  switch (x.kind) {
    case Made::rational:
      return from_rational<Deep>(x.value);
    case Made::cosine:
      return cosine<Deep>(x.angle);
    case Made::pi:
      return pi<Deep>();
    case Made::sum:
      return ball(*x.a) + ball(*x.b);
    case Made::product:
      return x.a == x.b ? square(ball(*x.a)) : ball(*x.a) * ball(*x.b);
    case Made::quotient:
      return ball(*x.a) / ball(*x.b);
    default:
      return root(ball(*x.a));
  }
}

// In the precision of the Deep scope.
const Deep& ball(Node& x) {
  if (x.bits != Arithmetic<Deep>::bits()) {
    x.ball = computed_ball(x);
    x.bits = Arithmetic<Deep>::bits();
  }
  return *x.ball;
}

Sign sign_by_ball(Node& x, long bits) {
  const Arithmetic<Deep> scope(bits);
  try {
    return sign(ball(x));
  } catch (const Undecided&) {
    return Sign::undecided;  // a divisor that so few bits do not part from zero
  }
}

const Element& element(Node& x);

Element computed_element(Node& x) {
  OpenDirections& open = current_context().directions;
  Tower<RationalFunction>& tower = open.tower();
  switch (x.kind) {
    case Made::rational:
      return Element(RationalFunction(x.value));
    case Made::cosine:
      return open.cosine(x.angle);
    case Made::pi:
      return open.pi();
    case Made::sum:
      return tower.add(element(*x.a), element(*x.b));
    case Made::product:
      return tower.multiply(element(*x.a), element(*x.b));
    case Made::quotient:
      return tower.multiply(element(*x.a), tower.inverse(element(*x.b)));
    default:
      return open.root(element(*x.a));
  }
}

const Element& element(Node& x) {
  if (!x.element) {
    Element found = computed_element(x);
    if (found.is_zero()) x.becomes_zero();
    x.element = std::move(found);
  }
  return *x.element;
}

bool is_zero_for_every_direction(Node& x) {
  try {
    return element(x).is_zero();
  } catch (const Undecided&) {
    return false;  // not proved within the budget
  }
}

Sign sign_of(Node& x) {
  if (x.is_rational()) return static_cast<Sign>(static_cast<int>(CGAL::sign(x.value)));
  for (const long bits : {128L, 512L})
    if (const Sign found = sign_by_ball(x, bits); found != Sign::undecided) return found;
  if (is_zero_for_every_direction(x)) return Sign::zero;
  for (const long bits : {1024L, 4096L})
    if (const Sign found = sign_by_ball(x, bits); found != Sign::undecided) return found;
  return Sign::undecided;
}

}  // namespace

Arithmetic<Generic>::Arithmetic()
    : context_(std::make_unique<GenericContext>()), outer_(std::exchange(innermost_generic, context_.get())) {}
Arithmetic<Generic>::~Arithmetic() { innermost_generic = outer_; }

Generic::Generic(const Rational& value) : node_(rational_node(value)) {}
Generic Generic::pi() { return Generic(std::make_shared<Node>(Node{.kind = Made::pi})); }

Generic Generic::cosine(const Rational& turns, const Rational& radians) {
  if (radians == 0)
    if (const auto known = rational_cosine({turns})) return Generic(*known);
  const Angle angle{within_one_turn(Turn{turns}).fraction, radians};
  current_context().directions.expect(angle);
  return Generic(std::make_shared<Node>(Node{.kind = Made::cosine, .angle = angle}));
}

Generic operator+(const Generic& a, const Generic& b) {
  const Shared &x = a.node_, &y = b.node_;
  if (x->is(0)) return b;
  if (y->is(0)) return a;
  if (x->is_rational() && y->is_rational()) return Generic(x->value + y->value);
  return Generic(made_of(Made::sum, x, y));
}

Generic operator-(const Generic& a, const Generic& b) { return a.node_ == b.node_ ? Generic(0) : a + -b; }

Generic operator*(const Generic& a, const Generic& b) {
  const Shared &x = a.node_, &y = b.node_;
  if (x->is(0) || y->is(1)) return a;
  if (y->is(0) || x->is(1)) return b;
  if (x->is_rational() && y->is_rational()) return Generic(x->value * y->value);
  return Generic(made_of(Made::product, x, y));
}

Generic operator/(const Generic& a, const Generic& b) {
  const Sign divisor = sign(b);
  if (divisor == Sign::zero)
    throw Undecided("division by a quantity that is proved to be zero",
                    "divisione per una grandezza che è zero, come è dimostrato");
  if (divisor == Sign::undecided)
    throw Undecided("division by a quantity that may be zero", "divisione per una grandezza che può essere zero");
  const Shared &x = a.node_, &y = b.node_;
  if (x->is(0) || y->is(1)) return a;
  if (x->is_rational() && y->is_rational()) return Generic(x->value / y->value);
  return Generic(made_of(Made::quotient, x, y));
}

Generic Generic::operator-() const { return Generic(-1) * *this; }

Sign sign(const Generic& x) { return sign_of(*x.node_); }

Deep to_deep(const Generic& x) { return ball(*x.node_); }

Generic root(const Generic& x) {
  const Sign radicand = sign(x);
  assert(radicand != Sign::negative && "root of a number proved negative");
  if (radicand == Sign::zero) return 0;
  if (radicand == Sign::undecided)
    throw Undecided("the root of a quantity that may be zero", "la radice di una grandezza che può essere zero");
  if (x.node_->is_rational())
    if (const auto known = FieldOf<Rational>::root(x.node_->value)) return Generic(CGAL::abs(*known));
  return Generic(made_of(Made::root, x.node_, nullptr));
}

template <>
Generic cosine<Generic>(const Turn& turn) {
  return Generic::cosine(turn.fraction, 0);
}

template <>
Generic sine<Generic>(const Turn& turn) {
  return cosine<Generic>(turn_for_sine(turn));
}

}  // namespace epure::geometry
