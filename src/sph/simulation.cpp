#include "sph/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
#include "sph/clock.h"
#include "sph/fill_snapshot.h"
#include "sph/timeline.h"
#include "sph/wcsph.h"

namespace weir {

namespace {

// Adds the time to the end of the block.
class Timed {
 public:
  explicit Timed(double& total) : total_(total) {}
  ~Timed() { total_ += watch_.seconds(); }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  double& total_;
  Stopwatch watch_;
};

struct StepChoice {
  double dt = std::numeric_limits<double>::infinity();
  StepLimit limit = StepLimit::none;
  void at_most(double bound, StepLimit reason) {
    if (bound < dt) *this = {bound, reason};
  }
};

template <int Dim>
class SimulationIn final : public Simulation {
 public:
  SimulationIn(const Scene& scene, int threads, InstructionSet instruction_set)
      : scene_(scene),
        pool_(thread_count(threads)),
        sampling_(sample(scene)),
        volume_ends_(sampling_.volume_ends),
        clock_(scene_),
        timeline_(scene_),
        solver_(scene_, sampling_, pool_, instruction_set),
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
  std::int64_t fluid_particles() const override { return static_cast<std::int64_t>(solver_.fluid().count); }
  std::int64_t wall_particles() const override { return walls_; }

  void step() override {
    if (timeline_.paused()) {
      clock_.advance_to_landing();
    } else {
      bring_up_to_date();
      const Timed timed(times_.solve);
      {
        const Span span("accelerations");
        solver_.compute_accelerations();
      }
      const StepChoice choice = choose_step();
      dt_ = clock_.fitted_step(choice.dt);
      limit_ = choice.limit;
      const std::optional<Escape> escape = [this] {
        const Span span("integrate");
        return solver_.integrate(dt_);
      }();
      up_to_date_ = false;
      ++steps_;
      if (escape) diverged(*escape);
      simulated_time_ += dt_;
      clock_.advance(dt_);
    }
    follow_timeline();
  }

  void fill(Snapshot& snapshot, const SnapshotRequest& request) override {
    if (request.needs_recomputed()) bring_up_to_date();
    static_cast<Instant&>(snapshot) = instant();
    const auto pressure_at = [this](std::size_t slot) { return solver_.pressure_at(slot); };
    const FieldSources<Dim, decltype(pressure_at)> sources{solver_.fluid(), pressure_at, volume_ends_};
    fill_fluid(sources, request, pool_, snapshot.fluid);
    fill_walls(solver_.walls(), request.wall_positions, pool_, snapshot.walls);
  }

  Diagnostics diagnostics() override {
    bring_up_to_date();
    const Span span("diagnostics");
    const FluidParticles<Dim>& fluid = solver_.fluid();
    const double m = solver_.particle_mass();
    const auto g = from_scene<Dim, double>(timeline_.state().gravity);
    const double rho0 = scene_.fluid.rest_density;

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
            const double error = density_error(static_cast<double>(fluid.density[slot]), rho0);
            const auto v = convert<double>(fluid.velocity_of(slot));
            const Vec<Dim, double> x = fluid.position(slot);
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
    row.max_speed = solver_.max_speed();
    row.cfl = cfl_number(dt_, row.max_speed, solver_.smoothing_length());
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
    const FluidParticles<Dim>& fluid = solver_.fluid();
    std::vector<std::size_t> slot_of(fluid.count);
    for (std::size_t slot = 0; slot < fluid.slots(); ++slot) {
      if (!fluid.empty(slot)) slot_of[static_cast<std::size_t>(fluid.id[slot])] = slot;
    }
    Sha256 hash;
    for (const std::size_t slot : slot_of) {
      const Vec<Dim, double> x = fluid.position(slot);
      const Vec<Dim> v = fluid.velocity_of(slot);
      hash.add(&x, sizeof x);
      hash.add(&v, sizeof v);
    }
    return hash.hex();
  }

  StageTimes stage_times() const override { return times_; }
  InstructionSet instruction_set() const override { return solver_.instruction_set(); }

