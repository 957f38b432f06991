#include "scene/sample_polyline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/geometry.h"
#include "scene/point_grid.h"
#include "scene/sampling.h"

namespace weir {

namespace {

// A corner of a layer, whether a particle sits in it (it does not at the free ends of an open line), and the direction
// of the segment that the piece from here on runs along (zero: around a corner).
struct Corner {
  Vec3 at;
  Vec3 along{0};
  bool free_end = false;
};

std::vector<Vec3> without_repeats(const Polyline& line) {
  std::vector<Vec3> points;
  for (const Vec3& point : line.points) {
    if (points.empty() || point != points.back()) points.push_back(point);
  }
  if (line.closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

// A straight piece of the line.
struct Segment {
  Vec3 along;   // unit vector
  Vec3 normal;  // unit vector towards the solid flank
};

std::vector<Segment> segments_of(const std::vector<Vec3>& points, const Polyline& line) {
  const double sense = line.solid == Flank::left ? 1 : -1;
  std::vector<Segment> result;
  const std::size_t count = line.closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 along = glm::normalize(points[(i + 1) % points.size()] - points[i]);
    result.push_back({along, sense * Vec3(-along.y, along.x, 0)});
  }
  return result;
}

// The layer at distance `d` around one corner. Where the layer runs around the outside, a turn of up to a right angle
// is mitred and a sharper one is cut into equal turns of at most that, so that no corner runs far out.
void add_corner(std::vector<Corner>& layer, const Vec3& corner, const Segment& before, const Segment& after, double d) {
  const double sine = before.along.x * after.along.y - before.along.y * after.along.x;
  const double turn = std::atan2(sine, glm::dot(before.along, after.along));
  const bool outside = glm::dot(before.normal, after.along) <= 0;
  const auto pieces = static_cast<int>(std::ceil(std::abs(turn) / (0.5 * std::numbers::pi) - 1e-9));
  const int count = outside ? std::max(1, pieces) : 1;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * (i + 0.5) / count;
    const Vec3& n = before.normal;
    const Vec3 middle(n.x * std::cos(angle) - n.y * std::sin(angle), n.x * std::sin(angle) + n.y * std::cos(angle), 0);
    layer.push_back({corner + d / std::cos(0.5 * turn / count) * middle, i + 1 == count ? after.along : Vec3(0)});
  }
}

std::vector<Corner> layer_at(const std::vector<Vec3>& points, const std::vector<Segment>& segments, bool closed,
                             double d) {
  std::vector<Corner> layer;
  if (!closed) layer.push_back({points.front() + d * segments.front().normal, segments.front().along, true});
  for (std::size_t i = closed ? 0 : 1; i < (closed ? points.size() : points.size() - 1); ++i) {
    add_corner(layer, points[i], segments[(i + segments.size() - 1) % segments.size()], segments[i], d);
  }
  if (!closed) layer.push_back({points.back() + d * segments.back().normal, Vec3(0), true});
  return layer;
}

// Particles from corner `a` up to, but without, corner `b`; a free end stands half a spacing beyond the last particle.
void add_piece(std::vector<Vec3>& points, const Corner& a, const Corner& b, double dx) {
  const double length = glm::length(b.at - a.at);
  const double skipped = (a.free_end ? 0.5 : 0.0) + (b.free_end ? 0.5 : 0.0);
  const double spacings = std::max(1.0, std::round(length / dx - skipped) + skipped);
  const double start = a.free_end ? 0.5 : 0.0;
  for (double i = start; i < spacings - 1e-9 - (b.free_end ? 0.25 : 0.0); i += 1) {
    points.push_back(a.at + i / spacings * (b.at - a.at));
  }
}

bool nearer_to_line(const std::vector<Vec3>& points, bool closed, const Vec3& point, double distance) {
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
    if (distance_to_segment(point, points[i], points[(i + 1) % points.size()]) < distance) return true;
  }
  return false;
}

}  // namespace

std::vector<Vec3> sample_polyline(const Polyline& line, double dx, int layers) {
  const std::vector<Vec3> points = without_repeats(line);
  if (points.size() < 2) return {};
  const std::vector<Segment> segments = segments_of(points, line);
  std::vector<Vec3> result;
  PointGrid kept(wall_merge_distance * dx);
  for (int k = 0; k < layers; ++k) {
    const double d = (k + 0.5) * dx;
    const std::vector<Corner> layer = layer_at(points, segments, line.closed, d);
    std::vector<Vec3> candidates;
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < layer.size(); ++i) {
      const Corner& from = layer[i];
      const Corner& to = layer[(i + 1) % layer.size()];
      if (glm::dot(to.at - from.at, from.along) < -1e-6 * dx) continue;  // a segment too short for this depth
      add_piece(candidates, from, to, dx);
    }
    for (const Vec3& point : candidates) {
      // Asked first, for it costs less: around many corners most candidates fall together.
      if (kept.any_near(point, wall_merge_distance * dx)) continue;
      // Where the line bends more sharply than the layer is deep, pieces of the layer run through each other and come
      // too near to another part of the line: these are cut away.
      if (nearer_to_line(points, line.closed, point, d - 1e-6 * dx)) continue;
      kept.add(point, 0);
      result.push_back(point);
    }
  }
  return result;
}

}  // namespace weir
