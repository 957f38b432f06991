// The loops of WCSPH over one tile, for registers of one instruction set.
#pragma once

#include <type_traits>

#include "equations/density.h"
#include "equations/state.h"
#include "equations/time_step.h"
#include "simd/lanes.h"
#include "sph/engine/engine.h"
#include "sph/engine/list_pairs.h"
#include "sph/engine/visit_pairs.h"

namespace weir::WEIR_INSTRUCTION_SET {

template <int Dim>
void list_pairs(const ListInput<Dim>& in, std::int32_t tile, IntBuffer& fluid_list, IntBuffer& wall_list,
                IntBuffer& scratch) {
  TileLister<Dim>(in, tile, fluid_list, wall_list, scratch).list();
}

// The first slot after the whole registers that hold a tile's particles. A tile ends with a whole group, which is a whole
// number of registers.
WEIR_INLINE std::int32_t end_of_registers(const Tile& slots) {
  return slots.begin + (slots.end - slots.begin + lanes - 1) / lanes * lanes;
}

WEIR_INLINE void fill(float* values, const Tile& slots, float value) {
  for (std::int32_t i = slots.begin; i < end_of_registers(slots); i += lanes) store(Lanes(value), values + i);
}

template <int Dim, template <int> class Kernel>
void density(const DensityInput<Dim>& in, std::int32_t tile) {
  const Tile slots = in.pairs.tiles[tile];
  const auto kernel = kernel_at<Kernel, Dim>(in.h);
  const DensityPass<Dim, KernelAt<Kernel<Dim>, Real>> pass{kernel};
  fill(in.density, slots, kernel.shape(0.0F));  // a particle counts itself
  float* const sums = in.density + slots.begin;
  const auto support_radius = static_cast<float>(support_per_h * in.h);
  narrow(in.pairs.fluid_lists[tile], in.near_fluid_lists[tile], support_radius,
         [&](Narrowed& lists) { visit_fluid<Dim>(in.pairs, tile, pass, sums, lists); });
  if (in.walls) {
    narrow(in.pairs.wall_lists[tile], in.near_wall_lists[tile], support_radius,
           [&](Narrowed& lists) { visit_walls<Dim>(in.pairs, tile, pass, sums, lists); });
  }

  for (std::int32_t i = slots.begin; i < slots.end; i += lanes) {
    const Mask particle = not_negative(in.id + i);
    const Lanes rest_density = in.rest_density;
    const Lanes sum = load(in.density + i);
    const Lanes rho = select(particle, density_contribution(Lanes(in.m), Lanes(kernel.alpha()) * sum), rest_density);
    const Lanes p = pressure_of_state(rho / rest_density, Lanes(in.stiffness), in.exponent);
    const Lanes kept = in.clamp_negative_pressure ? positive_part(p) : p;
    store(rho, in.density + i);
    store(select(particle, pressure_over_density_squared(kept, rho), Lanes()), in.pressure_term + i);
  }
}

template <int Dim>
WEIR_INLINE AccelerationInput<Dim> read_by_pairs(const AccelerationArguments<Dim>& in) {
  AccelerationInput<Dim> read{
      .rest_density = in.rest_density, .velocity = {}, .density = in.density, .pressure_term = in.pressure_term};
  for (int d = 0; d < Dim; ++d) read.velocity[d] = in.velocity[d];
  return read;
}

// A term that a scene lacks.
struct Absent {};

template <int Dim, template <int> class Kernel, class Viscosity, class SurfaceTension>
void fluid_acceleration(const AccelerationArguments<Dim>& in, std::int32_t tile) {
  using K = KernelAt<Kernel<Dim>, Real>;
  const Tile slots = in.pairs.tiles[tile];
  const auto floats = static_cast<std::ptrdiff_t>(sum_width<Dim>) * (end_of_registers(slots) - slots.begin);
  for (std::ptrdiff_t k = 0; k < floats; k += lanes) store(Lanes(), in.sums + k);
  const auto visit = [&](const auto&... terms) {
    const FluidAcceleration<Dim, K, std::remove_cvref_t<decltype(terms)>...> pass{
        kernel_at<Kernel, Dim>(in.h), read_by_pairs(in), {terms...}};
    AsListed lists;
    visit_fluid<Dim>(in.pairs, tile, pass, in.sums, lists);
  };
  constexpr bool viscous = !std::is_same_v<Viscosity, Absent>;
  constexpr bool cohesive = !std::is_same_v<SurfaceTension, Absent>;
  constexpr Pressure pressure;
  if constexpr (viscous && cohesive) {
    visit(pressure, Viscosity::template of<Dim>(in.nu, in.h), SurfaceTension::of(in.s, in.m));
  } else if constexpr (viscous) {
    visit(pressure, Viscosity::template of<Dim>(in.nu, in.h));
  } else if constexpr (cohesive) {
    visit(pressure, SurfaceTension::of(in.s, in.m));
  } else {
    visit(pressure);
  }
}

template <int Dim, template <int> class Kernel, class Viscosity>
void wall_acceleration(const AccelerationArguments<Dim>& in, std::int32_t tile) {
  using K = KernelAt<Kernel<Dim>, Real>;
  const auto visit = [&](const auto&... terms) {
    const WallAcceleration<Dim, K, std::remove_cvref_t<decltype(terms)>...> pass{
        kernel_at<Kernel, Dim>(in.h), read_by_pairs(in), {terms...}};
    AsListed lists;
    visit_walls<Dim>(in.pairs, tile, pass, in.sums, lists);
  };
  constexpr Pressure pressure;
  if constexpr (std::is_same_v<Viscosity, Absent>) {
    visit(pressure);
  } else {
    visit(pressure, Viscosity::template of<Dim>(in.nu, in.h));
  }
}

template <int Dim, template <int> class Kernel>
AccelerationExtremes finish_acceleration(const AccelerationArguments<Dim>& in, std::int32_t tile) {
  const Tile slots = in.pairs.tiles[tile];
  const Lanes factor = kernel_at<Kernel, Dim>(in.h, -in.m).slope_factor();
  const Lanes per_rest_density = 1 / in.rest_density;
  Lanes largest;
  Lanes fastest_signal;
  for (std::int32_t i = slots.begin; i < slots.end; i += lanes) {
    const Mask particle = not_negative(in.id + i);
    const float* const sums = sums_at<Dim>(in.sums, slots.begin, i);
    Lanes square;
    Lanes speed_squared;
    for (int d = 0; d < Dim; ++d) {
      const Lanes sum = load_clusters(sums + cluster * d, cluster * sum_width<Dim>);
      const Lanes a = select(particle, multiply_add(factor, sum, Lanes(in.gravity[d])), Lanes());
      store(a, in.acceleration[d] + i);
      square = multiply_add(a, a, square);
      const Lanes v = load(in.velocity[d] + i);
      speed_squared = multiply_add(v, v, speed_squared);
    }
    largest = larger(largest, square);
    const Lanes ratio = sound_speed_ratio(load(in.density + i) * per_rest_density, in.exponent);
    fastest_signal = larger(fastest_signal, signal_speed(Lanes(in.sound_speed) * ratio, square_root(speed_squared)));
  }
  return {greatest(largest), greatest(fastest_signal)};
}

template <int Dim>
StepExtremes<Dim> integrate(const IntegrateArguments<Dim>& in, std::int32_t tile) {
  const Tile slots = in.tiles[tile];
  Lanes lowest[Dim];
  Lanes highest[Dim];
  Lanes fastest;
  const Lanes dt = in.dt;
  const Lanes limit = in.reach * in.reach;
  bool escaped = false;
  for (std::int32_t i = slots.begin; i < slots.end; i += lanes) {
    // Empty slots stay where they are: all that they read is zero or nowhere. (In a tile's first register they count as
    // particles at rest, which makes lists of a few particles anew a little early.)
    const Mask particle = not_negative(in.id + i);
    Lanes speed_squared;
    for (int d = 0; d < Dim; ++d) {
      Lanes x = load(in.x[d] + i);
      Lanes rest = load(in.rest[d] + i);
      Lanes v = load(in.velocity[d] + i);
      euler_cromer(x, rest, v, load(in.acceleration[d] + i), dt);
      store(x, in.x[d] + i);
      store(rest, in.rest[d] + i);
      store(v, in.velocity[d] + i);
      speed_squared = multiply_add(v, v, speed_squared);
      const bool first_register = i == slots.begin;
      lowest[d] = first_register ? v : select(particle, smaller(lowest[d], v), lowest[d]);
      highest[d] = first_register ? v : select(particle, larger(highest[d], v), highest[d]);
    }
    fastest = larger(fastest, speed_squared);
    // Written so that a speed that is not a number is caught, too.
    escaped = escaped || !all(at_most(dt * dt * speed_squared, limit));
  }
  StepExtremes<Dim> extremes;
  extremes.speed_squared = greatest(fastest);
  extremes.escaped = escaped;
  for (int d = 0; d < Dim; ++d) {
    extremes.moved.least[d] = in.dt * least(lowest[d]);
    extremes.moved.greatest[d] = in.dt * greatest(highest[d]);
  }
  return extremes;
}

template <int Dim, template <int> class Kernel, class Viscosity>
void choose_terms(const Terms& terms, Loops<Dim>& loops) {
  loops.fluid_acceleration = terms.surface_tension == SurfaceTensionModel::hinsch2024
                                 ? fluid_acceleration<Dim, Kernel, Viscosity, Hinsch2024SurfaceTension>
                                 : fluid_acceleration<Dim, Kernel, Viscosity, Absent>;
  // Walls that let the fluid slip exert no friction.
  loops.wall_acceleration = terms.wall_slip == WallSlip::no_slip ? wall_acceleration<Dim, Kernel, Viscosity>
                                                                 : wall_acceleration<Dim, Kernel, Absent>;
}

template <int Dim, template <int> class Kernel>
void choose_viscosity(const Terms& terms, Loops<Dim>& loops) {
  loops.density = density<Dim, Kernel>;
  loops.finish_acceleration = finish_acceleration<Dim, Kernel>;
  switch (terms.viscosity) {
    case ViscosityModel::none:
      return choose_terms<Dim, Kernel, Absent>(terms, loops);
    case ViscosityModel::morris:
      return choose_terms<Dim, Kernel, MorrisViscosity>(terms, loops);
    case ViscosityModel::monaghan:
      return choose_terms<Dim, Kernel, MonaghanViscosity>(terms, loops);
    case ViscosityModel::hinsch2024:
      return choose_terms<Dim, Kernel, Hinsch2024Viscosity>(terms, loops);
  }
}

template <int Dim>
Loops<Dim> loops(const Terms& terms) {
  Loops<Dim> chosen;
  chosen.rows = rows;
  chosen.list_pairs = list_pairs<Dim>;
  chosen.integrate = integrate<Dim>;
  if (terms.kernel == KernelName::wendland_c2) {
    choose_viscosity<Dim, WendlandC2>(terms, chosen);
  } else {
    choose_viscosity<Dim, CubicSpline>(terms, chosen);
  }
  return chosen;
}

}  // namespace weir::WEIR_INSTRUCTION_SET