 private:
  Instant instant() const {
    Instant now{.index = clock_.frame_index(), .time = clock_.time(), .simulated_time = simulated_time_, .dt = dt_};
    now.cfl = cfl_number(dt_, solver_.max_speed(), solver_.smoothing_length());
    now.cfl_met = now.cfl <= cfl_factor();
    return now;
  }

  // Neighbours, densities and pressures of the current positions; at most once per step, whoever asks first.
  void bring_up_to_date() {
    if (up_to_date_) return;
    try {
      const Timed timed(times_.neighbours);
      const Span span("neighbours");
      solver_.find_neighbours();
    } catch (const std::range_error& error) {
      throw SimulationError(
          fmt::format("the simulation diverged in step {} at t = {:.6g} s: {}", steps_, clock_.time(), error.what()));
    }
    const Timed timed(times_.solve);
    const Span span("density and pressure");
    solver_.compute_density_and_pressure();
    up_to_date_ = true;
  }

  void follow_timeline() {
    if (timeline_.advance_to(clock_.time())) {
      solver_.reset(sampling_);
      simulated_time_ = 0;
      dt_ = 0;
      up_to_date_ = false;
    }
    const Timeline::State& state = timeline_.state();
    // Only a new stiffness changes what bring_up_to_date() has worked out; the rest acts in the next accelerations.
    if (state.stiffness != stiffness_) up_to_date_ = false;
    stiffness_ = state.stiffness;
    solver_.set({.gravity = from_scene<Dim, double>(state.gravity),
                 .stiffness = state.stiffness,
                 .viscosity = state.viscosity,
                 .surface_tension = state.surface_tension});
  }

  double cfl_factor() const {
    const auto* adaptive = std::get_if<AdaptiveStep>(&scene_.solver.time_step);
    return adaptive != nullptr ? adaptive->cfl : AdaptiveStep{}.cfl;
  }

  StepChoice choose_step() const {
    StepChoice choice;
    if (const auto* fixed = std::get_if<FixedStep>(&scene_.solver.time_step)) {
      choice.at_most(fixed->dt, StepLimit::fixed);
      return choice;
    }
    const AdaptiveStep& factors = std::get<AdaptiveStep>(scene_.solver.time_step);
    const double h = solver_.smoothing_length();
    const double v_max = solver_.max_speed();
    choice.at_most(velocity_limit(factors.cfl, h, v_max), StepLimit::velocity);
    choice.at_most(acoustic_limit(factors.acoustic, h, solver_.max_signal_speed()), StepLimit::acoustic);
    choice.at_most(force_limit(factors.force, h, solver_.max_acceleration()), StepLimit::force);
    if (scene_.fluid.viscosity.model != ViscosityModel::none) {
      choice.at_most(viscous_limit(factors.viscous, h, timeline_.state().viscosity), StepLimit::viscosity);
    }
    if (factors.maximum > 0) choice.at_most(factors.maximum, StepLimit::maximum);
    return choice;
  }

  [[noreturn]] void diverged(const Escape& escape) const {
    const bool finite = std::isfinite(escape.distance);
    const std::string what = finite ? fmt::format("moved {:.3g} m in one step, more than the support radius {:.3g} m",
                                                  escape.distance, solver_.step_reach())
                                    : std::string("has a velocity that is no longer a finite number");
    const bool fixed = std::holds_alternative<FixedStep>(scene_.solver.time_step);
    throw SimulationError(
        fmt::format("the simulation diverged in step {} at t = {:.6g} s (dt = {:.3g} s): particle {} {}; try {}",
                    steps_, clock_.time(), dt_, escape.id, what,
                    fixed ? "a smaller solver.time_step.fixed, or solver.time_step: {cfl: 0.4}"
                          : "smaller factors in solver.time_step, a lower stiffness, or more viscosity"));
  }

  const Scene scene_;
  ThreadPool pool_;
  Sampling sampling_;
  std::vector<std::int32_t> volume_ends_;
  Clock clock_;
  Timeline timeline_;
  Wcsph<Dim> solver_;
  std::int64_t walls_;
  double stiffness_ = -1;  // in force, Pa
  bool up_to_date_ = false;
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
