// From a YAML file to a valid scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace weir {

// "a.b.c=value", from the command line; `value` is YAML. List elements by number: "walls.0.tank.open=[top]".
struct Override {
  std::string key;
  std::string value;
};
Override parse_override(const std::string& text);  // throws UsageError

// Reads, merges the overrides, checks. Throws SceneError with every mistake (a syntax error alone).
Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

// The same for text in memory; `file` gives the path of positions and the scene's name.
Scene read_scene_text(const std::string& text, const std::filesystem::path& file,
                      const std::vector<Override>& overrides = {});

// The effective scene with every default filled in, as YAML that reads back to the same scene.
std::string write_scene(const Scene& scene);

// JSON Schema (draft-07) of the format, from the same table as the reader.
std::string scene_schema();

}  // namespace weir
