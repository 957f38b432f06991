// The solver's side of a snapshot: positions and fields of its particles, slots without the empty ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/thread_pool.h"
#include "core/types.h"
#include "frame/snapshot.h"
#include "sph/solver.h"

namespace weir {

// Calls visit(particle, slot) for every slot that is not empty, particles numbered by their slots' order, on all threads.
template <int Dim>
class OccupiedSlots {
 public:
  OccupiedSlots(const Positions<Dim>& positions, ThreadPool& pool)
      : positions_(positions), pool_(pool), first_(block_count(positions.slots()) + 1) {
    for (std::size_t slot = 0; slot < positions.slots(); ++slot) {
      if (!positions.empty(slot)) ++first_[slot / block_size + 1];
    }
    for (std::size_t block = 1; block < first_.size(); ++block) first_[block] += first_[block - 1];
  }

  std::size_t count() const { return first_.back(); }

  template <class Visit>
  void for_each(const Visit& visit) const {
    parallel_blocks(positions_.slots(), pool_, [&](std::size_t block, std::size_t begin, std::size_t end) {
      std::size_t particle = first_[block];
      for (std::size_t slot = begin; slot < end; ++slot) {
        if (!positions_.empty(slot)) visit(particle++, slot);
      }
    });
  }

 private:
  const Positions<Dim>& positions_;
  ThreadPool& pool_;
  std::vector<std::size_t> first_;  // particle of each block of slots
};

template <int Dim>
void fill_positions(const Positions<Dim>& positions, const TileLattice<Dim>& lattice,
                    const OccupiedSlots<Dim>& occupied, Precision precision, SetSnapshot& set) {
  set.count = occupied.count();
  set.positions.resize(precision == Precision::single ? set.count : 0);
  set.exact_positions.resize(precision == Precision::exact ? set.count : 0);
  const auto fill = [&](auto& filled) {
    occupied.for_each([&](std::size_t particle, std::size_t slot) {
      const Vec<Dim, double> x = lattice.in_domain(positions.position(slot));
      glm::dvec3 at(0);
      for (int d = 0; d < Dim; ++d) at[d] = x[d];
      filled[particle] = at;
    });
  };
  if (precision == Precision::single) fill(set.positions);
  if (precision == Precision::exact) fill(set.exact_positions);
}

// The solver's values that fields are computed from.
template <int Dim>
struct FieldSources {
  SphSolver<Dim>& solver;
  std::span<const std::int32_t> volume_ends;  // of each fluid volume, one more than its last particle's id
};

// The values of a field as numbers of type T; memory that they have is used again.
template <class T>
std::vector<T>& values_of(FieldValues& field, std::size_t count) {
  if (!std::holds_alternative<std::vector<T>>(field.values)) field.values = std::vector<T>();
  auto& values = std::get<std::vector<T>>(field.values);
  values.resize(count);
  return values;
}

template <int Dim>
void fill_field(const FieldSources<Dim>& from, const OccupiedSlots<Dim>& occupied, FieldValues& field) {
  const auto fill = [&](auto& values, const auto& value_at) {
    occupied.for_each([&](std::size_t particle, std::size_t slot) { values[particle] = value_at(slot); });
  };
  const auto reals = [&](const auto& value_at) { fill(values_of<float>(field, occupied.count()), value_at); };
  const auto integers = [&](const auto& value_at) { fill(values_of<std::int32_t>(field, occupied.count()), value_at); };
  switch (field.quantity) {
    case Quantity::speed:
      return reals([&](std::size_t slot) {
        const Vec<Dim> v = from.solver.fluid().vector_at(from.solver.velocity(), slot);
        return std::sqrt(dot(v, v));
      });
    case Quantity::density:
      return reals([&](std::size_t slot) { return from.solver.density().at(slot); });
    case Quantity::pressure:
      return reals([&](std::size_t slot) { return static_cast<float>(from.solver.pressure_at(slot)); });
    case Quantity::velocity: {
      auto& values = values_of<float>(field, Dim * occupied.count());
      return occupied.for_each([&](std::size_t particle, std::size_t slot) {
        const Vec<Dim> v = from.solver.fluid().vector_at(from.solver.velocity(), slot);
        for (int d = 0; d < Dim; ++d) values[Dim * particle + static_cast<std::size_t>(d)] = v[d];
      });
    }
    case Quantity::vorticity: {  // along z in 2D, its size in 3D
      const Field& curl = from.solver.vorticity();
      return reals([&](std::size_t slot) {
        if constexpr (Dim == 2) return curl.at(slot);
        const Vec<Dim> w = from.solver.fluid().vector_at(curl, slot);
        return std::sqrt(dot(w, w));
      });
    }
    case Quantity::id:
      return integers([&](std::size_t slot) { return from.solver.fluid().id[slot]; });
    case Quantity::volume:
      return integers([&](std::size_t slot) {
        const auto end =
            std::upper_bound(from.volume_ends.begin(), from.volume_ends.end(), from.solver.fluid().id[slot]);
        return static_cast<std::int32_t>(end - from.volume_ends.begin());
      });
  }
}

// Fluid as the request asks for it.
template <int Dim>
void fill_fluid(const FieldSources<Dim>& from, const SnapshotRequest& request, ThreadPool& pool, SetSnapshot& set) {
  const ParticleSet<Dim>& fluid = from.solver.fluid();
  const OccupiedSlots<Dim> occupied(fluid, pool);
  fill_positions(fluid, from.solver.search().lattice(), occupied, request.fluid_positions, set);
  set.fields.resize(request.fluid.size());
  for (std::size_t k = 0; k < set.fields.size(); ++k) {
    set.fields[k].quantity = request.fluid[k];
    set.fields[k].components = components_of(request.fluid[k], Dim);
    fill_field(from, occupied, set.fields[k]);
  }
}

template <int Dim>
void fill_walls(const SphSolver<Dim>& solver, Precision precision, ThreadPool& pool, SetSnapshot& set) {
  if (precision == Precision::none) {
    set = {};
    return;
  }
  fill_positions(solver.walls(), solver.search().lattice(), OccupiedSlots<Dim>(solver.walls(), pool), precision, set);
}

}  // namespace weir
