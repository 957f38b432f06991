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
