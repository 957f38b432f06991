// The quantities of a particle: one table for scene files, solver, pictures and files.
//
// To add one: a value of Quantity, its line in the table, and its case in src/sph/fill_snapshot.h, which computes it. Reader,
// schema, colour bar, colour range and messages follow. Only a range that no RangeEstimate describes needs a new one, in
// src/render/color_range.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace weir {

enum class Quantity { speed, density, pressure, velocity, id, volume, vorticity };

enum class Components { one, per_axis };
enum class NumberKind { real, integer };

// Sums over neighbours are stale after a step until the solver computes them again.
enum class Stale { never, after_step };

// The colour range that is estimated from the scene when it states none.
enum class RangeEstimate {
  none,             // not one number per particle: it cannot colour
  speed,            // 0 to the largest speed
  pressure,         // 0 to the pressure that belongs to this speed
  density,          // rest density, plus and minus the compression by this pressure
  vorticity,        // a shear by the largest speed over eight spacings, in 2D of either sense
  particle_number,  // all particles of the fluid
  volume_number,    // all volumes of the fluid
};

struct QuantityFacts {
  Quantity quantity;
  std::string_view name;   // in scene files
  std::string_view unit;   // SI, as in scene files; empty: a number that counts
  std::string_view label;  // beside the colour bar
  Components components = Components::one;
  NumberKind kind = NumberKind::real;
  Stale stale = Stale::never;
  RangeEstimate range = RangeEstimate::none;

  constexpr bool colours() const { return range != RangeEstimate::none; }
};

// clang-format off
inline constexpr auto quantities = std::to_array<QuantityFacts>({
    {Quantity::speed,    "speed",    "m/s",    "Speed",    Components::one,      NumberKind::real,    Stale::never,      RangeEstimate::speed},
    {Quantity::density,  "density",  "kg/m^3", "Density",  Components::one,      NumberKind::real,    Stale::after_step, RangeEstimate::density},
    {Quantity::pressure, "pressure", "Pa",     "Pressure", Components::one,      NumberKind::real,    Stale::after_step, RangeEstimate::pressure},
    {Quantity::velocity, "velocity", "m/s",    "Velocity", Components::per_axis, NumberKind::real,    Stale::never,      RangeEstimate::none},
    {Quantity::id,       "id",       "",       "Particle", Components::one,      NumberKind::integer, Stale::never,      RangeEstimate::particle_number},
    {Quantity::volume,   "volume",   "",       "Volume",   Components::one,      NumberKind::integer, Stale::never,      RangeEstimate::volume_number},
    {Quantity::vorticity, "vorticity", "1/s",  "Vorticity", Components::one,     NumberKind::real,    Stale::after_step, RangeEstimate::vorticity},
});
// clang-format on

constexpr const QuantityFacts& facts_of(Quantity quantity) { return quantities[static_cast<std::size_t>(quantity)]; }
constexpr std::string_view name_of(Quantity quantity) { return facts_of(quantity).name; }

constexpr std::size_t components_of(Quantity quantity, int dimension) {
  return facts_of(quantity).components == Components::one ? 1 : static_cast<std::size_t>(dimension);
}

// "speed [m/s]"; a number that counts has a name alone.
std::string name_with_unit(Quantity quantity);
// A unit as text for people has it: "kg/m³" for "kg/m^3".
std::string typeset(std::string_view unit);

}  // namespace weir
