// Interface of the CPU rasterisers, whose pixels are composited over the background.
#pragma once

#include <functional>

#include "render/squares.h"
#include "render/texel.h"

namespace weir {

class ParticlePixels {
 public:
  virtual ~ParticlePixels() = default;
  ParticlePixels() = default;
  ParticlePixels(const ParticlePixels&) = delete;
  ParticlePixels& operator=(const ParticlePixels&) = delete;

  // Marks the squares in which there is anything to draw.
  virtual void mark(Squares& squares) = 0;
  // Writes what those squares show to where it belongs among `texels`, with so much of its alpha. After mark(), once
  // for each picture. Says of each row of squares when all of it is there, which may be at the end, and for several
  // rows at once, on threads of its own. `taken` must not throw.
  using RowTaken = std::function<void(int row)>;
  virtual void take(const Squares& squares, double opacity, Texel* texels, const RowTaken& taken) = 0;
};

}  // namespace weir
