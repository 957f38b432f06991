// Scenes as text, and the mistakes that the reader finds in them.
#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/reader.h"

namespace weir {

// The shortest 2D scene; lines 1 to 5.
inline const std::string shortest_text =
    "weir: 1\n"
    "dimension: 2\n"
    "duration: 2\n"
    "particles: {spacing: 0.1}\n"
    "fluid: {volumes: [{box: {min: [0, 0], max: [1, 1]}}]}\n";

inline const std::string shortest_3d_text =
    "weir: 1\n"
    "dimension: 3\n"
    "duration: 2\n"
    "particles: {spacing: 0.1}\n"
    "fluid: {volumes: [{box: {min: [0, 0, 0], max: [1, 1, 1]}}]}\n";

// Every mistake as "where: message".
inline std::vector<std::string> mistakes_in(const std::string& text, const std::vector<std::string>& options = {}) {
  std::vector<Override> overrides;
  for (const std::string& option : options) overrides.push_back(parse_override(option));
  std::vector<std::string> all;
  try {
    read_scene_text(text, "s.yaml", overrides);
  } catch (const SceneError& error) {
    for (const SceneMistake& mistake : error.mistakes) all.push_back(mistake.where + ": " + mistake.message);
  }
  return all;
}

inline Scene scene_of(const std::string& text, const std::vector<std::string>& options = {}) {
  std::vector<Override> overrides;
  for (const std::string& option : options) overrides.push_back(parse_override(option));
  return read_scene_text(text, "s.yaml", overrides);
}

}  // namespace weir
