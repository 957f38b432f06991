// Particles as pixels of the processor's making, which the device lays over the background.
#pragma once

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
  virtual void mark(Squares& squares) const = 0;
  // Writes what those squares show to where it belongs among `texels`, with so much of its alpha. Once for each picture.
  virtual void take(const Squares& squares, double opacity, Texel* texels) = 0;
};

}  // namespace weir
