#include "run/manifest_facts.h"

namespace weir {

Manifest opening_facts(const RunContext& run, const Observers& observers) {
  Manifest facts;
  facts.version = run.provenance.version;
  facts.scene_sha256 = run.provenance.scene_sha256;
  facts.dimension = run.scene.dimension;
  facts.particles = {.fluid = run.simulation.fluid_particles(), .wall = run.simulation.wall_particles()};
  facts.threads = run.threads;
  facts.instruction_set = name_of(run.simulation.instruction_set());
  for (const auto& observer : observers) observer->describe(facts);
  return facts;
}

Manifest closing_facts(const RunContext& run, const Observers& observers) {
  Manifest facts = opening_facts(run, observers);
  facts.state_hash = run.simulation.state_hash();
  facts.steps = run.simulation.steps();
  facts.simulated_time_s = run.simulation.simulated_time();
  const StageTimes solver = run.simulation.stage_times();
  facts.wall_time_s.neighbours = solver.neighbours;
  facts.wall_time_s.solve = solver.neighbours + solver.solve;
  if (facts.wall_time_s.solve > 0) {
    facts.particle_steps_per_second =
        static_cast<double>(facts.particles.fluid) * static_cast<double>(facts.steps) / facts.wall_time_s.solve;
  }
  for (const auto& observer : observers) observer->account(facts);
  return facts;
}

}  // namespace weir
