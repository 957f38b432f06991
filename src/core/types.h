// Number and vector types.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/math.h"

namespace weir {

// Per-particle quantities and pair sums.
using Real = float;

// A vector of the solver. T is a number or, in vectorised loops, a register of numbers, which GLM's vectors do not
// support.
template <int Dim, class T = Real>
struct Vec {
  T e[Dim];

  constexpr T& operator[](int d) { return e[d]; }
  constexpr const T& operator[](int d) const { return e[d]; }

  constexpr Vec& operator+=(const Vec& b) {
    for (int d = 0; d < Dim; ++d) e[d] += b.e[d];
    return *this;
  }
  friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend constexpr Vec operator-(const Vec& a, const Vec& b) {
    Vec c{};
    for (int d = 0; d < Dim; ++d) c.e[d] = a.e[d] - b.e[d];
    return c;
  }
  friend constexpr Vec operator*(const T& s, Vec a) {
    for (int d = 0; d < Dim; ++d) a.e[d] *= s;
    return a;
  }
  friend constexpr T dot(const Vec& a, const Vec& b) {
    T sum = a.e[0] * b.e[0];
    for (int d = 1; d < Dim; ++d) sum = multiply_add(a.e[d], b.e[d], sum);
    return sum;
  }
};

template <class To, int Dim, class From>
constexpr Vec<Dim, To> convert(const Vec<Dim, From>& a) {
  Vec<Dim, To> b{};
  for (int d = 0; d < Dim; ++d) b[d] = static_cast<To>(a[d]);
  return b;
}

// A point or vector of the scene, in metres or the unit stated; z is 0 in 2D.
using Vec3 = glm::dvec3;

template <int Dim, class T>
constexpr Vec<Dim, T> from_scene(const Vec3& a) {
  Vec<Dim, T> b{};
  for (int d = 0; d < Dim; ++d) b[d] = static_cast<T>(a[d]);
  return b;
}

struct Bounds {
  Vec3 min{0};
  Vec3 max{0};
};

}  // namespace weir
