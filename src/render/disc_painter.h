// Draws particles as discs (2D) or shaded balls (3D), one over the other in the order given, with blended edges.
//
// Of the ways measured (points, quads, gathering from a grid) this one draws the usual ten to twenty thousand particles
// fastest on the software renderer, is right at any zoom, and asks nothing of the particles' order in space.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/colormap.h"
#include "render/gl_objects.h"
#include "render/projection.h"

namespace weir {

struct DiscStyle {
  double radius = 0;                  // m
  std::array<double, 2> range{0, 1};  // of the particles' quantity, for the colour map
  bool shaded = false;
};

// A colour map in the device's memory.
class DiscColors {
 public:
  DiscColors(const Colormap& map, double opacity);  // opacity in [0, 1]
  GLuint buffer() const { return buffer_.id(); }

 private:
  GlBuffer buffer_;
};

class DiscPainter {
 public:
  DiscPainter(int width, int height);

  // Into the framebuffer that is bound, over what is there. Particles must be finite.
  void draw(std::span<const glm::vec4> particles, const Projection& projection, const DiscStyle& style,
            const DiscColors& colors);

 private:
  struct Variant {
    GlProgram program;
    GlVertexArray vertices;
  };
  static Variant make_variant(const char* defines, GLuint buffer, GLuint step);
  void set_uniforms(const Variant& variant, const Projection& projection, const DiscStyle& style) const;
  // The largest radius among the particles, pixels.
  static double largest_radius(std::span<const glm::vec4> particles, const Projection& projection, double radius);

  int width_;
  int height_;
  int border_;          // pixels around the picture in which the centres of visible points may lie
  double point_limit_;  // the largest point that the driver draws, pixels
  GlBuffer particles_;
  Variant points_;
  Variant quads_;
};

// The order in which balls are painted: far ones first, those at one depth in the order given; what is behind the eye
// is left out.
void sort_back_to_front(std::vector<glm::vec4>& particles, const Projection& projection);

}  // namespace weir
