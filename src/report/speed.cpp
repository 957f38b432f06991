#include "report/speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "core/trace.h"
#include "core/write_text.h"
#include "report/median.h"
#include "report/scenes.h"
#include "scene/names.h"

namespace weir {

namespace {

std::vector<int> thread_counts(int requested) {
  const int most = thread_count(requested);
  std::vector<int> counts;
  for (int n = 1; n < most; n *= 2) counts.push_back(n);
  counts.push_back(most);
  return counts;
}

// Time after which the front has run 2 heights: T = 2 sqrt(g / H) t [Martin and Moyce 1952, n^2 = 1].
constexpr double developed = 0.6;  // s

// Least steps of a measurement: the lifetime of neighbour lists, so that it includes their share.
constexpr int least_steps = 10;

// Repetitions of alternating measurements, of which medians are taken.
constexpr int repeats = 5;
// Repetitions of the sizes, the largest of which take long to set up.
constexpr int rounds_of_sizes = 3;

}  // namespace

Scene speed_scene(int dimension, std::int64_t particles) {
  Scene scene;
  scene.name = fmt::format("speed_{}d", dimension);
  scene.dimension = dimension;
  scene.duration = 10;
  const double n = static_cast<double>(particles);
  // Every length is a whole number of spacings; otherwise walls would compress the fluid.
  if (dimension == 2) {
    scene.gravity = Vec3(0, -9.81, 0);
    scene.particle_spacing = 1 / std::round(std::sqrt(n));
    scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(1, 1, 0)}}};
    scene.walls = {{.shape = Tank{Vec3(0), Vec3(3, 2, 0), {Side::top}}, .layers = 0, .holes = {}}};
    scene.solver.kernel = {KernelName::wendland_c2, 1.3};
  } else {
    scene.gravity = Vec3(0, 0, -9.81);
    scene.particle_spacing = 0.5 / std::round(std::cbrt(n / 4));
    scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(1, 0.5, 1)}}};
    scene.walls = {{.shape = Tank{Vec3(0), Vec3(3, 0.5, 2), {Side::top}}, .layers = 0, .holes = {}}};
    scene.solver.kernel = {KernelName::wendland_c2, 1.2};
  }
  const double c0 = 10 * std::sqrt(2 * 9.81);
  scene.solver.compressibility = SoundSpeed{c0};
  scene.fluid.viscosity = {ViscosityModel::morris, 0.01 * smoothing_length(scene) * c0};
  scene.output.movie.reset();
  return scene;
}

std::unique_ptr<Simulation> flow_at(const Scene& scene, int threads, double time) {
  std::unique_ptr<Simulation> simulation = make_simulation(scene, threads);
  constexpr int warm_up = 10;
  while (simulation->steps() < warm_up || simulation->time() < time) simulation->step();
  return simulation;
}

SpeedSample measure_start(const Scene& scene, int threads, double seconds) {
  // Enough to include rebuilds of lists, few enough to stay near the start for every size.
  constexpr int steps = 100;
  SpeedSample sample;
  double taken = 0;
  double neighbours = 0;
  do {
    const std::unique_ptr<Simulation> flow = flow_at(scene, threads, 0);
    const StageTimes before = flow->stage_times();
    const Stopwatch watch;
    for (int k = 0; k < steps && (k < least_steps || watch.seconds() < seconds); ++k) {
      flow->step();
      ++sample.steps;
    }
    taken += watch.seconds();
    neighbours += flow->stage_times().neighbours - before.neighbours;
    sample.particles = flow->fluid_particles();
  } while (taken < seconds);
  sample.mps = 1e-6 * static_cast<double>(sample.particles) * static_cast<double>(sample.steps) / taken;
  sample.neighbours = neighbours / taken;
  return sample;
}

SpeedSample measure_speed(Simulation& simulation, double seconds, bool log) {
  const double neighbours = simulation.stage_times().neighbours;
  const Stopwatch watch;
  SpeedSample sample;
  sample.particles = simulation.fluid_particles();
  do {
    simulation.step();
    if (log) simulation.diagnostics();
    ++sample.steps;
  } while ((sample.steps < least_steps || watch.seconds() < seconds) && !simulation.finished());
  const double taken = watch.seconds();
  sample.mps = 1e-6 * static_cast<double>(sample.particles) * static_cast<double>(sample.steps) / taken;
  sample.neighbours = (simulation.stage_times().neighbours - neighbours) / taken;
  return sample;
}

