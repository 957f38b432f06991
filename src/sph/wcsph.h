// Weakly compressible SPH as in Hinsch 2024 [Hinsch24 Alg. 3]: density by summation, pressure from an equation of state,
// accelerations, Euler-Cromer.
#pragma once

#include <cstdint>
#include <optional>

#include "scene/sampling.h"
#include "scene/scene.h"
#include "sph/engine/engine.h"
#include "sph/neighbours.h"
#include "sph/particles.h"

namespace weir {

// What a timeline may change during a run.
template <int Dim>
struct Controls {
  Vec<Dim, double> gravity{};  // m/s^2
  double stiffness = 0;        // k, Pa
  double viscosity = 0;        // nu, m^2/s
  double surface_tension = 0;  // s, m^(Dim + 2)/s^2
};

// A particle that left the range in which the method means anything.
struct Escape {
  std::int32_t id = -1;
  double distance = 0;  // moved in one step, m; not finite when the state is not
};

template <int Dim>
class Wcsph {
 public:
  // The scene must be right; `sampling` are its particles.
  Wcsph(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
        InstructionSet instruction_set = default_instruction_set());

  // One time step, in the order of the algorithm box; each needs those before it.
  void find_neighbours();
  void relist();  // the same, though the lists may be right
  void compute_density_and_pressure();
  void compute_accelerations();
  // Moves the particles by dt. Returns the particle of the smallest id that moved farther than `step_reach()`, or whose
  // state is not finite; the state is of no use then.
  std::optional<Escape> integrate(double dt);

  double max_speed() const { return max_speed_; }                // m/s, of the current velocities
  double max_acceleration() const { return max_acceleration_; }  // m/s^2, of the last accelerations
  double max_signal_speed() const { return max_signal_speed_; }  // m/s, of velocities and densities at that time
  double step_reach() const { return support_radius_; }          // m; farther in one step and neighbours mean nothing

  void set(const Controls<Dim>& controls) { controls_ = controls; }
  void reset(const Sampling& sampling);  // back to the start

  const FluidParticles<Dim>& fluid() const { return fluid_; }
  FluidParticles<Dim>& fluid() { return fluid_; }
  const WallParticles<Dim>& walls() const { return walls_; }
  double particle_mass() const { return mass_; }  // kg
  double smoothing_length() const { return h_; }  // m
  double pressure_at(std::size_t slot) const;     // Pa, of the last step
  const Neighbours<Dim>& neighbours() const { return neighbours_; }
  InstructionSet instruction_set() const { return instruction_set_; }

 private:
  std::optional<Escape> find_escaped(double dt) const;

  double h_;
  double support_radius_;
  double mass_;
  double rest_density_;
  int exponent_;
  bool clamp_negative_pressure_;
  ThreadPool& pool_;
  InstructionSet instruction_set_;
  Loops<Dim> loops_;
  Controls<Dim> controls_;
  FluidParticles<Dim> fluid_;
  WallParticles<Dim> walls_;
  Neighbours<Dim> neighbours_;
  double max_speed_ = 0;
  double max_acceleration_ = 0;
  double max_signal_speed_ = 0;
};

extern template class Wcsph<2>;
extern template class Wcsph<3>;

}  // namespace weir
