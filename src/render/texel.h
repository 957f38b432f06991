// Rasterised pixels, in the format of the buffer for the device.
#pragma once

#include <array>
#include <cstdint>

#include "render/squares.h"

namespace weir {

// Four pixels of a row, 0xAABBGGRR, the colour not multiplied with alpha.
using Texel = std::array<std::uint32_t, block_width>;

// A square's texels stand block by block: the upper row, then the lower.
inline constexpr int block_texels = block_height;
inline constexpr std::uint32_t square_texels = square_blocks * square_blocks * block_texels;

}  // namespace weir
