// Weakly compressible SPH [Hinsch24 Alg. 3]: density by summation, pressure from an equation of state, accelerations,
// Euler-Cromer.
#include "core/trace.h"
#include "sph/clock.h"
#include "sph/solver.h"

namespace weir {

namespace {

template <int Dim>
class Wcsph final : public SphSolver<Dim> {
 public:
  Wcsph(const Scene& scene, const Sampling& sampling, ThreadPool& pool, InstructionSet instruction_set)
      : SphSolver<Dim>(scene, sampling, pool, instruction_set) {
    this->reset(sampling);
  }

  StepReport advance(double way) override {
    this->refresh();     // neighbours, density, pressure
    this->accelerate();  // pressure, viscosity, cohesion, gravity
    const StepChoice step = this->longest_step();
    const double dt = fitted_step(step.dt, way);  // [ch. 6.6.2]
    return {dt, step.limit, this->move(dt)};
  }

  void recompute() override {
    const Span span("density and pressure");
    // rho_i = sum_j m_j W_ij [eq. 4.3];  p_i = k ((rho_i / rho0)^n - 1) [ch. 4.4]
    engine_.sweep(fluid_, {stages_.density(fluid_), stages_.density(walls_)}, stages_.summed_density(parameters_));
    stages_.extrapolate_walls(engine_, walls_, parameters_);
  }

  void accelerate() override {
    const Span span("accelerations");
    this->bound_by(engine_.sweep(fluid_,
                                 {stages_.momentum_from_fluid(parameters_, false),   // [Alg. 1], [eq. 4.5]
                                  stages_.cohesion(parameters_),                     // [Alg. 2]
                                  stages_.momentum_from_walls(parameters_, false)},  // [Alg. 1, wall]
                                 stages_.summed_force(parameters_)));                // + g
  }

  std::optional<Runaway> move(double dt) override {
    const Span span("integrate");
    // v += dt a;  x += dt v [Alg. 3]
    return this->moved(engine_.each(fluid_, stages_.template motion<EulerCromer<Dim>>(dt, fluid_)), dt);
  }

 private:
  using SphSolver<Dim>::engine_;
  using SphSolver<Dim>::stages_;
  using SphSolver<Dim>::fluid_;
  using SphSolver<Dim>::walls_;
  using SphSolver<Dim>::parameters_;
};

}  // namespace

template <int Dim>
std::unique_ptr<SphSolver<Dim>> make_wcsph(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                                           InstructionSet instruction_set) {
  return std::make_unique<Wcsph<Dim>>(scene, sampling, pool, instruction_set);
}
template std::unique_ptr<SphSolver<2>> make_wcsph<2>(const Scene&, const Sampling&, ThreadPool&, InstructionSet);
template std::unique_ptr<SphSolver<3>> make_wcsph<3>(const Scene&, const Sampling&, ThreadPool&, InstructionSet);

}  // namespace weir
