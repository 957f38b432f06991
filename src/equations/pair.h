// What a formula between two particles may use. The pair engine fills it; loads that no formula needs are dropped by
// the compiler.
#pragma once

#include "core/math.h"
#include "core/types.h"

namespace weir {

// i is the particle, j its neighbour, ij is i minus j. R is a number, or a register of them.
template <int Dim, class R = Real>
struct Pair {
  Vec<Dim, R> x_ij;  // m
  Vec<Dim, R> v_ij;  // m/s
  R r2;              // |x_ij|^2, m^2
  R f;               // F_ij = -m_j W'(r) / r: m_j grad W_ij = -F_ij x_ij, kg m^-(Dim + 2); never negative. Each term is
                     // linear in it, so that loops may leave a constant factor to the end
  R rho_i;           // kg/m^Dim
  R rho_j;           // the rest density for a wall
  R pressure_term_i;  // p_i / rho_i^2, m^5/(kg s^2) in 3D
  R pressure_term_j;  // p_j / rho_j^2; unused with a mirroring wall
};

// What a term says of a pair: the acceleration of i along x_ij, or along v_ij, whose factor this is. Factors are added
// before they multiply a vector.
template <class R>
struct Central {
  R factor;  // s^-2
};
template <class R>
struct Drag {
  R factor;  // s^-1
};
template <class R>
struct CentralAndDrag {
  R central;
  R drag;
};
template <class R>
Central<R> operator+(Central<R> a, Central<R> b) {
  return {a.factor + b.factor};
}
template <class R>
CentralAndDrag<R> operator+(Central<R> a, Drag<R> b) {
  return {a.factor, b.factor};
}
template <class R>
CentralAndDrag<R> operator+(CentralAndDrag<R> a, Central<R> b) {
  return {a.central + b.factor, a.drag};
}

// m/s^2
template <int Dim, class R>
Vec<Dim, R> acceleration(const Pair<Dim, R>& pair, Central<R> a) {
  return a.factor * pair.x_ij;
}
template <int Dim, class R>
Vec<Dim, R> acceleration(const Pair<Dim, R>& pair, Drag<R> a) {
  return a.factor * pair.v_ij;
}
template <int Dim, class R>
Vec<Dim, R> acceleration(const Pair<Dim, R>& pair, CentralAndDrag<R> a) {
  Vec<Dim, R> sum;
  for (int d = 0; d < Dim; ++d) sum[d] = multiply_add(a.drag, pair.v_ij[d], a.central * pair.x_ij[d]);
  return sum;
}

}  // namespace weir
