// The loops of one step that are built once per instruction set, and the choice among them.
#pragma once

#include <cstdint>

#include "core/types.h"
#include "scene/scene.h"
#include "simd/instruction_set.h"
#include "sph/pair_lists.h"

namespace weir {

// Makes the lists of one tile of the fluid.
template <int Dim>
using ListPairs = void (*)(const ListInput<Dim>& in, std::int32_t tile, IntBuffer& fluid_list, IntBuffer& wall_list,
                           IntBuffer& scratch);

// Densities of one tile, and p / rho^2 from them; and the lists without what is beyond the support, for loops over the
// same places.
template <int Dim>
struct DensityInput {
  PairInput<Dim> pairs;
  IntBuffer* near_fluid_lists = nullptr;  // per tile
  IntBuffer* near_wall_lists = nullptr;
  bool walls = false;  // whether there are any
  double h = 0;        // m
  float m = 0;         // kg
  float rest_density = 0;
  float stiffness = 0;  // k, Pa
  int exponent = 0;
  bool clamp_negative_pressure = false;
  const std::int32_t* id = nullptr;
  float* density = nullptr;
  float* pressure_term = nullptr;  // p / rho^2
};
template <int Dim>
using ComputeDensity = void (*)(const DensityInput<Dim>& in, std::int32_t tile);

// Accelerations of one tile: sums over the fluid and over walls, then those, scaled, and gravity.
template <int Dim>
struct AccelerationArguments {
  PairInput<Dim> pairs;  // near lists do
  double h = 0;          // m
  double m = 0;          // kg
  float rest_density = 0;
  int exponent = 0;
  float sound_speed = 0;  // at rest density, m/s
  double nu = 0;          // m^2/s
  double s = 0;           // of the surface tension, m^(Dim + 2)/s^2
  float gravity[Dim] = {};
  const std::int32_t* id = nullptr;
  const float* density = nullptr;
  const float* pressure_term = nullptr;
  const float* velocity[Dim] = {};
  float* sums = nullptr;  // of the tile's pairs, room for sum_width<Dim> floats a slot up to the end of a group
  float* acceleration[Dim] = {};
};
template <int Dim>
using AddAcceleration = void (*)(const AccelerationArguments<Dim>& in, std::int32_t tile);
// What bounds the time step, the largest of a tile's particles.
struct AccelerationExtremes {
  float acceleration_squared = 0;  // m^2/s^4
  float signal_speed = 0;          // m/s
};
template <int Dim>
using FinishAcceleration = AccelerationExtremes (*)(const AccelerationArguments<Dim>& in, std::int32_t tile);

// What moving a tile's particles by one step found.
template <int Dim>
struct StepExtremes {
  float speed_squared = 0;  // largest, m^2/s^2
  DisplacementBox<Dim> moved;
  bool escaped = false;  // a particle moved farther than `reach`, or is not finite
};
template <int Dim>
struct IntegrateArguments {
  float dt = 0;     // s
  float reach = 0;  // m
  const Tile* tiles = nullptr;
  const std::int32_t* id = nullptr;
  const float* acceleration[Dim] = {};
  float* x[Dim] = {};
  float* rest[Dim] = {};
  float* velocity[Dim] = {};
};
template <int Dim>
using Integrate = StepExtremes<Dim> (*)(const IntegrateArguments<Dim>& in, std::int32_t tile);

// Which terms a scene has; loops exist for each choice, so that absent ones cost nothing.
struct Terms {
  KernelName kernel = KernelName::cubic_spline;
  ViscosityModel viscosity = ViscosityModel::none;
  SurfaceTensionModel surface_tension = SurfaceTensionModel::none;
  WallSlip wall_slip = WallSlip::no_slip;
};

template <int Dim>
struct Loops {
  int rows = 0;  // particles that are listed and visited together
  ListPairs<Dim> list_pairs = nullptr;
  ComputeDensity<Dim> density = nullptr;
  AddAcceleration<Dim> fluid_acceleration = nullptr;
  AddAcceleration<Dim> wall_acceleration = nullptr;
  FinishAcceleration<Dim> finish_acceleration = nullptr;
  Integrate<Dim> integrate = nullptr;
};

// `set` must be usable.
template <int Dim>
Loops<Dim> loops_for(InstructionSet set, const Terms& terms);

}  // namespace weir
