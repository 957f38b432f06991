// Colour maps: 256 colours each, as their authors published them.
#pragma once

#include <array>
#include <cstdint>

#include "scene/scene.h"

namespace weir {

using Colormap = std::array<std::uint32_t, 256>;  // 0xRRGGBB, sRGB

const Colormap& colormap(ColormapName name);

// The nearest of the 256 entries; values outside the range take the end colours. The shader computes the same.
int colormap_index(double value, const std::array<double, 2>& range);

}  // namespace weir
