// Functions that equations need beside + - * /, for scalars. Vector types overload them by the same names.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace weir {

constexpr double pi = 3.14159265358979323846;

template <class R>
constexpr R larger(R a, R b) {
  return a > b ? a : b;
}

// max(x, 0); NaN propagates.
template <class R>
constexpr R positive_part(R x) {
  return larger(R(0), x);
}

// a b + c, rounded once where the type has an instruction for that, else twice; never the compiler's choice.
template <class R>
constexpr R multiply_add(R a, R b, R c) {
  return a * b + c;
}

// c - a b, rounded as multiply_add is.
template <class R>
constexpr R minus_product(R c, R a, R b) {
  return c - a * b;
}

// sum += y, with the rounding error kept in `compensation` and added at the next call (Kahan summation): the pair has
// about twice the digits. |y| must be small against |sum|, or sum zero. [W. Kahan, Further remarks on reducing
// truncation errors, Commun. ACM 8 (1965) 40]
template <class R>
constexpr void compensated_add(R& sum, R& compensation, R y) {
  const R compensated = y + compensation;
  const R total = sum + compensated;
  compensation = compensated - (total - sum);
  sum = total;
}

// Square roots are exactly rounded everywhere (IEEE 754), unlike powers and trigonometric functions, which the state
// must not depend on.
inline float square_root(float x) { return std::sqrt(x); }
inline double square_root(double x) { return std::sqrt(x); }

// 1/x for x > 0 by multiplications alone, to 2^-23 where multiply_add rounds once. An integer subtraction negates the
// exponent and gives a first value within 5.1 % (the constant is optimal over all mantissas); a cubic and a quadratic
// Newton step leave relative errors of 1.3e-4 and 1.7e-8. Invalid for x below 2^-125.
inline float reciprocal_guess(float x) {
  return std::bit_cast<float>(std::int32_t{0x7EF311C0} - std::bit_cast<std::int32_t>(x));
}
template <class R>
R reciprocal_by_products(R x) {
  R y = reciprocal_guess(x);
  R error = minus_product(R(1), x, y);
  y = multiply_add(y, multiply_add(error, error, error), y);
  error = minus_product(R(1), x, y);
  return multiply_add(y, error, y);
}

// a / b for b > 0, to 2 units in the last place; a product with the reciprocal where division is slow.
inline float quotient(float a, float b) { return a / b; }
inline double quotient(double a, double b) { return a / b; }

// x^n by multiplication, n >= 0.
template <class R>
constexpr R integer_power(R x, int n) {
  R result = R(1);
  for (; n > 0; --n) result = result * x;
  return result;
}

}  // namespace weir
