// delta-SPH: the density is part of the state, advanced by the continuity equation with a diffusion that damps its noise.
//
// [Antuono10]   M. Antuono, A. Colagrossi, S. Marrone, D. Molteni, Free-surface flows solved by means of SPH schemes with
//               numerical diffusive terms, Comput. Phys. Commun. 181 (2010) 532-549.
// [Fourtakas19] see equations/continuity.h: the diffusion without the density at rest.
#include "core/trace.h"
#include "equations/continuity.h"
#include "equations/state.h"
#include "sph/clock.h"
#include "sph/solver.h"

namespace weir {

namespace {

template <int Dim>
class DeltaSph final : public SphSolver<Dim> {
 public:
  DeltaSph(const Scene& scene, const Sampling& sampling, ThreadPool& pool, InstructionSet instruction_set)
      : SphSolver<Dim>(scene, sampling, pool, instruction_set),
        delta_(scene.solver.density_diffusion),
        compression_(fluid_.add("compression", "1", 1, Keeping::carried)),
        rate_(fluid_.add("compression_rate", "1/s", 1, Keeping::recomputed)) {
    this->reset(sampling);
  }

  void start(const Sampling& sampling) override {
    for (std::size_t i = 0; i < sampling.fluid_pressures.size(); ++i) {
      compression_.data()[i] = static_cast<float>(
          compression_of_state(sampling.fluid_pressures[i], parameters_.stiffness, this->constants_.exponent));
    }
  }

  // The forces act first, and the density follows with the velocities that they lead to, at the positions before; it would
  // lag behind them otherwise.
  StepReport advance(double way) override {
    this->refresh();     // neighbours, pressure
    this->accelerate();  // pressure, viscosity, cohesion, gravity
    const StepChoice step = this->longest_step();
    const double dt = fitted_step(step.dt, way);
    return {dt, step.limit, this->move(dt)};
  }

  void recompute() override {
    const Span span("density and pressure");
    engine_.each(fluid_, stages_.carried_density(compression_, parameters_));  // p(rho)
    stages_.extrapolate_walls(engine_, walls_, parameters_);
  }

  void accelerate() override {
    const Span span("accelerations");
    this->bound_by(engine_.sweep(fluid_,
                                 {stages_.momentum_from_fluid(parameters_, true), stages_.cohesion(parameters_),
                                  stages_.momentum_from_walls(parameters_, true)},
                                 stages_.summed_force(parameters_)));
  }

  std::optional<Runaway> move(double dt) override {
    const Span span("integrate");
    const double c0 =
        sound_speed_of_state(parameters_.stiffness, this->constants_.exponent, this->constants_.rest_density);
    const double diffusivity = density_diffusivity(delta_, this->constants_.h, c0);
    engine_.each(fluid_, stages_.template motion<Kick<Dim>>(dt, fluid_));  // v += dt a
    // d rho / dt = -rho div v + diffusion
    engine_.sweep(
        fluid_,
        {stages_.continuity_from_fluid(compression_, diffusivity, parameters_), stages_.continuity_from_walls()},
        stages_.summed_compression_rate(rate_));
    engine_.each(fluid_, stages_.advanced_density(compression_, rate_, dt, parameters_));  // rho += dt d rho / dt
    return this->moved(engine_.each(fluid_, stages_.template motion<Drift<Dim>>(dt, fluid_)), dt);  // x += dt v
  }

 private:
  using SphSolver<Dim>::engine_;
  using SphSolver<Dim>::stages_;
  using SphSolver<Dim>::fluid_;
  using SphSolver<Dim>::walls_;
  using SphSolver<Dim>::parameters_;

  double delta_;        // strength of the diffusion, 1
  Field& compression_;  // rho / rho0 - 1, the carried form of the density
  Field& rate_;         // of it, 1/s
};

}  // namespace

template <int Dim>
std::unique_ptr<SphSolver<Dim>> make_delta_sph(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                                               InstructionSet instruction_set) {
  return std::make_unique<DeltaSph<Dim>>(scene, sampling, pool, instruction_set);
}
template std::unique_ptr<SphSolver<2>> make_delta_sph<2>(const Scene&, const Sampling&, ThreadPool&, InstructionSet);
template std::unique_ptr<SphSolver<3>> make_delta_sph<3>(const Scene&, const Sampling&, ThreadPool&, InstructionSet);

}  // namespace weir
