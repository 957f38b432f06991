#include "scene/writer.h"

#include "scene/reader.h"

namespace weir {

std::string write_scene(const Scene& scene) {
  Scene copy = scene;  // the field table is written for scenes that can change
  Node root;
  MapWriter writer(root, scene.dimension);
  describe(writer, copy);
  return document_text(root);
}

}  // namespace weir
