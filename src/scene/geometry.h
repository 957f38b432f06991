// Plane and box geometry of the scene's shapes.
#pragma once

#include <limits>
#include <vector>

#include "scene/scene.h"

namespace weir {

// Even-odd rule; points on the outline may go either way, but of two polygons that share an edge only one has them.
bool inside_polygon(const std::vector<Vec3>& polygon, const Vec3& point);
// Where a line along x at this height crosses the outline, ascending: inside lies between each odd one and the next.
void crossings(const std::vector<Vec3>& polygon, double y, std::vector<double>& result);
double signed_area(const std::vector<Vec3>& polygon);  // positive: counterclockwise
Vec3 centroid(const std::vector<Vec3>& polygon);       // of its area
double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b);
bool segments_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);  // touching counts

// The outline as a closed line with its layers on the solid side.
Polyline outline_of(const PolygonWall& polygon);

bool inside(const Shape& shape, const Vec3& point, int dimension);
Vec3 shape_center(const Shape& shape);
double measure(const Shape& shape, int dimension);  // m^2 or m^3
Bounds shape_bounds(const Shape& shape, int dimension);

inline const Bounds everywhere{Vec3(-std::numeric_limits<double>::infinity()),
                               Vec3(std::numeric_limits<double>::infinity())};
inline const Bounds empty_bounds{everywhere.max, everywhere.min};  // around nothing

// Whether two boxes share less than `gap` along some axis; below zero, whether they stay that far from each other.
bool apart(const Bounds& a, const Bounds& b, int dimension, double gap);
bool contains(const Bounds& box, const Vec3& point);
Bounds grown(const Bounds& box, double margin);
Bounds around(const Bounds& a, const Bounds& b);

}  // namespace weir
