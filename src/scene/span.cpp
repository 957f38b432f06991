#include "scene/span.h"

#include "scene/geometry.h"

namespace weir {

namespace {

Bounds span_of(const Tank& tank, int) { return {tank.min, tank.max}; }
Bounds span_of(const Block& block, int) { return {block.min, block.max}; }
Bounds span_of(const Polyline& line, int dimension) { return shape_bounds(Polygon{line.points}, dimension); }
Bounds span_of(const Round& round, int dimension) { return shape_bounds(Ball{round.center, round.radius}, dimension); }
Bounds span_of(const PolygonWall& polygon, int dimension) { return shape_bounds(Polygon{polygon.points}, dimension); }

}  // namespace

Bounds wall_span(const WallShape& shape, int dimension) {
  return std::visit([&](const auto& each) { return span_of(each, dimension); }, shape);
}

Bounds scene_span(const Scene& scene) {
  Bounds all = empty_bounds;
  for (const Volume& volume : scene.fluid.volumes) all = around(all, shape_bounds(volume.shape, scene.dimension));
  for (const Wall& wall : scene.walls) all = around(all, wall_span(wall.shape, scene.dimension));
  return all;
}

}  // namespace weir
