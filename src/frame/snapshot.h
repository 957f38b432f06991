// The border between solver and outputs: sets of particles with named fields at one instant, in SI units. A snapshot is
// filled on demand and holds what its reader asked for, no more.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <variant>
#include <vector>

#include "frame/quantities.h"

namespace weir {

struct Instant {
  std::int64_t index = -1;    // k if time is exactly k / fps, else -1
  double time = 0;            // run time, s
  double simulated_time = 0;  // s; stands still while paused, starts again on reset
  double dt = 0;              // length of the step that led here, s; 0 before the first
  double cfl = 0;             // dt v_max / h [Hinsch24 6.6.2]
  bool cfl_met = true;        // cfl <= the scene's factor lambda
};

enum class Precision { none, single, exact };

struct SnapshotRequest {
  Precision fluid_positions = Precision::single;
  std::vector<Quantity> fluid{};  // quantities of the fluid
  Precision wall_positions = Precision::none;

  bool needs_refresh() const;  // for a quantity that is stale after a step
};

// Values of one quantity, component by component for each particle.
struct FieldValues {
  Quantity quantity{};
  std::size_t components = 1;
  std::variant<std::vector<float>, std::vector<std::int32_t>> values;
};

// Particles in the solver's order, in which neighbours stand near each other; all fields share it.
struct SetSnapshot {
  std::size_t count = 0;
  std::vector<glm::vec3> positions;         // m, of Precision::single; z = 0 in 2D
  std::vector<glm::dvec3> exact_positions;  // m, of Precision::exact; every bit of the solver's state
  std::vector<FieldValues> fields;          // in the order of the request

  // Throws std::out_of_range when the field was not asked for.
  const FieldValues& field(Quantity quantity) const;
  const std::vector<float>& reals(Quantity quantity) const;
  const std::vector<std::int32_t>& integers(Quantity quantity) const;
};

struct Snapshot : Instant {
  glm::dvec3 origin{0};  // m, in the scene's coordinates; positions are relative to it
  SetSnapshot fluid;
  SetSnapshot walls;
};

}  // namespace weir
