// Colours of everything but the fluid.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace weir {

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
};

// Yellow as in [Hinsch24 ch. 6], deeper than the brightest colour of viridis: visible on white and distinct from fast
// fluid.
inline constexpr std::uint32_t wall_color = 0xf2b705;

struct Palette {
  Rgb background;
  Rgb text;
  Rgb met;      // CFL condition met
  Rgb not_met;  // CFL condition not met
};

inline constexpr Palette palette(Theme theme) {
  if (theme == Theme::dark) return {{22, 25, 30}, {232, 232, 232}, {76, 201, 110}, {255, 99, 88}};
  return {{255, 255, 255}, {28, 28, 28}, {12, 130, 54}, {204, 24, 24}};
}

}  // namespace weir
