// What the methods have in common: which passes a scene's kernel, viscosity, cohesion and walls stand for, and the fields
// that they read and write. A pass is chosen here; the order of passes is a method's own.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "simd/instruction_set.h"
#include "sph/engine/engine.h"
#include "sph/particle_set.h"
#include "sph/passes/continuity.h"
#include "sph/passes/density.h"
#include "sph/passes/momentum.h"
#include "sph/passes/motion.h"
#include "sph/timeline.h"

namespace weir {

// What does not change during a run.
struct FluidConstants {
  FluidConstants(const Scene& scene, InstructionSet set);

  InstructionSet instruction_set;
  KernelName kernel;
  ViscosityModel viscosity;
  bool cohesive;
  bool no_slip;           // viscosity acts between fluid and walls
  bool extrapolated;      // walls have a pressure of their own
  double h;               // m
  double support_radius;  // m
  double spacing;         // dx, m
  double mass;            // kg
  double rest_density;    // kg/m^Dim
  int exponent;
  bool clamp_negative_pressure;

  StateEquation state(double stiffness) const;
};

template <int Dim>
struct FluidFields {
  FluidFields(ParticleSet<Dim>& fluid);
  Field& velocity;
  Field& density;
  Field& pressure_term;  // p / rho^2
  Field& acceleration;
};

// Fields that the walls of a scene have; null where it has no use for them.
template <int Dim>
struct WallFields {
  WallFields(ParticleSet<Dim>& walls, const FluidConstants& constants);
  Field* depth = nullptr;     // behind the face
  Field* slide = nullptr;     // prescribed velocity of the surface
  Field* velocity = nullptr;  // as the fluid's viscosity meets it
  Field* density = nullptr;
  Field* pressure_term = nullptr;
};

template <int Dim>
VectorInput<Dim> vector_input(const Field& field) {
  VectorInput<Dim> input;
  for (int d = 0; d < Dim; ++d) input.component[d] = field.data(d);
  return input;
}

template <int Dim>
class Stages {
 public:
  Stages(const FluidConstants& constants, const ParticleSet<Dim>& fluid, const ParticleSet<Dim>& walls,
         const FluidFields<Dim>& fields, const WallFields<Dim>& wall_fields)
      : constants_(constants), fluid_(fluid), walls_(walls), fields_(fields), wall_fields_(wall_fields) {}

  // W_ij, over fluid or walls.
  PairStage<Dim> density(const ParticleSet<Dim>& source) const;
  // Pressure and viscosity. The first loop over pairs of the fluid prunes; walls are visited by lists that a loop before
  // has pruned, or by those with their skin (`listed`): there are few of them.
  PairStage<Dim> momentum_from_fluid(const Parameters& parameters, bool prunes) const;
  PairStage<Dim> momentum_from_walls(const Parameters& parameters, bool listed) const;
  // Without cohesion its source has no particles, and the engine leaves it out.
  PairStage<Dim> cohesion(const Parameters& parameters) const;
  PairStage<Dim> continuity_from_fluid(const Field& compression, double diffusivity,
                                       const Parameters& parameters) const;
  PairStage<Dim> continuity_from_walls() const;

  // curl v of a fresh state.
  void compute_vorticity(Engine<Dim>& engine, ParticleSet<Dim>& fluid, Field& vorticity) const;
  // The state of walls from the fluid around them; nothing where walls mirror.
  void extrapolate_walls(Engine<Dim>& engine, ParticleSet<Dim>& walls, const Parameters& parameters) const;
  SummedDensity summed_density(const Parameters& parameters) const;
  SummedCompressionRate summed_compression_rate(Field& rate) const;
  // Advanced by dt (s), or as it is.
  CarriedDensity<true> advanced_density(Field& compression, const Field& rate, double dt,
                                        const Parameters& parameters) const;
  CarriedDensity<false> carried_density(Field& compression, const Parameters& parameters) const;
  SummedForce<Dim> summed_force(const Parameters& parameters) const;
  template <class Update>
  Update motion(double dt, ParticleSet<Dim>& fluid) const;

 private:
  template <class Make>
  PairStage<Dim> with_viscosity(bool viscous, double nu, const Make& make) const;
  Real kernel_slope_factor(double factor) const;
  MomentumInput<Dim> of_fluid() const;
  MomentumInput<Dim> of_walls() const;

  const FluidConstants& constants_;
  const ParticleSet<Dim>& fluid_;
  const ParticleSet<Dim>& walls_;
  const FluidFields<Dim>& fields_;
  const WallFields<Dim>& wall_fields_;
  ParticleSet<Dim> none_;
};

}  // namespace weir
