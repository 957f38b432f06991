#include "sph/wcsph.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>

#include "core/parallel.h"
#include "equations/density.h"
#include "equations/state.h"
#include "equations/time_step.h"
#include "sph/pairs.h"

namespace weir {

namespace {

// How far lists reach beyond the support, in particle spacings: wider lists live longer but hold more pairs to reject.
constexpr double skin_per_dx = 0.25;

template <int Dim>
WallParticles<Dim> wall_particles(const Sampling& sampling) {
  WallParticles<Dim> walls;
  for (const Vec3& x : sampling.wall_positions) walls.position.push_back(from_scene<Dim, double>(x));
  return walls;
}

// rho_i = sum_j m_j W_ij, the particle itself and walls included.
template <int Dim, class Kernel>
struct DensityPass {
  const Kernel& kernel;
  Real m;
  FluidParticles<Dim>& particles;

  Real begin(std::size_t) const { return density_contribution(m, kernel.value(Real{0})); }
  void fluid(Real& rho, std::size_t, std::int32_t, const Vec<Dim>&, Real r2) const {
    rho += density_contribution(m, kernel.value(square_root(r2)));
  }
  void wall(Real& rho, std::size_t, std::int32_t, const Vec<Dim>&, Real r2) const {
    rho += density_contribution(m, kernel.value(square_root(r2)));
  }
  void end(std::size_t i, Real rho) const { particles.density[i] = rho; }
};

// a_i = g + the sum over neighbours of what the terms say.
template <int Dim, class Kernel, class... Terms>
struct AccelerationPass {
  const Kernel& kernel;
  Real m;
  Real rest_density;
  Vec<Dim> gravity;
  FluidParticles<Dim>& particles;
  std::tuple<Terms...> terms;

  Vec<Dim> begin(std::size_t) const { return gravity; }

  void fluid(Vec<Dim>& a, std::size_t i, std::int32_t j, const Vec<Dim>& x_ij, Real r2) const {
    const Pair<Dim> pair{.x_ij = x_ij,
                         .v_ij = particles.velocity[i] - particles.velocity[j],
                         .r2 = r2,
                         .dw_over_r = kernel.derivative_over_r(square_root(r2)),
                         .m_j = m,
                         .rho_i = particles.density[i],
                         .rho_j = particles.density[j],
                         .pressure_i = particles.pressure[i],
                         .pressure_j = particles.pressure[j]};
    a += std::apply([&](const Terms&... term) { return fluid_acceleration(pair, term...); }, terms);
  }
  void wall(Vec<Dim>& a, std::size_t i, std::int32_t, const Vec<Dim>& x_ij, Real r2) const {
    const Pair<Dim> pair{.x_ij = x_ij,
                         .v_ij = particles.velocity[i],  // walls are at rest
                         .r2 = r2,
                         .dw_over_r = kernel.derivative_over_r(square_root(r2)),
                         .m_j = m,
                         .rho_i = particles.density[i],
                         .rho_j = rest_density,
                         .pressure_i = particles.pressure[i],
                         .pressure_j = Real{0}};
    a += std::apply([&](const Terms&... term) { return wall_acceleration(pair, term...); }, terms);
  }
  void end(std::size_t i, const Vec<Dim>& a) const { particles.acceleration[i] = a; }
};

using AnyViscosity =
    std::variant<std::monostate, NoSlip<MorrisViscosity>, FreeSlip<MorrisViscosity>, NoSlip<MonaghanViscosity>,
                 FreeSlip<MonaghanViscosity>, NoSlip<SeedAViscosity>, FreeSlip<SeedAViscosity>>;
using AnySurfaceTension = std::variant<std::monostate, SeedASurfaceTension>;

template <class Viscosity>
AnyViscosity with_slip(const Viscosity& viscosity, WallSlip slip) {
  if (slip == WallSlip::no_slip) return NoSlip<Viscosity>{viscosity};
  return FreeSlip<Viscosity>{viscosity};
}

AnyViscosity make_viscosity(ViscosityModel model, WallSlip slip, double nu, double h, int dimension) {
  const auto softening = static_cast<Real>(viscosity_softening * h * h);
  switch (model) {
    case ViscosityModel::none:
      return {};
    case ViscosityModel::morris:
      return with_slip(MorrisViscosity{static_cast<Real>(2 * nu), softening}, slip);
    case ViscosityModel::monaghan:
      return with_slip(MonaghanViscosity{static_cast<Real>(2 * (dimension + 2) * nu), softening}, slip);
    case ViscosityModel::seed_a:
      return with_slip(SeedAViscosity{static_cast<Real>(2 * nu), softening}, slip);
  }
  return {};
}

AnySurfaceTension make_surface_tension(SurfaceTensionModel model, double s) {
  AnySurfaceTension tension;
  if (model == SurfaceTensionModel::seed_a) tension = SeedASurfaceTension{static_cast<Real>(s)};
  return tension;
}

template <int Dim>
double largest_norm(const std::vector<Vec<Dim>>& vectors, Team& team) {
  const Real square = parallel_reduce(
      vectors.size(), team, Real{0},
      [&](std::size_t begin, std::size_t end) {
        Real largest = 0;
        for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, dot(vectors[i], vectors[i]));
        return largest;
      },
      [](Real a, Real b) { return std::max(a, b); });
  return std::sqrt(static_cast<double>(square));
}

}  // namespace

