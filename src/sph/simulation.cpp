#include "sph/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/error.h"
#include "core/parallel.h"
#include "core/sha256.h"
#include "core/stopwatch.h"
#include "core/trace.h"
#include "equations/density.h"
#include "equations/energy.h"
#include "equations/state.h"
#include "equations/time_step.h"
#include "scene/origin.h"
#include "sph/clock.h"
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
        sampling_(sample(scene)),
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

  void fill(Frame& frame) override {
    frame.index = clock_.frame_index();
    frame.time = clock_.time();
    frame.simulated_time = simulated_time_;
    frame.dt = dt_;
    frame.cfl = cfl_number(dt_, solver_->max_speed(), solver_->smoothing_length());
    frame.cfl_met = frame.cfl <= cfl_factor();
    const ColorBy by = scene_.render.color.by;
    if (by != ColorBy::speed) refresh();
    frame.particles.resize(solver_->fluid().count);
    const ParticleSet<Dim>& fluid = solver_->fluid();
    const auto show = [&](std::size_t slot) {
      const Vec<Dim, double> x = fluid.position(slot);
      glm::vec4 shown(0);
      for (int d = 0; d < Dim; ++d) shown[d] = static_cast<float>(x[d]);
      switch (by) {
        case ColorBy::speed: {
          const Vec<Dim> v = fluid.vector_at(solver_->velocity(), slot);
          shown.w = std::sqrt(dot(v, v));
          break;
        }
        case ColorBy::density:
          shown.w = solver_->density().at(slot);
          break;
        case ColorBy::pressure:
          shown.w = static_cast<float>(solver_->pressure_at(slot));
          break;
      }
      return shown;
    };
    // Slots without the empty ones: each block writes from where the blocks before it end.
    std::vector<std::size_t> first(block_count(fluid.slots()) + 1);
    for (std::size_t slot = 0; slot < fluid.slots(); ++slot) {
      if (!fluid.empty(slot)) ++first[slot / block_size + 1];
    }
    for (std::size_t block = 1; block < first.size(); ++block) first[block] += first[block - 1];
    parallel_blocks(fluid.slots(), pool_, [&](std::size_t block, std::size_t begin, std::size_t end) {
      std::size_t place = first[block];
      for (std::size_t slot = begin; slot < end; ++slot) {
        if (!fluid.empty(slot)) frame.particles[place++] = show(slot);
      }
    });
  }

  StaticScene static_scene() const override {
    StaticScene still;
    still.particle_spacing = scene_.particle_spacing;
    still.max_speed_estimate = max_speed_estimate(scene_);
    const ParticleSet<Dim>& walls = solver_->walls();
    for (std::size_t slot = 0; slot < walls.slots(); ++slot) {
      if (walls.empty(slot)) continue;
      const Vec<Dim, double> x = walls.position(slot);
      glm::vec3 shown(0);
      for (int d = 0; d < Dim; ++d) shown[d] = static_cast<float>(x[d]);
      still.walls.push_back(shown);
    }
    return still;
  }

  Diagnostics diagnostics() override {
    refresh();
    const Span span("diagnostics");
    const ParticleSet<Dim>& fluid = solver_->fluid();
    const double m = solver_->particle_mass();
    const auto g = from_scene<Dim, double>(timeline_.state().gravity);
    const double rho0 = scene_.fluid.rest_density;

    const auto origin = from_scene<Dim, double>(origin_);
    const Vec<Dim, double> period = solver_->search().lattice().periodic().length;

    struct Sums {
      double error = 0, compression = 0, max_compression = 0, kinetic = 0, potential = 0;
      Vec<Dim, double> momentum{}, center{};
    };
    const Sums sums = parallel_reduce(
        fluid.slots(), pool_, Sums{},
        [&](std::size_t begin, std::size_t end) {
          Sums block;
          for (std::size_t slot = begin; slot < end; ++slot) {
            if (fluid.empty(slot)) continue;
            const double error = density_error(static_cast<double>(solver_->density().at(slot)), rho0);
            const auto v = convert<double>(fluid.vector_at(solver_->velocity(), slot));
            const Vec<Dim, double> x = origin + fluid.unwrapped_position(slot, period);
            block.error += error;
            block.compression += positive_part(error);
            block.max_compression = std::max(block.max_compression, error);
            block.kinetic += kinetic_energy(m, v);
            block.potential += potential_energy(m, g, x);
            block.momentum += m * v;
            block.center += x;
          }
          return block;
        },
        [](Sums a, const Sums& b) {
          a.error += b.error;
          a.compression += b.compression;
          a.max_compression = std::max(a.max_compression, b.max_compression);
          a.kinetic += b.kinetic;
          a.potential += b.potential;
          a.momentum += b.momentum;
          a.center += b.center;
          return a;
        });

    const double n = static_cast<double>(std::max<std::size_t>(fluid.count, 1));
    Diagnostics row;
    row.time = clock_.time();
    row.simulated_time = simulated_time_;
    row.step = steps_;
    row.dt = dt_;
    row.limit = limit_;
    row.max_speed = solver_->max_speed();
    row.cfl = cfl_number(dt_, row.max_speed, solver_->smoothing_length());
    row.mean_density_error = sums.error / n;
    row.mean_compression = sums.compression / n;
    row.max_density_error = sums.max_compression;
    row.kinetic_energy = sums.kinetic;
    row.potential_energy = sums.potential;
    for (int d = 0; d < Dim; ++d) {
      row.momentum[d] = sums.momentum[d];
      row.center_of_mass[d] = sums.center[d] / n;
    }
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
