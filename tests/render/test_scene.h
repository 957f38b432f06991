// Scenes and particles to draw, made without a solver.
#pragma once

#include <vector>

#include "frame/frame.h"
#include "frame/image.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace weir::test {

struct Still {
  Scene scene;
  StaticScene static_scene;
  Frame frame;
};

// A picture of 320 x 180 pixels without overlay and particles, at `pixels_per_metre` around the origin.
Still blank(double pixels_per_metre);

// A collapsing column in a tank of 3 m x 2 m: about 1,100 fluid particles at 3 cm, made of sines.
Still dam_break();

// A tilted heap of 8 x 8 x 8 balls in an open box.
Still cup();

Image drawn(const Still& still);

}  // namespace weir::test
