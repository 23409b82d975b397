// Complex numbers, the language of the second route: a point z = x + i y, a quarter turn counter-clockwise is a
// factor i, a velocity is the derivative of a product of exponentials. Plane vectors of the constructions are not
// used here, so that the two routes share nothing but the numbers.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

template <class T>
struct Complex {
  T re{0};
  T im{0};

  friend Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
  friend Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
  friend Complex operator*(const T& s, const Complex& a) { return {s * a.re, s * a.im}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};

template <class T>
Complex<T> conjugate(const Complex<T>& z) {
  return {z.re, -z.im};
}

// i z: z turned counter-clockwise by a right angle.
template <class T>
Complex<T> times_i(const Complex<T>& z) {
  return {-z.im, z.re};
}

// Re(conj(a) b) = |a| |b| cos of the angle from a to b.
template <class T>
T dot(const Complex<T>& a, const Complex<T>& b) {
  return a.re * b.re + a.im * b.im;
}

// Im(conj(a) b) = |a| |b| sin of the angle from a to b: positive when b is counter-clockwise of a.
template <class T>
T cross(const Complex<T>& a, const Complex<T>& b) {
  return a.re * b.im - a.im * b.re;
}

template <class T>
T squared_modulus(const Complex<T>& z) {
  return square(z.re) + square(z.im);
}

template <class T>
T modulus(const Complex<T>& z) {
  return root(squared_modulus(z));
}

// z / s. Throws Undecided when s is zero or not proved different from zero.
template <class T>
Complex<T> divided(const Complex<T>& z, const T& s) {
  return {quotient(z.re, s), quotient(z.im, s)};
}

}  // namespace epure::geometry::analytic
