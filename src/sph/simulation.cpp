#include "sph/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/error.h"
#include "core/sha256.h"
#include "core/stopwatch.h"
#include "core/trace.h"
#include "equations/time_step.h"
#include "scene/origin.h"
#include "sph/clock.h"
#include "sph/fill_snapshot.h"
#include "sph/particle_sums.h"
#include "sph/solver.h"
#include "sph/timeline.h"

namespace weir {

namespace {

template <int Dim>
class SimulationIn final : public Simulation {
 public:
  SimulationIn(const Scene& scene, int threads, InstructionSet instruction_set)
      : origin_(scene_origin(scene)),
        scene_(relative_to(scene, origin_)),
        pool_(thread_count(threads)),
        sampling_(sample(scene_)),
        volume_ends_(sampling_.volume_ends),
        clock_(scene_),
        timeline_(scene_),
        solver_(make_solver<Dim>(scene_, sampling_, pool_, instruction_set)),
        walls_(static_cast<std::int64_t>(sampling_.wall_positions.size())) {
    // Where everything began is needed again for a reset alone.
    const bool resets = std::any_of(scene_.timeline.begin(), scene_.timeline.end(),
                                    [](const TimelineEvent& event) { return event.reset; });
    if (!resets) sampling_ = {};
    follow_timeline();
  }

  bool finished() const override { return clock_.finished(); }
  double time() const override { return clock_.time(); }
  double simulated_time() const override { return simulated_time_; }
  std::int64_t steps() const override { return steps_; }
  std::int64_t frame_index() const override { return clock_.frame_index(); }
  void use_threads(int most) override { pool_.use_at_most(most); }
  void give_way_to(const std::atomic<int>& others) override { pool_.give_way_to(others); }
  std::int64_t fluid_particles() const override { return static_cast<std::int64_t>(solver_->fluid().count); }
  std::int64_t wall_particles() const override { return walls_; }

  void step() override {
    if (timeline_.paused()) {
      clock_.advance_to_landing();
    } else {
      const StepReport step = timed([this] { return solver_->advance(clock_.way()); });
      dt_ = step.dt;
      limit_ = step.limit;
      ++steps_;
      if (step.runaway) diverged(*step.runaway);
      simulated_time_ += dt_;
      clock_.advance(dt_);
    }
    follow_timeline();
  }

  void fill(Snapshot& snapshot, const SnapshotRequest& request) override {
    if (request.needs_refresh()) refresh();
    static_cast<Instant&>(snapshot) = instant();
    snapshot.origin = origin_;
    fill_fluid(FieldSources<Dim>{*solver_, volume_ends_}, request, pool_, snapshot.fluid);
    fill_walls(*solver_, request.wall_positions, pool_, snapshot.walls);
  }

  Diagnostics diagnostics() override {
    refresh();
    const Span span("diagnostics");
    Diagnostics row = sum_of_particles(*solver_, scene_, timeline_.state().gravity, origin_, pool_);
    row.time = clock_.time();
    row.simulated_time = simulated_time_;
    row.step = steps_;
    row.dt = dt_;
    row.limit = limit_;
    row.max_speed = solver_->max_speed();
    row.cfl = cfl_number(dt_, row.max_speed, solver_->smoothing_length());
    return row;
  }

  std::string state_hash() const override {
    const ParticleSet<Dim>& fluid = solver_->fluid();
    std::vector<std::size_t> slot_of(fluid.count);
    for (std::size_t slot = 0; slot < fluid.slots(); ++slot) {
      if (!fluid.empty(slot)) slot_of[static_cast<std::size_t>(fluid.id[slot])] = slot;
    }
    Sha256 hash;
    for (const std::size_t slot : slot_of) {
      const Vec<Dim, double> x = fluid.position(slot);
      const Vec<Dim> v = fluid.vector_at(solver_->velocity(), slot);
      hash.add(&x, sizeof x);
      hash.add(&v, sizeof v);
    }
    return hash.hex();
  }

  StageTimes stage_times() const override { return times_; }
  InstructionSet instruction_set() const override { return solver_->instruction_set(); }

 private:
  Instant instant() const {
    Instant now{.index = clock_.frame_index(), .time = clock_.time(), .simulated_time = simulated_time_, .dt = dt_};
    now.cfl = cfl_number(dt_, solver_->max_speed(), solver_->smoothing_length());
    now.cfl_met = now.cfl <= cfl_factor();
    return now;
  }

  // Runs `work`, which may update neighbours, and books its time.
  template <class Work>
  auto timed(const Work& work) {
    const double neighbours = solver_->search().seconds();
    const Stopwatch watch;
    try {
      const auto result = work();
      const double of_neighbours = solver_->search().seconds() - neighbours;
      times_.neighbours += of_neighbours;
      times_.solve += watch.seconds() - of_neighbours;
      return result;
    } catch (const std::range_error& error) {
      throw SimulationError(
          fmt::format("the simulation diverged in step {} at t = {:.6g} s: {}", steps_, clock_.time(), error.what()));
    }
  }

  void refresh() {
    timed([this] {
      solver_->refresh();
      return 0;
    });
  }

  void follow_timeline() {
    if (timeline_.advance_to(clock_.time())) {
      solver_->reset(sampling_);
      simulated_time_ = 0;
      dt_ = 0;
    }
    solver_->set(timeline_.state());
  }

  double cfl_factor() const {
    const auto* adaptive = std::get_if<AdaptiveStep>(&scene_.solver.time_step);
    return adaptive != nullptr ? adaptive->cfl : AdaptiveStep{}.cfl;
  }

  [[noreturn]] void diverged(const Runaway& runaway) const {
    const bool finite = std::isfinite(runaway.distance);
    const std::string what = finite ? fmt::format("moved {:.3g} m in one step, more than the support radius {:.3g} m",
                                                  runaway.distance, solver_->step_reach())
                                    : std::string("has a velocity that is no longer a finite number");
    const bool fixed = std::holds_alternative<FixedStep>(scene_.solver.time_step);
    throw SimulationError(
        fmt::format("the simulation diverged in step {} at t = {:.6g} s (dt = {:.3g} s): particle {} {}; try {}",
                    steps_, clock_.time(), dt_, runaway.id, what,
                    fixed ? "a smaller solver.time_step.fixed, or solver.time_step: {cfl: 0.4}"
                          : "smaller factors in solver.time_step, a lower stiffness, or more viscosity"));
  }

  const Vec3 origin_;  // m, of what the solver counts from
  const Scene scene_;  // its positions count from there
  ThreadPool pool_;
  Sampling sampling_;
  std::vector<std::int32_t> volume_ends_;
  Clock clock_;
  Timeline timeline_;
  std::unique_ptr<SphSolver<Dim>> solver_;
  std::int64_t walls_;
  double simulated_time_ = 0;
  std::int64_t steps_ = 0;
  double dt_ = 0;
  StepLimit limit_ = StepLimit::none;
  StageTimes times_;
};

}  // namespace

std::unique_ptr<Simulation> make_simulation(const Scene& scene, int threads, InstructionSet instruction_set) {
  if (scene.dimension == 2) return std::make_unique<SimulationIn<2>>(scene, threads, instruction_set);
  return std::make_unique<SimulationIn<3>>(scene, threads, instruction_set);
}

}  // namespace weir
