#include "sph/stages.h"

#include "sph/passes/continuity.h"
#include "sph/passes/vorticity.h"
#include "sph/passes/wall_state.h"

namespace weir {

namespace {

// make.template operator()<Kernel>() for the kernel of this name.
template <class Make>
auto with_kernel(KernelName name, const Make& make) {
  switch (name) {
    case KernelName::wendland_c2:
      return make.template operator()<WendlandC2>();
    case KernelName::wendland_c4:
      return make.template operator()<WendlandC4>();
    case KernelName::cubic_spline:
      break;
  }
  return make.template operator()<CubicSpline>();
}

template <int Dim>
Vec<Dim, Real> vector_of(const Vec3& value) {
  return from_scene<Dim, Real>(value);
}

template <int Dim>
void point_at(Field& field, float* (&components)[Dim]) {
  for (int d = 0; d < Dim; ++d) components[d] = field.data(d);
}

}  // namespace

FluidConstants::FluidConstants(const Scene& scene, InstructionSet set)
    : instruction_set(set),
      kernel(scene.solver.kernel.name),
      viscosity(scene.fluid.viscosity.model),
      cohesive(scene.fluid.surface_tension.model != SurfaceTensionModel::none),
      no_slip(scene.solver.wall_slip == WallSlip::no_slip && viscosity != ViscosityModel::none),
      extrapolated(scene.solver.wall_pressure == WallPressure::extrapolated),
      h(weir::smoothing_length(scene)),
      support_radius(weir::support_radius(scene)),
      spacing(scene.particle_spacing),
      mass(weir::particle_mass(scene)),
      rest_density(scene.fluid.rest_density),
      exponent(scene.solver.exponent),
      clamp_negative_pressure(scene.solver.negative_pressure == NegativePressure::clamp) {}

StateEquation FluidConstants::state(double stiffness) const {
  return {.rest_density = static_cast<Real>(rest_density),
          .stiffness = static_cast<Real>(stiffness),
          .exponent = exponent,
          .clamp = clamp_negative_pressure};
}

template <int Dim>
FluidFields<Dim>::FluidFields(ParticleSet<Dim>& fluid)
    : velocity(fluid.add("velocity", "m/s", Dim, Keeping::carried)),
      density(fluid.add("density", "kg/m^3", 1, Keeping::recomputed)),
      pressure_term(fluid.add("pressure_term", "m^5/(kg s^2)", 1, Keeping::recomputed)),
      acceleration(fluid.add("acceleration", "m/s^2", Dim, Keeping::recomputed)) {}

template <int Dim>
WallFields<Dim>::WallFields(ParticleSet<Dim>& walls, const FluidConstants& constants) {
  if (!constants.extrapolated) return;
  density = &walls.add("density", "kg/m^3", 1, Keeping::recomputed);
  pressure_term = &walls.add("pressure_term", "m^5/(kg s^2)", 1, Keeping::recomputed);
  if (!constants.no_slip) return;
  depth = &walls.add("depth", "m", 1, Keeping::carried);
  slide = &walls.add("slide", "m/s", Dim, Keeping::carried);
  velocity = &walls.add("velocity", "m/s", Dim, Keeping::recomputed);
}

template <int Dim>
MomentumInput<Dim> Stages<Dim>::of_fluid() const {
  return {.velocity = vector_input<Dim>(fields_.velocity),
          .density = fields_.density.data(),
          .pressure_term = fields_.pressure_term.data()};
}

template <int Dim>
MomentumInput<Dim> Stages<Dim>::of_walls() const {
  MomentumInput<Dim> input{
      .velocity = {}, .density = wall_fields_.density->data(), .pressure_term = wall_fields_.pressure_term->data()};
  // Without friction no term reads velocities of walls, and there are none.
  if (wall_fields_.velocity != nullptr) input.velocity = vector_input<Dim>(*wall_fields_.velocity);
  return input;
}

template <int Dim>
PairStage<Dim> Stages<Dim>::density(const ParticleSet<Dim>& source) const {
  return with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    using Pass = DensityPass<Dim, Kernel>;
    const Pass pass{.kernel = kernel_at<Kernel, Dim>(constants_.h)};
    return &source == &fluid_ ? PairStage<Dim>::template of<Within<Pass>>(constants_.instruction_set, pass, source)
                              : PairStage<Dim>::template of<Between<Pass>>(constants_.instruction_set, pass, source);
  });
}

// make(viscosity...): with no argument where there is none.
template <int Dim>
template <class Make>
PairStage<Dim> Stages<Dim>::with_viscosity(bool viscous, double nu, const Make& make) const {
  const double h = constants_.h;
  switch (viscous ? constants_.viscosity : ViscosityModel::none) {
    case ViscosityModel::morris:
      return make(MorrisViscosity::of<Dim>(nu, h));
    case ViscosityModel::monaghan:
      return make(MonaghanViscosity::of<Dim>(nu, h));
    case ViscosityModel::artificial:
      return make(ArtificialViscosity::of<Dim>(nu, h));
    case ViscosityModel::hinsch2024:
      return make(Hinsch2024Viscosity::of<Dim>(nu, h));
    case ViscosityModel::none:
      break;
  }
  return make();
}

