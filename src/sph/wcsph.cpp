#include "sph/wcsph.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "equations/state.h"

namespace weir {

namespace {

// How far lists reach beyond the support, in particle spacings: wider lists live longer but hold more pairs to reject.
template <int Dim>
constexpr double skin_per_dx = Dim == 2 ? 0.6 : 0.4;

template <int Dim>
std::vector<Vec<Dim, double>> points(const std::vector<Vec3>& positions) {
  std::vector<Vec<Dim, double>> list;
  list.reserve(positions.size());
  for (const Vec3& x : positions) list.push_back(from_scene<Dim, double>(x));
  return list;
}

}  // namespace

template <int Dim>
Wcsph<Dim>::Wcsph(const Scene& scene, const Sampling& sampling, ThreadPool& pool, InstructionSet instruction_set)
    : h_(weir::smoothing_length(scene)),
      support_radius_(weir::support_radius(scene)),
      mass_(weir::particle_mass(scene)),
      rest_density_(scene.fluid.rest_density),
      exponent_(scene.solver.exponent),
      clamp_negative_pressure_(scene.solver.negative_pressure == NegativePressure::clamp),
      pool_(pool),
      instruction_set_(instruction_set),
      loops_(loops_for<Dim>(instruction_set, {.kernel = scene.solver.kernel.name,
                                              .viscosity = scene.fluid.viscosity.model,
                                              .surface_tension = scene.fluid.surface_tension.model,
                                              .wall_slip = scene.solver.wall_slip})),
      controls_{.gravity = from_scene<Dim, double>(scene.gravity),
                .stiffness = weir::stiffness(scene),
                .viscosity = scene.fluid.viscosity.kinematic,
                .surface_tension = scene.fluid.surface_tension.coefficient},
      walls_(unsorted<Dim>(points<Dim>(sampling.wall_positions))),
      neighbours_({.particle_spacing = scene.particle_spacing,
                   .support_radius = support_radius_,
                   .skin = skin_per_dx<Dim> * scene.particle_spacing,
                   .particles = sampling.fluid_positions.size(),
                   .search = scene.solver.neighbour_search,
                   .instruction_set = instruction_set},
                  pool, walls_) {
  reset(sampling);
}

template <int Dim>
void Wcsph<Dim>::reset(const Sampling& sampling) {
  static_cast<Positions<Dim>&>(fluid_) = unsorted<Dim>(points<Dim>(sampling.fluid_positions));
  fluid_.count = sampling.fluid_positions.size();
  double fastest = 0;
  for (int d = 0; d < Dim; ++d) fluid_.velocity[d].assign(fluid_.slots() + group_size, 0.0F);
  for (std::size_t i = 0; i < fluid_.count; ++i) {
    for (int d = 0; d < Dim; ++d) fluid_.velocity[d][i] = static_cast<float>(sampling.fluid_velocities[i][d]);
    const Vec<Dim> v = fluid_.velocity_of(i);
    fastest = std::max(fastest, static_cast<double>(dot(v, v)));
  }
  max_speed_ = std::sqrt(fastest);
  neighbours_.forget();
}

template <int Dim>
void Wcsph<Dim>::find_neighbours() {
  neighbours_.update(fluid_, walls_);
}

template <int Dim>
void Wcsph<Dim>::relist() {
  neighbours_.expire();
  find_neighbours();
}

template <int Dim>
double Wcsph<Dim>::pressure_at(std::size_t slot) const {
  return pressure_of_term(static_cast<double>(fluid_.pressure_term[slot]), static_cast<double>(fluid_.density[slot]));
}

template <int Dim>
void Wcsph<Dim>::compute_density_and_pressure() {
  DensityInput<Dim> input;
  input.pairs = neighbours_.pairs(fluid_, walls_);
  PairLists& near = neighbours_.near_lists();
  input.near_fluid_lists = near.fluid.data();
  input.near_wall_lists = near.walls.data();
  input.walls = walls_.slots() > 0;
  input.h = h_;
  input.m = static_cast<float>(mass_);
  input.rest_density = static_cast<float>(rest_density_);
  input.stiffness = static_cast<float>(controls_.stiffness);
  input.exponent = exponent_;
  input.clamp_negative_pressure = clamp_negative_pressure_;
  input.id = fluid_.id.data();
  input.density = fluid_.density.data();
  input.pressure_term = fluid_.pressure_term.data();
  pool_.for_each(neighbours_.tiling().tiles().size(),
                 [&](std::size_t tile) { loops_.density(input, static_cast<std::int32_t>(tile)); });
}

template <int Dim>
void Wcsph<Dim>::compute_accelerations() {
  AccelerationArguments<Dim> input;
  input.pairs = neighbours_.near_pairs(fluid_, walls_);
  input.h = h_;
  input.m = mass_;
  input.rest_density = static_cast<float>(rest_density_);
  input.exponent = exponent_;
  input.sound_speed = static_cast<float>(sound_speed_of_state(controls_.stiffness, exponent_, rest_density_));
  input.nu = controls_.viscosity;
  input.s = controls_.surface_tension;
  input.id = fluid_.id.data();
  input.density = fluid_.density.data();
  input.pressure_term = fluid_.pressure_term.data();
  for (int d = 0; d < Dim; ++d) {
    input.gravity[d] = static_cast<float>(controls_.gravity[d]);
    input.velocity[d] = fluid_.velocity[d].data();
    input.acceleration[d] = fluid_.acceleration[d].data();
  }
  const bool walls = walls_.slots() > 0;
  std::vector<AccelerationExtremes> extremes(neighbours_.tiling().tiles().size());
  pool_.for_each(extremes.size(), [&](std::size_t index) {
    thread_local AlignedVector<float> sums;
    const auto tile = static_cast<std::int32_t>(index);
    const auto slots = static_cast<std::size_t>(neighbours_.tiling().slots_of(index));
    sums.resize(std::max(sums.size(), sum_width<Dim> * slots));
    AccelerationArguments<Dim> of_tile = input;
    of_tile.sums = sums.data();
    loops_.fluid_acceleration(of_tile, tile);
    if (walls) loops_.wall_acceleration(of_tile, tile);
    extremes[index] = loops_.finish_acceleration(of_tile, tile);
  });
  AccelerationExtremes most;
  for (const AccelerationExtremes& each : extremes) {
    most.acceleration_squared = std::max(most.acceleration_squared, each.acceleration_squared);
    most.signal_speed = std::max(most.signal_speed, each.signal_speed);
  }
  max_acceleration_ = std::sqrt(static_cast<double>(most.acceleration_squared));
  max_signal_speed_ = static_cast<double>(most.signal_speed);
}

template <int Dim>
std::optional<Escape> Wcsph<Dim>::integrate(double dt) {
  IntegrateArguments<Dim> input;
  input.dt = static_cast<float>(dt);
  input.reach = static_cast<float>(step_reach());
  input.tiles = neighbours_.tiling().tiles().data();
  input.id = fluid_.id.data();
  for (int d = 0; d < Dim; ++d) {
    input.acceleration[d] = fluid_.acceleration[d].data();
    input.x[d] = fluid_.x[d].data();
    input.rest[d] = fluid_.rest[d].data();
    input.velocity[d] = fluid_.velocity[d].data();
  }
  std::vector<StepExtremes<Dim>> extremes(neighbours_.tiling().tiles().size());
  pool_.for_each(extremes.size(),
                 [&](std::size_t tile) { extremes[tile] = loops_.integrate(input, static_cast<std::int32_t>(tile)); });

  float fastest = 0;
  bool escaped = false;
  for (std::size_t tile = 0; tile < extremes.size(); ++tile) {
    const StepExtremes<Dim>& of_tile = extremes[tile];
    fastest = std::max(fastest, of_tile.speed_squared);
    escaped = escaped || of_tile.escaped;
    neighbours_.follow(tile, of_tile.moved);
  }
  max_speed_ = std::sqrt(static_cast<double>(fastest));
  return escaped ? find_escaped(dt) : std::nullopt;
}

template <int Dim>
std::optional<Escape> Wcsph<Dim>::find_escaped(double dt) const {
  std::optional<Escape> first;
  for (std::size_t slot = 0; slot < fluid_.slots(); ++slot) {
    if (fluid_.empty(slot) || (first && first->id < fluid_.id[slot])) continue;
    const auto v = convert<double>(fluid_.velocity_of(slot));
    const double distance = dt * std::sqrt(dot(v, v));
    // A little less than the loop's limit, whose rounding differs. Not a number is caught, too.
    if (!(distance <= (1 - 1e-5) * step_reach())) first = Escape{fluid_.id[slot], distance};
  }
  return first;
}

template class Wcsph<2>;
template class Wcsph<3>;

}  // namespace weir