LinePlot speed_figure(const SpeedOptions& speed, const ReportOptions& options) {
  struct Case {
    int dimension;
    std::int64_t wanted;  // particles
    int threads;
    std::size_t series;
    std::int64_t particles = 0;
    std::vector<double> mps = {};
  };
  LinePlot plot;
  plot.title = "Dam break, from its start";
  plot.x = {"fluid particles", "particles", true};
  plot.y = {"million particle-steps per second", "speed[Mps/s]", true};
  plot.legend = "method, dimension, threads";
  plot.series_column = "case";
  std::vector<Case> cases;
  for (const int dimension : {2, 3})
    for (const int threads : thread_counts(options.threads)) {
      for (const std::int64_t n : speed.particles) cases.push_back({dimension, n, threads, plot.series.size()});
      plot.series.push_back({fmt::format("WCSPH {}D, {}", dimension, threads), {}, {}});
    }
  // Alternating, so that other load on the machine affects all cases alike.
  for (int round = 0; round < rounds_of_sizes; ++round) {
    for (Case& each : cases) {
      const SpeedSample sample = measure_start(speed_scene(each.dimension, each.wanted), each.threads, speed.seconds);
      options.message(fmt::format("{}D, {} particles, {} threads: {:.2f} M particle-steps/s, {:.0f} % of it neighbours",
                                  each.dimension, sample.particles, each.threads, sample.mps, 100 * sample.neighbours));
      each.mps.push_back(sample.mps);
      each.particles = sample.particles;
    }
  }
  for (const Case& each : cases) {
    plot.series[each.series].x.push_back(static_cast<double>(each.particles));
    plot.series[each.series].y.push_back(median(each.mps));
  }
  return plot;
}

// Fraction of the wall time of steps that is outside parallel loops, on one thread.
double serial_share(Simulation& simulation, double seconds) {
  const Recording recording;
  const Stopwatch watch;
  for (int step = 0; step < least_steps || watch.seconds() < seconds; ++step) simulation.step();
  return 1 - Trace::total(ThreadPool::loop_span) / watch.seconds();
}

std::string developed_flow_csv(const SpeedOptions& speed, const ReportOptions& options) {
  std::string csv = "method,dimension,particles,threads,time[s],speed[Mps/s],neighbours_share[1],serial_share[1]\n";
  const std::vector<int> counts = thread_counts(options.threads);
  for (const int dimension : {2, 3}) {
    const std::unique_ptr<Simulation> flow =
        flow_at(speed_scene(dimension, speed.developed_particles), counts.back(), developed);
    std::vector<std::vector<double>> mps(counts.size());
    std::vector<std::vector<double>> neighbours(counts.size());
    for (int repeat = 0; repeat < repeats; ++repeat) {
      for (std::size_t k = 0; k < counts.size(); ++k) {
        flow->use_threads(counts[k]);
        const SpeedSample sample = measure_speed(*flow, 0.5 * speed.seconds);
        mps[k].push_back(sample.mps);
        neighbours[k].push_back(sample.neighbours);
      }
    }
    for (std::size_t k = 0; k < counts.size(); ++k) {
      options.message(fmt::format("{}D, developed flow, {} threads: {:.2f} M particle-steps/s", dimension, counts[k],
                                  median(mps[k])));
      flow->use_threads(counts[k]);
      csv +=
          fmt::format("{},{},{},{},{},{:.3f},{:.3f},{:.4f}\n", "WCSPH", dimension, flow->fluid_particles(), counts[k],
                      developed, median(mps[k]), median(neighbours[k]), serial_share(*flow, 0.5 * speed.seconds));
    }
  }
  return csv;
}

std::string methods_csv(const SpeedOptions& speed, const ReportOptions& options) {
  struct Case {
    std::string name;
    std::unique_ptr<Simulation> flow;
    std::vector<double> milliseconds = {};  // a step
    std::vector<double> cost = {};          // of the first case
  };
  std::string csv = "dimension,method,wall_pressure,wall_slip,particles,step[ms],cost[1]\n";
  for (const int dimension : {2, 3}) {
    std::vector<Case> cases;
    for (const Method method : {Method::wcsph, Method::delta_sph}) {
      for (const WallPressure pressure : {WallPressure::mirrored, WallPressure::extrapolated}) {
        for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
          Scene scene = speed_scene(dimension, speed.developed_particles);
          scene.solver.method = method;
          scene.solver.wall_pressure = pressure;
          scene.solver.wall_slip = slip;
          cases.push_back({fmt::format("{},{},{},{}", dimension, name_of(method), name_of(pressure), name_of(slip)),
                           flow_at(scene, options.threads, 0)});
        }
      }
    }
    for (int repeat = 0; repeat < repeats; ++repeat) {
      for (Case& each : cases) {
        const SpeedSample sample = measure_speed(*each.flow, 0.25 * speed.seconds);
        each.milliseconds.push_back(1e-3 * static_cast<double>(sample.particles) / sample.mps);
        each.cost.push_back(each.milliseconds.back() / cases.front().milliseconds.back());
      }
    }
    for (const Case& each : cases) {
      csv += fmt::format("{},{},{:.4g},{:.3f}\n", each.name, each.flow->fluid_particles(), median(each.milliseconds),
                         median(each.cost));
      options.message(fmt::format("{}: {:.2f} times a step of the first", each.name, median(each.cost)));
    }
  }
  return csv;
}