template <int Dim>
typename Wcsph<Dim>::AnyKernel Wcsph<Dim>::make_kernel(KernelName name, double h) {
  if (name == KernelName::wendland_c2) return kernel_at<WendlandC2, Dim>(h);
  return kernel_at<CubicSpline, Dim>(h);
}

template <int Dim>
Wcsph<Dim>::Wcsph(const Scene& scene, const Sampling& sampling, Team& team)
    : h_(weir::smoothing_length(scene)),
      support_radius_(weir::support_radius(scene)),
      dx_(scene.particle_spacing),
      mass_(weir::particle_mass(scene)),
      rest_density_(scene.fluid.rest_density),
      exponent_(scene.solver.exponent),
      clamp_negative_pressure_(scene.solver.negative_pressure == NegativePressure::clamp),
      viscosity_model_(scene.fluid.viscosity.model),
      surface_tension_model_(scene.fluid.surface_tension.model),
      wall_slip_(scene.solver.wall_slip),
      team_(team),
      kernel_(make_kernel(scene.solver.kernel.name, h_)),
      controls_{.gravity = from_scene<Dim, double>(scene.gravity),
                .stiffness = weir::stiffness(scene),
                .viscosity = scene.fluid.viscosity.kinematic,
                .surface_tension = scene.fluid.surface_tension.coefficient},
      walls_(wall_particles<Dim>(sampling)),
      neighbours_(
          {.support_radius = support_radius_, .skin = skin_per_dx * dx_, .search = scene.solver.neighbour_search}, team,
          walls_) {
  reset(sampling);
}

template <int Dim>
void Wcsph<Dim>::reset(const Sampling& sampling) {
  const std::size_t n = sampling.fluid_positions.size();
  fluid_.position.resize(n);
  fluid_.velocity.resize(n);
  fluid_.id.resize(n);
  fluid_.density.assign(n, Real{0});
  fluid_.pressure.assign(n, Real{0});
  fluid_.acceleration.assign(n, Vec<Dim>{});
  for (std::size_t i = 0; i < n; ++i) {
    fluid_.position[i] = from_scene<Dim, double>(sampling.fluid_positions[i]);
    fluid_.velocity[i] = from_scene<Dim, Real>(sampling.fluid_velocities[i]);
    fluid_.id[i] = static_cast<std::int32_t>(i);
  }
  neighbours_.forget();
  max_speed_ = largest_norm<Dim>(fluid_.velocity, team_);
}