template <int Dim>
PairStage<Dim> Stages<Dim>::momentum_from_fluid(const Parameters& parameters, bool prunes) const {
  return with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    return with_viscosity(true, parameters.viscosity, [&]<class... Viscosity>(const Viscosity&... viscosity) {
      using Pass = MomentumPass<Dim, Kernel, Pressure, Viscosity...>;
      const Pass pass{kernel_at<Kernel, Dim>(constants_.h), of_fluid(), of_fluid(), {Pressure{}, viscosity...}};
      const InstructionSet set = constants_.instruction_set;
      if (prunes) return PairStage<Dim>::template of<Within<Pruning<Pass>>>(set, Pruning<Pass>{pass}, fluid_);
      return PairStage<Dim>::template of<Within<Pass>>(set, pass, fluid_);
    });
  });
}

template <int Dim>
PairStage<Dim> Stages<Dim>::momentum_from_walls(const Parameters& parameters, bool listed) const {
  return with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    // Walls that let the fluid slip exert no friction.
    return with_viscosity(
        constants_.no_slip, parameters.viscosity, [&]<class... Viscosity>(const Viscosity&... viscosity) {
          const InstructionSet set = constants_.instruction_set;
          const auto stage = [&](const auto& pass) {
            using Pass = std::remove_cvref_t<decltype(pass)>;
            return PairStage<Dim>::template of<Between<Pass>>(set, pass, walls_, listed);
          };
          const auto kernel = kernel_at<Kernel, Dim>(constants_.h);
          if (constants_.extrapolated) {
            return stage(MomentumPass<Dim, Kernel, Pressure, Viscosity...>{
                kernel, of_fluid(), of_walls(), {Pressure{}, viscosity...}});
          }
          return stage(MirroredMomentumPass<Dim, Kernel, Pressure, Viscosity...>{
              kernel, of_fluid(), static_cast<Real>(constants_.rest_density), {Pressure{}, viscosity...}});
        });
  });
}

template <int Dim>
PairStage<Dim> Stages<Dim>::cohesion(const Parameters& parameters) const {
  return with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    using Pass = CohesionPass<Dim, Kernel>;
    return PairStage<Dim>::template of<Within<Pass>>(
        constants_.instruction_set,
        Pass{kernel_at<Kernel, Dim>(constants_.h),
             Hinsch2024SurfaceTension::of(parameters.surface_tension, constants_.mass)},
        constants_.cohesive ? fluid_ : none_);
  });
}

template <int Dim>
PairStage<Dim> Stages<Dim>::continuity_from_fluid(const Field& compression, double diffusivity,
                                                  const Parameters& parameters) const {
  const double c0 = sound_speed_of_state(parameters.stiffness, constants_.exponent, constants_.rest_density);
  return with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    using Pass = ContinuityPass<Dim, Kernel>;
    return PairStage<Dim>::template of<Within<Pass>>(
        constants_.instruction_set,
        Pass{.kernel = kernel_at<Kernel, Dim>(constants_.h),
             .velocity = vector_input<Dim>(fields_.velocity),
             .compression = compression.data(),
             .diffusivity = static_cast<Real>(diffusivity),
             .g_per_c0_squared = vector_of<Dim>(parameters.gravity / (c0 * c0))},
        fluid_);
  });
}

template <int Dim>
PairStage<Dim> Stages<Dim>::continuity_from_walls() const {
  return with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    using Pass = WallContinuityPass<Dim, Kernel>;
    return PairStage<Dim>::template of<Between<Pass>>(
        constants_.instruction_set,
        Pass{.kernel = kernel_at<Kernel, Dim>(constants_.h), .velocity = vector_input<Dim>(fields_.velocity)}, walls_,
        true);
  });
}

template <int Dim>
void Stages<Dim>::compute_vorticity(Engine<Dim>& engine, ParticleSet<Dim>& fluid, Field& vorticity) const {
  SummedVorticity<Dim> update{.factor = kernel_slope_factor(-constants_.mass)};
  for (int c = 0; c < update.components; ++c) update.vorticity[c] = vorticity.data(c);
  const PairStage<Dim> stage = with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    using Pass = VorticityPass<Dim, Kernel>;
    return PairStage<Dim>::template of<Within<Pass>>(constants_.instruction_set,
                                                     Pass{.kernel = kernel_at<Kernel, Dim>(constants_.h),
                                                          .velocity = vector_input<Dim>(fields_.velocity),
                                                          .density = fields_.density.data()},
                                                     fluid_, true);
  });
  engine.sweep(fluid, {stage}, update);
}

