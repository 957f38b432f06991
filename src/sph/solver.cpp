#include "sph/solver.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/trace.h"
#include "equations/state.h"
#include "equations/vorticity.h"

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

template <int Dim>
Periodicity<Dim> periodicity(const Scene& scene) {
  Periodicity<Dim> periodic;
  const Bounds extent = periodic_extent(scene);
  for (int d = 0; d < Dim; ++d) {
    if (!is_periodic(scene, d)) continue;
    periodic.start[d] = extent.min[d];
    periodic.length[d] = extent.max[d] - extent.min[d];
  }
  return periodic;
}

}  // namespace

template <int Dim>
SphSolver<Dim>::SphSolver(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                          InstructionSet instruction_set)
    : constants_(scene, instruction_set),
      time_step_(scene.solver.time_step),
      parameters_(initial_parameters(scene)),
      fields_(fluid_),
      wall_fields_(walls_, constants_),
      search_({.particle_spacing = scene.particle_spacing,
               .support_radius = constants_.support_radius,
               .skin = skin_per_dx<Dim> * scene.particle_spacing,
               .particles = sampling.fluid_positions.size(),
               .periodic = periodicity<Dim>(scene),
               .instruction_set = instruction_set},
              pool),
      engine_(instruction_set, constants_.support_radius, search_, pool),
      stages_(constants_, fluid_, walls_, fields_, wall_fields_) {
  bounds_.h = constants_.h;
  bounds_.diffusivity = diffusivity();
  walls_.start_at(points<Dim>(sampling.wall_positions));
  for (std::size_t i = 0; i < sampling.wall_depths.size() && wall_fields_.depth != nullptr; ++i) {
    wall_fields_.depth->data()[i] = static_cast<float>(sampling.wall_depths[i]);
  }
  for (std::size_t i = 0; i < sampling.wall_velocities.size() && wall_fields_.slide != nullptr; ++i) {
    for (int d = 0; d < Dim; ++d) {
      wall_fields_.slide->data(d)[i] = static_cast<float>(sampling.wall_velocities[i][d]);
    }
  }
  search_.add(fluid_, Mobility::moving);
  search_.add(walls_, Mobility::fixed);
  search_.list(fluid_, fluid_);
  search_.list(fluid_, walls_);
  if (constants_.extrapolated) search_.list(walls_, fluid_);
}

template <int Dim>
void SphSolver<Dim>::reset(const Sampling& sampling) {
  fluid_.start_at(points<Dim>(sampling.fluid_positions));
  double fastest = 0;
  for (std::size_t i = 0; i < fluid_.count; ++i) {
    for (int d = 0; d < Dim; ++d) {
      fields_.velocity.data(d)[i] = static_cast<float>(sampling.fluid_velocities[i][d]);
    }
    const Vec<Dim> v = fluid_.vector_at(fields_.velocity, i);
    fastest = std::max(fastest, static_cast<double>(dot(v, v)));
  }
  bounds_.max_speed = std::sqrt(fastest);
  start(sampling);
  search_.forget();
  fresh_ = false;
}

template <int Dim>
void SphSolver<Dim>::refresh() {
  if (fresh_) return;
  search_.update();
  recompute();
  fresh_ = true;
}

template <int Dim>
void SphSolver<Dim>::set(const Parameters& parameters) {
  // Only a new stiffness changes what refresh() has worked out, and gravity where walls weigh the fluid; the rest acts in
  // the next accelerations.
  if (parameters.stiffness != parameters_.stiffness) fresh_ = false;
  if (constants_.extrapolated && parameters.gravity != parameters_.gravity) fresh_ = false;
  parameters_ = parameters;
  bounds_.diffusivity = diffusivity();
}

template <int Dim>
std::optional<double> SphSolver<Dim>::diffusivity() const {
  switch (constants_.viscosity) {
    case ViscosityModel::none:
      return std::nullopt;
    case ViscosityModel::monaghan:
    case ViscosityModel::artificial:
      return central_diffusivity(parameters_.viscosity);
    case ViscosityModel::morris:
    case ViscosityModel::hinsch2024:
      break;
  }
  return parameters_.viscosity;
}

template <int Dim>
const Field& SphSolver<Dim>::vorticity() {
  if (vorticity_ == nullptr) {
    vorticity_ = &fluid_.add("vorticity", "1/s", rotation_components<Dim>, Keeping::recomputed);
    for (auto& component : vorticity_->values) component.resize(fluid_.slots() + group_size);
  }
  refresh();
  stages_.compute_vorticity(engine_, fluid_, *vorticity_);
  return *vorticity_;
}

template <int Dim>
double SphSolver<Dim>::pressure_at(std::size_t slot) const {
  return pressure_of_term(static_cast<double>(fields_.pressure_term.at(slot)),
                          static_cast<double>(fields_.density.at(slot)));
}

template <int Dim>
StepChoice SphSolver<Dim>::longest_step() const {
  return choose_step(time_step_, bounds_);
}

template <int Dim>
void SphSolver<Dim>::bound_by(const ForceExtremes& extremes) {
  bounds_.max_acceleration = std::sqrt(static_cast<double>(extremes.acceleration_squared));
  bounds_.max_signal_speed = static_cast<double>(extremes.signal_speed);
}

template <int Dim>
std::optional<Runaway> SphSolver<Dim>::moved(const MotionExtremes<Dim>& extremes, double dt) {
  fresh_ = false;
  bounds_.max_speed = std::sqrt(static_cast<double>(extremes.speed_squared));
  std::optional<Runaway> first;
  if (!extremes.runaway) return first;
  for (std::size_t slot = 0; slot < fluid_.slots(); ++slot) {
    if (fluid_.empty(slot) || (first && first->id < fluid_.id[slot])) continue;
    const auto v = convert<double>(fluid_.vector_at(fields_.velocity, slot));
    const double distance = dt * std::sqrt(dot(v, v));
    // A little less than the loop's limit, whose rounding differs. NaN is caught, too.
    if (!(distance <= (1 - 1e-5) * step_reach())) first = Runaway{fluid_.id[slot], distance};
  }
  return first;
}

template <int Dim>
std::unique_ptr<SphSolver<Dim>> make_solver(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                                            InstructionSet instruction_set) {
  switch (scene.solver.method) {
    case Method::delta_sph:
      return make_delta_sph<Dim>(scene, sampling, pool, instruction_set);
    case Method::wcsph:
      break;
  }
  return make_wcsph<Dim>(scene, sampling, pool, instruction_set);
}

template class SphSolver<2>;
template class SphSolver<3>;
template std::unique_ptr<SphSolver<2>> make_solver<2>(const Scene&, const Sampling&, ThreadPool&, InstructionSet);
template std::unique_ptr<SphSolver<3>> make_solver<3>(const Scene&, const Sampling&, ThreadPool&, InstructionSet);

}  // namespace weir
