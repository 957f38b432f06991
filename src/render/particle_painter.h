// Draws particles of one size as discs (2D) or lit spheres (perspective) over a background, into a colour or a movie
// target. The processor projects and rasterises them as discs, dots or spheres; the device composites the pixels over
// the background.
//
// On the software renderer this is faster than points, quads, or gathering by pixels or blocks of pixels on the device;
// on a graphics card nothing was measured.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "render/balls.h"
#include "render/block_target.h"
#include "render/colormap.h"
#include "render/disc_pixels.h"
#include "render/dots.h"
#include "render/gl_objects.h"
#include "render/particle_pixels.h"
#include "render/projection.h"
#include "render/squares.h"
#include "render/stream_buffer.h"

namespace weir {

struct ParticleStyle {
  double radius = 0;                  // m
  std::array<double, 2> range{0, 1};  // of the particles' quantity, for the colour map
  Colormap colors{};
  double opacity = 1;
};

// What becomes of the pixels.
enum class PixelsFor {
  movie,     // Y'CbCr into a MovieTarget, over a backdrop that is opaque
  picture,   // RGBA into a ColorTarget
  backdrop,  // the same, multiplied with alpha
};

class ParticlePainter {
 public:
  ParticlePainter(int width, int height, int threads = 0);  // as for thread_count()

  // Takes in what draw() shows from now on. `stale` says for each square whether the target that is drawn to next shows
  // something else than the background there; empty for a target that shows anything. `arranged` is told when all of a
  // row of squares is there.
  void arrange(
      std::span<const glm::vec4> particles, const Projection& projection, const ParticleStyle& style,
      std::vector<std::uint8_t>& stale, const ParticlePixels::RowTaken& arranged = [](int) {});
  // What draw() shows. Reading texels takes long where the device is not the processor.
  const Squares& squares() const { return squares_; }
  const Texel* texels() const { return arranged_texels_; }
  void draw(GLuint framebuffer, PixelsFor use, const Backdrop& background);
  // The same with a layer on top of particles and background, whole blocks of `box` only.
  void draw(GLuint framebuffer, PixelsFor use, const Backdrop& background, const ColorTarget& layer,
            std::span<const IntBox> boxes);

 private:
  ParticlePixels& pixels_of(std::span<const glm::vec4> particles, const Projection& projection,
                            const ParticleStyle& style);
  const GlProgram& program(bool movie, bool overlay);
  void prepare(GLuint framebuffer, PixelsFor use, const Backdrop& background, bool overlay);
  void drawn();

  Squares squares_;
  DiscPixels discs_;
  Dots dots_;
  Balls balls_;
  StreamBuffer texels_;
  Texel* arranged_texels_ = nullptr;  // in the buffer
  StreamBuffer first_texels_;
  StreamBuffer to_draw_;
  GlVertexArray no_vertices_;
  std::map<std::string, GlProgram> programs_;
};

}  // namespace weir