// Replaces the wall particles of a tank that is open at the top by fluid particles, to compare their costs.
void replace_tank_by_fluid(Scene& scene) {
  const Wall wall = scene.walls.at(0);
  const Tank& tank = std::get<Tank>(wall.shape);
  const double thick = wall_layers(scene, wall) * scene.particle_spacing;
  scene.walls.clear();
  Vec3 low = tank.min;
  Vec3 high = tank.max;
  for (int axis = 0; axis < scene.dimension; ++axis) {
    const bool upright = axis == scene.dimension - 1;
    Vec3 inner = high;
    inner[axis] = low[axis];
    Vec3 outer = low;
    outer[axis] -= thick;
    scene.fluid.volumes.push_back({.shape = Box{outer, inner}});
    low[axis] = outer[axis];
    if (upright) continue;
    outer = low;
    outer[axis] = high[axis];
    high[axis] += thick;
    scene.fluid.volumes.push_back({.shape = Box{outer, high}});
  }
}

std::string savings_csv(const SpeedOptions& speed, const ReportOptions& options) {
  struct Case {
    std::string name;
    Scene with;
    Scene without;
    bool log = false;
  };
  std::vector<Case> cases;
  for (const int dimension : {2, 3}) {
    Scene plain = speed_scene(dimension, speed.developed_particles);
    plain.fluid.viscosity = {ViscosityModel::none, 0};
    const auto compare = [&](const char* name, auto change, bool log = false) {
      Case each{fmt::format("{}D, {}", dimension, name), plain, plain, log};
      change(each);
      cases.push_back(std::move(each));
    };
    compare("viscosity", [](Case& each) { each.with.fluid.viscosity = {ViscosityModel::morris, 0}; });
    compare("surface tension", [](Case& each) {
      each.with.fluid.surface_tension = {SurfaceTensionModel::hinsch2024, 0};
    });
    compare("walls out of reach", [&](Case& each) {
      // Fluid without walls, against fluid with a tank out of its reach.
      each.without.walls.clear();
      for (Wall& wall : each.with.walls) {
        Tank& tank = std::get<Tank>(wall.shape);
        tank.min.x += 10;
        tank.max.x += 10;
      }
    });
    compare("walls as fluid", [](Case& each) { replace_tank_by_fluid(each.with); });
    compare(
        "log row in every step", [](Case&) {}, true);
  }
  const auto steps_per_second = [](const SpeedSample& sample) {
    return 1e6 * sample.mps / static_cast<double>(sample.particles);
  };
  std::string csv = "case,with[steps/s],without[steps/s],saving[1]\n";
  for (const Case& each : cases) {
    const std::unique_ptr<Simulation> with = flow_at(each.with, options.threads, 0);
    const std::unique_ptr<Simulation> without = flow_at(each.without, options.threads, 0);
    std::vector<double> speed_with;
    std::vector<double> speed_without;
    std::vector<double> saving;
    for (int k = 0; k < repeats; ++k) {
      speed_with.push_back(steps_per_second(measure_speed(*with, 0.25 * speed.seconds, each.log)));
      speed_without.push_back(steps_per_second(measure_speed(*without, 0.25 * speed.seconds)));
      saving.push_back(1 - speed_with.back() / speed_without.back());
    }
    csv += fmt::format("\"{}\",{:.3f},{:.3f},{:.3f}\n", each.name, median(speed_with), median(speed_without),
                       median(saving));
    options.message(fmt::format("{}: absent, it saves {:.0f} %", each.name, 100 * median(saving)));
  }
  return csv;
}

std::string real_time_csv(const SpeedOptions& speed, const ReportOptions& options) {
  std::string csv = "scene,particles,stiffness[Pa],simulated_time[s],wall_time[s],simulated_per_wall[1]\n";
  for (Scene scene : {shipped_tower(), shipped_dam_break()}) {
    scene.duration = std::min(scene.duration, speed.real_time_duration);
    for (const double k : {1e4, 1e5, 1e6}) {
      scene.solver.compressibility = Stiffness{k};
      scene.timeline.clear();
      const std::unique_ptr<Simulation> simulation = make_simulation(scene, options.threads);
      const Stopwatch watch;
      while (!simulation->finished()) simulation->step();
      const double wall = watch.seconds();
      csv += fmt::format("{},{},{:g},{:g},{:.4g},{:.4g}\n", scene.name, simulation->fluid_particles(), k,
                         simulation->simulated_time(), wall, simulation->simulated_time() / wall);
      options.message(fmt::format("{} with k = {:g} Pa: {:.2f} s simulated per second", scene.name, k,
                                  simulation->simulated_time() / wall));
    }
  }
  return csv;
}

void report_speed(const ReportOptions& options) {
  ReportOptions checked = options;
  if (!checked.message) checked.message = [](const std::string&) {};
  const SpeedOptions speed;
  write_plot(options.folder / "speed", speed_figure(speed, checked));
  write_text(options.folder / "developed_flow.csv", developed_flow_csv(speed, checked));
  write_text(options.folder / "real_time.csv", real_time_csv(speed, checked));
  write_text(options.folder / "methods.csv", methods_csv(speed, checked));
  write_text(options.folder / "savings.csv", savings_csv(speed, checked));
}

}  // namespace weir