template <int Dim>
void Wcsph<Dim>::find_neighbours() {
  neighbours_.update(fluid_, walls_);
}

template <int Dim>
void Wcsph<Dim>::compute_density() {
  std::visit(
      [&](const auto& kernel) {
        const DensityPass<Dim, std::decay_t<decltype(kernel)>> pass{kernel, static_cast<Real>(mass_), fluid_};
        visit_pairs<Dim>(fluid_, walls_, neighbours_, team_, pass);
      },
      kernel_);
}

template <int Dim>
double Wcsph<Dim>::pressure_at(std::size_t i) const {
  const Real rho = fluid_.density[i];
  return static_cast<double>(fluid_.pressure[i]) * rho * rho;
}

template <int Dim>
void Wcsph<Dim>::compute_pressure() {
  const auto k = static_cast<Real>(controls_.stiffness);
  const auto rho0 = static_cast<Real>(rest_density_);
  parallel_blocks(fluid_.size(), team_, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Real rho = fluid_.density[i];
      const Real p = pressure_of_state(rho / rho0, k, exponent_);
      fluid_.pressure[i] = pressure_over_density_squared(clamp_negative_pressure_ ? positive_part(p) : p, rho);
    }
  });
}

template <int Dim>
void Wcsph<Dim>::compute_accelerations() {
  const Pressure pressure{static_cast<Real>(mass_)};
  std::visit(
      [&](const auto& kernel, const auto& viscosity, const auto& tension) {
        using Pass = AccelerationPass<Dim, std::decay_t<decltype(kernel)>, Pressure, std::decay_t<decltype(viscosity)>,
                                      std::decay_t<decltype(tension)>>;
        const Pass pass{
            kernel, static_cast<Real>(mass_),      static_cast<Real>(rest_density_), convert<Real>(controls_.gravity),
            fluid_, {pressure, viscosity, tension}};
        visit_pairs<Dim>(fluid_, walls_, neighbours_, team_, pass);
      },
      kernel_, make_viscosity(viscosity_model_, wall_slip_, controls_.viscosity, h_, Dim),
      make_surface_tension(surface_tension_model_, controls_.surface_tension));
}

template <int Dim>
double Wcsph<Dim>::max_acceleration() const {
  return largest_norm<Dim>(fluid_.acceleration, team_);
}

template <int Dim>
std::optional<Escape> Wcsph<Dim>::integrate(double dt) {
  struct Extremes {
    Real max_speed_squared = 0;
    Escape escape;
  };
  const auto step = static_cast<Real>(dt);
  const Extremes extremes = parallel_reduce(
      fluid_.size(), team_, Extremes{},
      [&](std::size_t begin, std::size_t end) {
        Extremes block;
        for (std::size_t i = begin; i < end; ++i) {
          euler_cromer(fluid_.position[i], fluid_.velocity[i], fluid_.acceleration[i], step);
          const Real speed_squared = dot(fluid_.velocity[i], fluid_.velocity[i]);
          const double distance = dt * std::sqrt(static_cast<double>(speed_squared));
          // Written so that a speed that is not a number is caught, too.
          if (!(distance <= step_reach()) && (block.escape.id < 0 || fluid_.id[i] < block.escape.id)) {
            block.escape = {fluid_.id[i], distance};
          }
          block.max_speed_squared = std::max(block.max_speed_squared, speed_squared);
        }
        return block;
      },
      [](const Extremes& a, const Extremes& b) {
        const bool first = b.escape.id < 0 || (a.escape.id >= 0 && a.escape.id < b.escape.id);
        return Extremes{std::max(a.max_speed_squared, b.max_speed_squared), first ? a.escape : b.escape};
      });
  max_speed_ = std::sqrt(static_cast<double>(extremes.max_speed_squared));
  if (extremes.escape.id < 0) return std::nullopt;
  return extremes.escape;
}

template class Wcsph<2>;
template class Wcsph<3>;

}  // namespace weir
