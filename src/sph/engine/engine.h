// The engine: visits the particles of a set, and pairs of particles, tile by tile. What is computed comes from passes and
// updates (sph/passes); which of them, and in what order, from a solver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <type_traits>
#include <vector>

#include "core/aligned.h"
#include "core/thread_pool.h"
#include "sph/engine/built.h"
#include "sph/pair_search.h"
#include "sph/particle_set.h"

namespace weir {

// A pass over pairs with particles of one source, ready to run.
template <int Dim>
class PairStage {
 public:
  // `Loop` is Within<Pass> or Between<Pass>.
  template <class Loop, class Pass>
  static PairStage of(InstructionSet set, const Pass& pass, const ParticleSet<Dim>& source) {
    static_assert(std::is_trivially_copyable_v<Pass> && sizeof(Pass) <= sizeof(pass_));
    PairStage stage;
    stage.run_ = pairs_for<Loop, Dim>(set);
    stage.source_ = &source;
    stage.width_ = sum_width<Pass::components>;
    std::memcpy(stage.pass_, &pass, sizeof pass);
    return stage;
  }

  const ParticleSet<Dim>& source() const { return *source_; }
  std::size_t width() const { return width_; }
  void run(const PairArguments<Dim>& in) const { run_(pass_, in); }

 private:
  PairStage() = default;
  RunPairs<Dim> run_ = nullptr;
  const ParticleSet<Dim>* source_ = nullptr;
  std::size_t width_ = 0;  // floats a particle of its sums
  alignas(16) std::byte pass_[192]{};
};

template <int Dim>
class Engine {
 public:
  Engine(InstructionSet instruction_set, double support_radius, PairSearch<Dim>& search, ThreadPool& pool)
      : instruction_set_(instruction_set),
        support_radius_(static_cast<float>(support_radius)),
        search_(search),
        pool_(pool) {}

  // Applies `update` to every particle of the set.
  template <class Update>
  typename Update::Result each(ParticleSet<Dim>& set, const Update& update) {
    return sweep(set, {}, update);
  }

  // Tile by tile of the target, forms the sums of the stages and applies `update`, which reads them. Stages whose source has
  // no particles are not there, nor are tiles that no source is near. Results are combined in the order of tiles. An update
  // must not write what the stages read: sums of other tiles may still be to come.
  template <class Update>
  typename Update::Result sweep(ParticleSet<Dim>& target, std::initializer_list<PairStage<Dim>> stages,
                                const Update& update) {
    const Tiling<Dim>& tiling = search_.tiling(target);
    std::vector<Active> active;
    bool everywhere = stages.size() == 0;
    for (const PairStage<Dim>& stage : stages) {
      if (stage.source().count == 0) continue;
      active.push_back({&stage, search_.pairs(target, stage.source())});
      everywhere = everywhere || &stage.source() == &target;
    }
    const auto apply = each_for<Update>(instruction_set_);
    std::vector<typename Update::Result> results(tiling.tiles().size());
    pool_.for_each(results.size(), [&](std::size_t tile) {
      if (!everywhere && !search_.near(target, tile)) return;
      thread_local AlignedVector<float> sums;
      const auto slots = static_cast<std::size_t>(tiling.slots_of(tile));
      for (std::size_t k = 0; k < active.size(); ++k) {
        sums.resize(larger(sums.size(), active[k].stage->width() * slots));
        active[k].stage->run({.pairs = active[k].pairs,
                              .tile = static_cast<std::int32_t>(tile),
                              .support_radius = support_radius_,
                              .first = k == 0,
                              .sums = sums.data()});
      }
      results[tile] = apply(update, {.slots = tiling.tiles()[tile], .id = target.id.data(), .sums = sums.data()});
    });
    return combine(target, results);
  }

 private:
  struct Active {
    const PairStage<Dim>* stage;
    PairInput<Dim> pairs;
  };

  template <class Result>
  Result combine(const ParticleSet<Dim>& target, const std::vector<Result>& results) {
    Result all;
    if constexpr (!std::is_empty_v<Result>) {
      for (std::size_t tile = 0; tile < results.size(); ++tile) {
        all.combine(results[tile]);
        if constexpr (requires { results[tile].moved; }) search_.follow(target, tile, results[tile].moved);
      }
    }
    return all;
  }

  InstructionSet instruction_set_;
  float support_radius_;  // m
  PairSearch<Dim>& search_;
  ThreadPool& pool_;
};

}  // namespace weir
