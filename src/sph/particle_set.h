// A set of particles (fluid, walls): positions, and named fields of one array per component.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <string_view>

#include "core/aligned.h"
#include "core/thread_pool.h"
#include "sph/positions.h"
#include "sph/tiling.h"

namespace weir {

// carried: part of the state; it follows its particle through a sort and belongs into a checkpoint.
// recomputed: worked out from the state in every step; after a sort it means nothing until then.
enum class Keeping { carried, recomputed };

// Arrays share the set's order of slots and end in the slack that whole registers may read. Empty slots hold zero.
struct Field {
  std::string_view name;
  std::string_view unit;
  Keeping keeping;
  int components;
  std::array<AlignedVector<float>, 3> values{};

  float* data(int component = 0) { return values[static_cast<std::size_t>(component)].data(); }
  const float* data(int component = 0) const { return values[static_cast<std::size_t>(component)].data(); }
  float at(std::size_t slot, int component = 0) const { return values[static_cast<std::size_t>(component)][slot]; }
};

template <int Dim>
class ParticleSet : public Positions<Dim> {
 public:
  std::size_t count = 0;  // particles; slots() is a little more

  // A field of this set; adding one is all that it takes to be sorted. References stay valid.
  Field& add(std::string_view name, std::string_view unit, int components, Keeping keeping);
  const std::deque<Field>& fields() const { return fields_; }

  // Puts particles at these points, in the order of their numbers; fields are zero.
  void start_at(const std::vector<Vec<Dim, double>>& points);
  // After the positions were sorted: carried fields follow, recomputed ones get their size.
  void follow(const Tiling<Dim>& tiling, ThreadPool& pool);

  Vec<Dim> vector_at(const Field& field, std::size_t slot) const {
    Vec<Dim> value{};
    for (int d = 0; d < Dim; ++d) value[d] = field.at(slot, d);
    return value;
  }

 private:
  std::deque<Field> fields_;
  AlignedVector<float> spare_;  // where a sorted component is made
};

extern template class ParticleSet<2>;
extern template class ParticleSet<3>;

}  // namespace weir
