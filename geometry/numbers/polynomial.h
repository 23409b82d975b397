// Polynomials in one indeterminate with rational coefficients, and their real roots, each isolated from all others
// and known to as many bits as asked.
//
// What is written as a template over the number, with + - * alone, can be run on the indeterminate: the polynomial
// that comes out is what the template is of its argument.
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace epure::geometry {

class RealRoot;

class Polynomial {
 public:
  Polynomial() { fmpq_poly_init(terms_); }
  Polynomial(int value) : Polynomial() { fmpq_poly_set_si(terms_, value); }
  explicit Polynomial(const Rational& value);
  static Polynomial indeterminate();
  Polynomial(const Polynomial& other) : Polynomial() { fmpq_poly_set(terms_, other.terms_); }
  Polynomial& operator=(Polynomial other) noexcept { return fmpq_poly_swap(terms_, other.terms_), *this; }
  ~Polynomial() { fmpq_poly_clear(terms_); }

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);

  // In ascending order, a multiple root once. Not of the polynomial zero.
  std::vector<RealRoot> real_roots() const;

 private:
  fmpq_poly_t terms_;
};

template <>
inline Polynomial from_rational<Polynomial>(const Rational& value) {
  return Polynomial(value);
}
template <>
inline Rational from_rational<Rational>(const Rational& value) {
  return value;
}

// What `find`, which works on Deep, returns with the first precision at which it throws no Undecided. Beyond a number
// of bits that no question of ours needs, its Undecided goes through.
template <class Find>
auto with_enough_bits(const Find& find) {
  for (long bits = 128;; bits *= 2) {
    const Arithmetic<Deep> scope(bits);
    try {
      return find();
    } catch (const Undecided&) {
      if (bits == 65536) throw;
    }
  }
}

class RealRoot {
 public:
  // Where the root is rational, which is always found out.
  const std::optional<Rational>& rational() const { return rational_; }

  // With the bits of the scope that is open, or more.
  Deep value() const;

  // formula(root), of a formula that runs on Rational and on Deep and has no pole at the root. Exact numbers know
  // only what is rational: for others throws Undecided.
  template <class T, class Formula>
  T into(const Formula& formula) const {
    if (rational_) return from_rational<T>(formula(*rational_));
    if constexpr (std::is_same_v<T, Deep>) {
      return formula(value());
    } else if constexpr (std::is_same_v<T, Bounded>) {
      return with_enough_bits([&] { return to_bounded(formula(value())); });
    } else if constexpr (std::is_same_v<T, Fast>) {
      return with_enough_bits([&] { return enclosure(formula(value())).value; });
    } else {
      throw Undecided("an exact number for a root that is only enclosed",
                      "un numero esatto per una radice di cui è noto solo l'intervallo");
    }
  }

  // The sign of formula(root), which is not zero unless the root is rational.
  template <class Formula>
  Sign sign_of(const Formula& formula) const {
    if (rational_) return static_cast<Sign>(static_cast<int>(CGAL::sign(formula(*rational_))));
    return with_enough_bits([&] {
      const Sign found = sign(formula(value()));
      if (found == Sign::undecided)
        throw Undecided("the sign of a polynomial at a root of another",
                        "il segno di un polinomio in una radice di un altro");
      return found;
    });
  }

 private:
  friend class Polynomial;
  // With whole coefficients, and no multiple root.
  struct SquareFree;

  RealRoot(std::shared_ptr<const SquareFree> of, std::size_t number, Deep found, long bits);

  std::shared_ptr<const SquareFree> of_;
  std::size_t number_;  // among the real roots
  Deep found_;
  long bits_;  // to which it was found
  std::optional<Rational> rational_;
};

}  // namespace epure::geometry
