#include "scene/paths.h"

#include <fmt/format.h>

#include "scene/describe.h"

namespace weir {

namespace {

// The visitor that finds which of several keys a variant stands under.
class KeyFinder {
 public:
  explicit KeyFinder(int dimension) : dimension_(dimension) {}
  template <class Variant, class More, class... T>
  void one_of(Variant& value, More, const Named<T>&... alternatives) {
    const auto find = [&](bool holds, const auto& alternative) {
      if (holds && (alternative.dimension == 0 || alternative.dimension == dimension_)) key_ = alternative.key;
    };
    (find(std::holds_alternative<T>(value), alternatives), ...);
  }
  template <class... Any>
  void field(Any&&...) {}
  template <class... Any>
  void group(Any&&...) {}
  template <class... Any>
  void not_built(Any&&...) {}
  // Where the variant has no key in this dimension, the path ends above it.
  std::string under(const std::string& path) const { return key_.empty() ? path : fmt::format("{}.{}", path, key_); }

 private:
  int dimension_;
  std::string_view key_;
};

template <class T>
std::string found(const std::string& path, T value, int dimension) {
  KeyFinder finder(dimension);
  describe(finder, value);
  return finder.under(path);
}

}  // namespace

std::string shape_path(const std::string& path, const Shape& shape, int dimension) {
  return found(path, shape, dimension);
}

std::string volume_path(std::size_t index) { return fmt::format("fluid.volumes.{}", index); }

std::string wall_path(std::size_t index) { return fmt::format("walls.{}", index); }

std::string volume_path(const Scene& scene, std::size_t index) {
  return shape_path(volume_path(index), scene.fluid.volumes[index].shape, scene.dimension);
}

std::string wall_path(const Scene& scene, std::size_t index) {
  return found(wall_path(index), scene.walls[index], scene.dimension);
}

}  // namespace weir
