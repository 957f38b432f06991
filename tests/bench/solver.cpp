// The stages of a step, each alone: neighbour structure, passes, and the step. Items are particles, so that items per
// second are particle-steps per second.
//
//   out/build/release/bench_solver --benchmark_filter=2D/100000/avx512 --benchmark_repetitions=5
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "core/thread_pool.h"
#include "equations/kernels.h"
#include "report/speed.h"
#include "scene/sampling.h"
#include "simd/instruction_set.h"
#include "sph/simulation.h"
#include "sph/solver.h"

namespace weir {
namespace {

// A dam break shortly after its start, one step before the stage in question.
template <int Dim>
struct Flow {
  Flow(std::int64_t particles, InstructionSet set, int threads)
      : pool(threads),
        scene(speed_scene(Dim, particles)),
        sampling(sample(scene)),
        owned(make_solver<Dim>(scene, sampling, pool, set)) {
    for (int k = 0; k < 20; ++k) step();
    solver.refresh();
    solver.accelerate();
  }
  void step() {
    solver.refresh();
    solver.accelerate();
    solver.move(dt());
  }
  double dt() const { return 0.2 * solver.smoothing_length() / sound_speed(scene); }

  ThreadPool pool;
  Scene scene;
  Sampling sampling;
  std::unique_ptr<SphSolver<Dim>> owned;
  SphSolver<Dim>& solver = *owned;
};

enum class Stage { sort_and_list, density, acceleration, integrate, step };

template <int Dim>
void run_stage(benchmark::State& state, Stage stage, std::int64_t particles, InstructionSet set) {
  Flow<Dim> flow(particles, set, thread_count(0));
  for (auto _ : state) {
    switch (stage) {
      case Stage::sort_and_list:
        flow.solver.search().expire();
        flow.solver.search().update();
        break;
      case Stage::density:
        flow.solver.recompute();
        break;
      case Stage::acceleration:
        flow.solver.accelerate();
        break;
      case Stage::integrate:
        flow.solver.move(1e-9 * flow.dt());  // hardly moves, so that every repetition finds the same
        break;
      case Stage::step:
        flow.step();
        break;
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(flow.solver.fluid().count));
}

void evaluate_kernel(benchmark::State& state) {
  const auto kernel = kernel_at<WendlandC2, 2>(1);
  float r = 0;
  for (auto _ : state) {
    r = r < 2 ? r + 0.01F : 0;
    benchmark::DoNotOptimize(kernel.value(r) + kernel.derivative_over_r(r));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(evaluate_kernel);

const bool registered = [] {
  const std::pair<Stage, const char*> stages[] = {{Stage::sort_and_list, "sort and list"},
                                                  {Stage::density, "density"},
                                                  {Stage::acceleration, "acceleration"},
                                                  {Stage::integrate, "integrate"},
                                                  {Stage::step, "step"}};
  for (const std::int64_t particles : {10000, 100000}) {
    for (const InstructionSet set : usable_instruction_sets()) {
      for (const auto& [stage, name] : stages) {
        for (const int dimension : {2, 3}) {
          benchmark::RegisterBenchmark(fmt::format("{}D/{}/{}/{}", dimension, particles, name_of(set), name).c_str(),
                                       [=](benchmark::State& state) {
                                         dimension == 2 ? run_stage<2>(state, stage, particles, set)
                                                        : run_stage<3>(state, stage, particles, set);
                                       })
              ->UseRealTime()
              ->Unit(benchmark::kMillisecond);
        }
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace weir
