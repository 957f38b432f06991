// Smoothing kernels W(r) and their derivatives.
//
// [Hinsch24]   J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024: the cubic spline.
// [Wendland95] H. Wendland, Piecewise polynomial, positive definite and compactly supported radial functions of
//              minimal degree, Adv. Comput. Math. 4 (1995) 389-396.
// [Dehnen12]   W. Dehnen, H. Aly, Improving convergence in smoothed particle hydrodynamics simulations without pairing
//              instability, MNRAS 425 (2012) 1068-1082: the normalisation in 1D, 2D and 3D.
//
// Both vanish at q = r/h = 2, smoothly and without a branch: the positive parts do it. The derivative is given as
// W'(r)/r, so that grad W_ij = (W'/r) x_ij needs no division by r where the kernel allows it; at r = 0 the gradient is
// zero. Functions of q take r and 1/h, for n - q is then one operation.
#pragma once

#include "core/math.h"
#include "core/types.h"

namespace weir {

constexpr double support_per_h = 2;  // support_radius / h, for every kernel here

// Typical h/dx: 1.0 (Hinsch 2024) to 1.5.
template <int Dim>
struct CubicSpline {
  // Normalisation, m^-Dim. [Hinsch24 ch. 4.1, alpha]
  static constexpr double alpha(double h) {
    if constexpr (Dim == 1) return 1 / (6 * h);
    if constexpr (Dim == 2) return 5 / (14 * pi * h * h);
    if constexpr (Dim == 3) return 1 / (4 * pi * h * h * h);
  }
  // W / alpha. [Hinsch24 ch. 4.1, W]
  template <class R>
  static R shape(R r, R per_h) {
    const R a = positive_part(minus_product(R(2), per_h, r));
    const R b = positive_part(minus_product(R(1), per_h, r));
    return multiply_add(R(-4), b * b * b, a * a * a);
  }
  // (dW/dq) / (alpha q), without its constant factor. [Hinsch24 ch. 4.2, derivative]
  static constexpr double slope_factor = -3;
  template <class R>
  static R slope_over_q(R r, R per_h) {
    // Below this the quotient has long reached its limit 4, and x_ij, by which it is multiplied, is zero to rounding.
    constexpr float tiny = 1e-12F;
    const R a = positive_part(minus_product(R(2), per_h, r));
    const R b = positive_part(minus_product(R(1), per_h, r));
    return quotient(minus_product(a * a, R(4), b * b), larger(per_h * r, R(tiny)));
  }
};

// Typical h/dx: 1.2 to 2. Stable against pairing at any neighbour number.
template <int Dim>
struct WendlandC2 {
  // Normalisation, m^-Dim. [Dehnen12, C2 normalisation]
  static constexpr double alpha(double h) {
    if constexpr (Dim == 1) return 5 / (8 * h);
    if constexpr (Dim == 2) return 7 / (4 * pi * h * h);
    if constexpr (Dim == 3) return 21 / (16 * pi * h * h * h);
  }
  // W / alpha: (1 - q/2)^4 (1 + 2q), in 1D (1 - q/2)^3 (1 + 3q/2). [Wendland95, C2]
  template <class R>
  static R shape(R r, R per_h) {
    const R t = positive_part(minus_product(R(1), R(0.5) * per_h, r));
    if constexpr (Dim == 1) return t * t * t * multiply_add(R(1.5) * per_h, r, R(1));
    const R t2 = t * t;
    return t2 * t2 * multiply_add(R(2) * per_h, r, R(1));
  }
  // (dW/dq) / (alpha q), without its constant factor: -5 (1 - q/2)^3, in 1D -3 (1 - q/2)^2. [Wendland95, C2 derivative]
  static constexpr double slope_factor = Dim == 1 ? -3 : -5;
  template <class R>
  static R slope_over_q(R r, R per_h) {
    const R t = positive_part(minus_product(R(1), R(0.5) * per_h, r));
    if constexpr (Dim == 1) return t * t;
    return t * t * t;
  }
};

// Typical h/dx: 1.6 to 2.4. Smoother than C2, for fields that are differentiated twice.
template <int Dim>
struct WendlandC4 {
  // Normalisation, m^-Dim. [Dehnen12, C4 normalisation]
  static constexpr double alpha(double h) {
    if constexpr (Dim == 1) return 3 / (4 * h);
    if constexpr (Dim == 2) return 9 / (4 * pi * h * h);
    if constexpr (Dim == 3) return 495 / (256 * pi * h * h * h);
  }
  // W / alpha: (1 - q/2)^6 (1 + 3q + 35/12 q^2), in 1D (1 - q/2)^5 (1 + 5/2 q + 2 q^2). [Wendland95, C4]
  template <class R>
  static R shape(R r, R per_h) {
    const R q = per_h * r;
    const R t = positive_part(minus_product(R(1), R(0.5) * per_h, r));
    const R t2 = t * t;
    if constexpr (Dim == 1) return t2 * t2 * t * multiply_add(multiply_add(R(2), q, R(2.5)), q, R(1));
    return t2 * t2 * t2 * multiply_add(multiply_add(R(35.0 / 12), q, R(3)), q, R(1));
  }
  // (dW/dq) / (alpha q), without its constant factor: -14/3 (1 - q/2)^5 (1 + 5/2 q), in 1D -7/2 (1 - q/2)^4 (1 + 2q).
  // [Wendland95, C4 derivative]
  static constexpr double slope_factor = Dim == 1 ? -3.5 : -14.0 / 3;
  template <class R>
  static R slope_over_q(R r, R per_h) {
    const R t = positive_part(minus_product(R(1), R(0.5) * per_h, r));
    const R t2 = t * t;
    if constexpr (Dim == 1) return t2 * t2 * multiply_add(R(2) * per_h, r, R(1));
    return t2 * t2 * t * multiply_add(R(2.5) * per_h, r, R(1));
  }
};

// A kernel at one smoothing length, times a factor, with its constants worked out. R is the type that the loops compute in.
template <class Shape, class R>
class KernelAt {
 public:
  // `alpha` is the shape's own, times the factor.
  explicit KernelAt(double h, double alpha)
      : per_h_(static_cast<R>(1 / h)),
        alpha_(static_cast<R>(alpha)),
        slope_(static_cast<R>(alpha * Shape::slope_factor / (h * h))) {}

  // W(r), m^-Dim.
  template <class V>
  V value(V r) const {
    return V(alpha_) * shape(r);
  }
  // W(r) / alpha, for sums that are multiplied by alpha once.
  template <class V>
  V shape(V r) const {
    return Shape::shape(r, V(per_h_));
  }
  R alpha() const { return alpha_; }  // m^-Dim
  // W'(r) / r, m^-(Dim + 2); never positive, for a positive factor.
  template <class V>
  V derivative_over_r(V r) const {
    return V(slope_) * slope(r);
  }
  // W'(r) / (r slope_factor()), for sums that are multiplied by it once; never negative.
  template <class V>
  V slope(V r) const {
    return Shape::slope_over_q(r, V(per_h_));
  }
  R slope_factor() const { return slope_; }  // m^-(Dim + 2)

 private:
  R per_h_, alpha_, slope_;
};

template <template <int> class Family, int Dim, class R = Real>
KernelAt<Family<Dim>, R> kernel_at(double h, double factor = 1) {
  return KernelAt<Family<Dim>, R>(h, factor * Family<Dim>::alpha(h));
}

}  // namespace weir
