// What the processor hands to the device of pixels that it has made itself.
#pragma once

#include <array>
#include <cstdint>

#include "render/bins.h"

namespace weir {

// Four pixels of a row, 0xAABBGGRR, the colour not multiplied with alpha.
using Texel = std::array<std::uint32_t, block_width>;

// A square's texels stand block by block: the upper row, then the lower.
inline constexpr std::uint32_t square_texels = square_width * square_height / block_width;

}  // namespace weir
