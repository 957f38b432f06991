#include "render/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace weir {

namespace {

// Least extent, m: bounds may be flat (a film, a single particle).
constexpr double least_extent = 1e-12;

void look(Projection& projection, const Vec3& from_direction) {
  projection.forward = -glm::normalize(from_direction);
  // z is up, unless the line of sight is along it.
  const Vec3 sky = std::abs(projection.forward.z) < 0.999 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  projection.right = glm::normalize(glm::cross(projection.forward, sky));
  projection.up = glm::cross(projection.right, projection.forward);
}

std::array<Vec3, 8> corners(const Bounds& bounds) {
  std::array<Vec3, 8> all{};
  for (int k = 0; k < 8; ++k)
    all[k] = Vec3(k & 1 ? bounds.max.x : bounds.min.x, k & 2 ? bounds.max.y : bounds.min.y,
                  k & 4 ? bounds.max.z : bounds.min.z);
  return all;
}

}  // namespace

glm::dvec2 Projection::pixel(const Vec3& point) const {
  const Vec3 seen = point - eye;
  const double s = scale(point);
  return {principal.x + s * glm::dot(right, seen), principal.y - s * glm::dot(up, seen)};
}

Projection projection_of(const View& view, int width, int height) {
  Projection projection;
  projection.principal = {0.5 * width, 0.5 * height};
  if (const auto* flat = std::get_if<View2D>(&view)) {
    projection.eye = Vec3(flat->center.x, flat->center.y, 0);
    projection.focal = width / flat->width;
  } else if (const auto* deep = std::get_if<View3D>(&view)) {
    projection.perspective = true;
    projection.eye = deep->eye;
    projection.focus_depth = std::max(glm::distance(deep->eye, deep->target), least_extent);
    look(projection, deep->eye - deep->target);
    projection.focal = 0.5 * height / std::tan(0.5 * glm::radians(deep->field_of_view));
  }
  return projection;
}

Projection fit_2d(const Bounds& bounds, const PixelBox& content) {
  Projection projection;
  const Vec3 extent = glm::max(bounds.max - bounds.min, Vec3(least_extent));
  projection.focal = std::min(content.width() / extent.x, content.height() / extent.y);
  const Vec3 middle = 0.5 * (bounds.min + bounds.max);
  projection.eye = Vec3(middle.x, middle.y, 0);
  projection.principal = {0.5 * (content.left + content.right), 0.5 * (content.top + content.bottom)};
  return projection;
}

Projection fit_3d(const Bounds& bounds, const PixelBox& content) {
  Projection projection;
  projection.perspective = true;
  look(projection, Vec3(-0.45, -1.0, 0.5));
  // A moderate telephoto lens: 24 degrees across the content's larger side.
  projection.focal = 0.5 * std::max(content.width(), content.height()) / std::tan(glm::radians(12.0));
  projection.principal = {0.5 * (content.left + content.right), 0.5 * (content.top + content.bottom)};

  // Alternates the least distance that keeps all corners inside and the target that centres them; the two depend weakly
  // on each other, so a few rounds converge.
  Vec3 target = 0.5 * (bounds.min + bounds.max);
  for (int round = 0; round < 8; ++round) {
    double distance = least_extent;
    for (const Vec3& corner : corners(bounds)) {
      const Vec3 seen = corner - target;
      const double aside = std::max(std::abs(glm::dot(projection.right, seen)) / (0.5 * content.width()),
                                    std::abs(glm::dot(projection.up, seen)) / (0.5 * content.height()));
      distance = std::max(distance, projection.focal * aside - glm::dot(projection.forward, seen));
    }
    projection.eye = target - distance * projection.forward;
    projection.focus_depth = distance;
    if (round == 7) break;  // the distance belongs to this target
    glm::dvec2 low(1e300);
    glm::dvec2 high(-1e300);
    for (const Vec3& corner : corners(bounds)) {
      const glm::dvec2 at = projection.pixel(corner);
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
    const glm::dvec2 off = (0.5 * (low + high) - projection.principal) * (distance / projection.focal);
    target += off.x * projection.right - off.y * projection.up;
  }
  return projection;
}

}  // namespace weir
