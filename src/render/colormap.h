// Colour maps of 256 colours, as published.
#pragma once

#include <array>
#include <cstdint>

#include "scene/scene.h"

namespace weir {

using Colormap = std::array<std::uint32_t, 256>;  // 0xRRGGBB, sRGB

const Colormap& colormap(ColormapName name);

// Index of the nearest entry; values outside the range have the end colours. The shader computes the same.
int colormap_index(double value, const std::array<double, 2>& range);

}  // namespace weir
