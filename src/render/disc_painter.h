// Draws particles of one size as discs (2D) or lit balls (perspective), over a background, into a colour or a movie target.
// The processor projects discs and lists for each part of the picture those that touch it; the device shades. Of dots, discs
// smaller than a pixel, and of balls the processor makes pixels, and the device puts them over the background.
//
// Of the ways measured for discs on the software renderer (points, quads, gathering by pixels or by blocks of pixels) this, by
// blocks, is the fastest from a few thousand particles on; a graphics card draws it as well as any.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "render/balls.h"
#include "render/bins.h"
#include "render/block_target.h"
#include "render/colormap.h"
#include "render/dots.h"
#include "render/gl_objects.h"
#include "render/projection.h"
#include "render/stream_buffer.h"

namespace weir {

struct DiscStyle {
  double radius = 0;                  // m
  std::array<double, 2> range{0, 1};  // of the particles' quantity, for the colour map
  Colormap colors{};
  double opacity = 1;
};

// What becomes of the pixels.
struct DiscOutput {
  bool movie = false;     // Y'CbCr into a MovieTarget, else RGBA into a ColorTarget
  bool straight = false;  // RGBA is not multiplied with alpha
  Rgb background;         // of a movie, behind what is translucent
};

class DiscPainter {
 public:
  DiscPainter(int width, int height);

  // Takes in what draw() shows from now on. `stale` says for each bin whether the target that is drawn to next shows
  // something else than the background there; empty for a target that shows anything.
  void arrange(std::span<const glm::vec4> particles, const Projection& projection, const DiscStyle& style,
               std::vector<std::uint8_t>& stale);
  void draw(GLuint framebuffer, const DiscOutput& output, const Backdrop& background);
  // The same with a layer on top of discs and background, whole blocks of `box` only.
  void draw(GLuint framebuffer, const DiscOutput& output, const Backdrop& background, const ColorTarget& layer,
            std::span<const IntBox> boxes);

 private:
  struct Disc {
    float x = 0;  // pixels
    float y = 0;
    float reach = 0;
    std::uint32_t color = 0;  // place in the map above 24 bits of blue, green and red
  };
  void project_flat(std::span<const glm::vec4> particles, const Projection& projection, const DiscStyle& style);
  void list_squares();
  const GlProgram& program(bool movie, bool overlay);
  void prepare(GLuint framebuffer, const DiscOutput& output, const Backdrop& background, bool overlay);

  int width_;
  int height_;
  Bins bins_;
  std::vector<Disc> discs_;
  double radius_ = 1;  // pixels
  double opacity_ = 1;
  bool are_balls_ = false;
  bool are_dots_ = false;
  Dots dots_;
  Balls balls_;
  StreamBuffer entries_;                // Entry, or Texel of dots and balls
  StreamBuffer ranges_;                 // Bins::Range
  std::vector<std::uint32_t> squares_;  // as in gather.vert: what the bins leave to do
  StreamBuffer square_texels_;
  GlVertexArray no_vertices_;
  std::map<std::string, GlProgram> programs_;
};

}  // namespace weir