template <int Dim>
void Stages<Dim>::extrapolate_walls(Engine<Dim>& engine, ParticleSet<Dim>& walls, const Parameters& parameters) const {
  if (!constants_.extrapolated || walls.count == 0) return;
  const auto sweep = [&]<bool no_slip>() {
    WallState<Dim, no_slip> update{.state = constants_.state(parameters.stiffness),
                                   .wall_velocity = {},
                                   .density = wall_fields_.density->data(),
                                   .pressure_term = wall_fields_.pressure_term->data()};
    if constexpr (no_slip) {
      // The nearest row of the fluid stands half a spacing before the face, and may come nearer by as much again.
      update.least_distance = static_cast<Real>(0.25 * constants_.spacing);
      update.depth = wall_fields_.depth->data();
      update.wall_velocity = vector_input<Dim>(*wall_fields_.slide);
      point_at<Dim>(*wall_fields_.velocity, update.velocity);
    }
    const PairStage<Dim> stage = with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
      using Pass = WallStatePass<Dim, Kernel, no_slip>;
      // Walls that move themselves will take their acceleration off here.
      return PairStage<Dim>::template of<Between<Pass>>(constants_.instruction_set,
                                                        Pass{.kernel = kernel_at<Kernel, Dim>(constants_.h),
                                                             .of_fluid = of_fluid(),
                                                             .g_minus_a_w = vector_of<Dim>(parameters.gravity)},
                                                        fluid_);
    });
    engine.sweep(walls, {stage}, update);
  };
  constants_.no_slip ? sweep.template operator()<true>() : sweep.template operator()<false>();
}

template <int Dim>
Real Stages<Dim>::kernel_slope_factor(double factor) const {
  return with_kernel(constants_.kernel, [&]<template <int> class Kernel>() {
    return kernel_at<Kernel, Dim>(constants_.h, factor).slope_factor();
  });
}

template <int Dim>
SummedDensity Stages<Dim>::summed_density(const Parameters& parameters) const {
  const Real alpha = with_kernel(
      constants_.kernel, [&]<template <int> class Kernel>() { return kernel_at<Kernel, Dim>(constants_.h).alpha(); });
  return {.mass = static_cast<Real>(constants_.mass),
          .alpha = alpha,
          .state = constants_.state(parameters.stiffness),
          .density = fields_.density.data(),
          .pressure_term = fields_.pressure_term.data()};
}

template <int Dim>
SummedCompressionRate Stages<Dim>::summed_compression_rate(Field& rate) const {
  // F_ij is -m W' / r, over the rest density as compressions are.
  return {.factor = kernel_slope_factor(-constants_.mass / constants_.rest_density), .rate = rate.data()};
}

template <int Dim>
CarriedDensity<true> Stages<Dim>::advanced_density(Field& compression, const Field& rate, double dt,
                                                   const Parameters& parameters) const {
  return {.dt = static_cast<Real>(dt),
          .rate = rate.data(),
          .state = constants_.state(parameters.stiffness),
          .compression = compression.data(),
          .density = fields_.density.data(),
          .pressure_term = fields_.pressure_term.data()};
}

template <int Dim>
CarriedDensity<false> Stages<Dim>::carried_density(Field& compression, const Parameters& parameters) const {
  return {.state = constants_.state(parameters.stiffness),
          .compression = compression.data(),
          .density = fields_.density.data(),
          .pressure_term = fields_.pressure_term.data()};
}

template <int Dim>
SummedForce<Dim> Stages<Dim>::summed_force(const Parameters& parameters) const {
  const double c0 = sound_speed_of_state(parameters.stiffness, constants_.exponent, constants_.rest_density);
  const auto rest_density = static_cast<Real>(constants_.rest_density);
  SummedForce<Dim> update{.factor = kernel_slope_factor(-constants_.mass),
                          .gravity = vector_of<Dim>(parameters.gravity),
                          .per_rest_density = 1 / rest_density,
                          .sound_speed = static_cast<Real>(c0),
                          .exponent = constants_.exponent,
                          .velocity = vector_input<Dim>(fields_.velocity),
                          .density = fields_.density.data()};
  point_at<Dim>(fields_.acceleration, update.acceleration);
  return update;
}

template <int Dim>
template <class Update>
Update Stages<Dim>::motion(double dt, ParticleSet<Dim>& fluid) const {
  Update update;
  update.dt = static_cast<Real>(dt);
  update.reach = static_cast<Real>(constants_.support_radius);
  update.acceleration = vector_input<Dim>(fields_.acceleration);
  point_at<Dim>(fields_.velocity, update.velocity);
  for (int d = 0; d < Dim; ++d) {
    update.x[d] = fluid.x[d].data();
    update.compensation[d] = fluid.compensation[d].data();
  }
  return update;
}

#define WEIR_MOTION(Update, Dim) template Update<Dim> Stages<Dim>::motion<Update<Dim>>(double, ParticleSet<Dim>&) const;
WEIR_MOTION(EulerCromer, 2)
WEIR_MOTION(EulerCromer, 3)
WEIR_MOTION(Kick, 2)
WEIR_MOTION(Kick, 3)
WEIR_MOTION(Drift, 2)
WEIR_MOTION(Drift, 3)
#undef WEIR_MOTION

template struct FluidFields<2>;
template struct FluidFields<3>;
template struct WallFields<2>;
template struct WallFields<3>;
template class Stages<2>;
template class Stages<3>;

}  // namespace weir
