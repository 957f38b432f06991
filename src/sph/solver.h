// The face of a method: sets of particles, and a step that reads as its paper's algorithm box (wcsph.cpp, delta_sph.cpp).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "scene/sampling.h"
#include "scene/scene.h"
#include "sph/engine/engine.h"
#include "sph/pair_search.h"
#include "sph/particle_set.h"
#include "sph/stages.h"
#include "sph/step_limits.h"

namespace weir {

// A particle that left the range in which the method means anything.
struct Runaway {
  std::int32_t id = -1;
  double distance = 0;  // moved in one step, m; not finite when the state is not
};

struct StepReport {
  double dt = 0;  // s
  StepLimit limit = StepLimit::none;
  std::optional<Runaway> runaway{};  // the state is of no use then
};

template <int Dim>
class SphSolver {
 public:
  virtual ~SphSolver() = default;
  SphSolver(const SphSolver&) = delete;
  SphSolver& operator=(const SphSolver&) = delete;

  // One time step, which divides the way to the next landing (s) evenly.
  virtual StepReport advance(double way) = 0;
  // Neighbours and recomputed fields of the current state; at most once a step, at the first call. Throws std::range_error
  // for particles that have flown too far.
  void refresh();
  virtual void recompute() = 0;  // the fields alone, with the neighbours of the last refresh()
  // Accelerations of a fresh state, and what bounds the next step.
  virtual void accelerate() = 0;
  // Moves the particles by dt (s) with these accelerations.
  virtual std::optional<Runaway> move(double dt) = 0;

  // curl v of a fresh state; its field exists from the first call on. Nothing of a step reads it.
  const Field& vorticity();

  void set(const Parameters& parameters);
  void reset(const Sampling& sampling);  // back to the start

  ParticleSet<Dim>& fluid() { return fluid_; }
  const ParticleSet<Dim>& fluid() const { return fluid_; }
  const ParticleSet<Dim>& walls() const { return walls_; }
  Field& velocity() const { return fields_.velocity; }
  Field& density() const { return fields_.density; }
  Field& acceleration() const { return fields_.acceleration; }
  Field& pressure_term() const { return fields_.pressure_term; }
  const WallFields<Dim>& wall_fields() const { return wall_fields_; }
  double pressure_at(std::size_t slot) const;  // Pa, of a fresh state

  double particle_mass() const { return constants_.mass; }         // kg
  double smoothing_length() const { return constants_.h; }         // m
  double step_reach() const { return constants_.support_radius; }  // m; farther in one step and neighbours mean nothing
  double max_speed() const { return bounds_.max_speed; }           // m/s, of the current velocities
  double max_acceleration() const { return bounds_.max_acceleration; }  // m/s^2, of the last accelerations
  double max_signal_speed() const { return bounds_.max_signal_speed; }  // m/s, of velocities and densities at that time
  const PairSearch<Dim>& search() const { return search_; }
  PairSearch<Dim>& search() { return search_; }
  InstructionSet instruction_set() const { return constants_.instruction_set; }

 protected:
  // The scene must be valid; `sampling` are its particles.
  SphSolver(const Scene& scene, const Sampling& sampling, ThreadPool& pool, InstructionSet instruction_set);

  virtual void start(const Sampling&) {}  // of the method's own fields, which are zero then
  StepChoice longest_step() const;
  void bound_by(const ForceExtremes& extremes);
  // After the particles moved by a step of dt (s): the particle of the smallest id that moved farther than step_reach(), or
  // whose state is not finite.
  std::optional<Runaway> moved(const MotionExtremes<Dim>& extremes, double dt);

  FluidConstants constants_;
  TimeStep time_step_;
  Parameters parameters_;
  ParticleSet<Dim> fluid_;
  ParticleSet<Dim> walls_;
  FluidFields<Dim> fields_;
  WallFields<Dim> wall_fields_;
  PairSearch<Dim> search_;
  Engine<Dim> engine_;
  Stages<Dim> stages_;
  StepBounds bounds_;

 private:
  std::optional<double> diffusivity() const;  // of velocity, m^2/s; bounds the step

  bool fresh_ = false;
  Field* vorticity_ = nullptr;
};

template <int Dim>
std::unique_ptr<SphSolver<Dim>> make_wcsph(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                                           InstructionSet instruction_set);
template <int Dim>
std::unique_ptr<SphSolver<Dim>> make_delta_sph(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                                               InstructionSet instruction_set);
// The method that the scene names.
template <int Dim>
std::unique_ptr<SphSolver<Dim>> make_solver(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                                            InstructionSet instruction_set);

}  // namespace weir
