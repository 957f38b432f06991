// The face of the solver: one scene, stepped. The dimension is chosen at run time here and nowhere else.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "frame/diagnostics.h"
#include "frame/snapshot.h"
#include "scene/sampling.h"
#include "scene/scene.h"
#include "simd/instruction_set.h"

namespace weir {

// Wall time by stage, s.
struct StageTimes {
  double setup = 0;
  double neighbours = 0;
  double solve = 0;  // neighbours not included
};

class Simulation {
 public:
  virtual ~Simulation() = default;
  Simulation() = default;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  // Run time has reached the scene's duration.
  virtual bool finished() const = 0;
  // One time step; while paused, a jump to the next landing. Throws SimulationError when the state diverges.
  virtual void step() = 0;

  virtual double time() const = 0;            // run time, s
  virtual double simulated_time() const = 0;  // s
  virtual std::int64_t steps() const = 0;
  // k if run time is exactly k / fps, else -1.
  virtual std::int64_t frame_index() const = 0;

  // From the next step on, at most so many of the threads that it was made with. Results never depend on it.
  virtual void use_threads(int most) = 0;
  // And from the next loop on, as many processors as this says are left to others. It must outlive the steps.
  virtual void give_way_to(const std::atomic<int>& others) = 0;

  virtual std::int64_t fluid_particles() const = 0;
  virtual std::int64_t wall_particles() const = 0;

  // Both first update stale densities and pressures that they read. Neither changes positions or velocities.
  // The snapshot's memory is reused.
  virtual void fill(Snapshot& snapshot, const SnapshotRequest& request) = 0;
  virtual Diagnostics diagnostics() = 0;
  // SHA-256 of position and velocity bits of all fluid particles in id order.
  virtual std::string state_hash() const = 0;
  virtual StageTimes stage_times() const = 0;
  virtual InstructionSet instruction_set() const = 0;
};

// `threads` as for thread_count(). The scene must be right (check() is empty).
std::unique_ptr<Simulation> make_simulation(const Scene& scene, int threads,
                                            InstructionSet instruction_set = default_instruction_set());

}  // namespace weir
