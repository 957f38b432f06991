// The few functions that equations need beside + - * /, for numbers; a vectorised type brings its own by the same
// names.
#pragma once

#include <cmath>

namespace weir {

constexpr double pi = 3.14159265358979323846;

template <class R>
constexpr R positive_part(R x) {
  return x > R(0) ? x : R(0);
}

// a b + c. Rounded once where the type has an instruction for that, else twice: which, is never left to the compiler.
template <class R>
constexpr R multiply_add(R a, R b, R c) {
  return a * b + c;
}

// sum + y, with the rounding error of the sum kept in `rest` and paid back at the next call: after many small steps the
// pair is as good as twice the digits. |y| must be small against |sum|, or sum zero. [W. Kahan, Further remarks on
// reducing truncation errors, Commun. ACM 8 (1965) 40]
template <class R>
constexpr void compensated_add(R& sum, R& rest, R y) {
  const R owed = y + rest;
  const R total = sum + owed;
  rest = owed - (total - sum);
  sum = total;
}

// Square roots are exactly rounded everywhere (IEEE 754), unlike powers and trigonometry, which state must not use.
inline float square_root(float x) { return std::sqrt(x); }
inline double square_root(double x) { return std::sqrt(x); }

// x^n by multiplication, n >= 0.
template <class R>
constexpr R integer_power(R x, int n) {
  R result = R(1);
  for (; n > 0; --n) result = result * x;
  return result;
}

}  // namespace weir
