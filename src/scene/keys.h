// The reference of the scene format, row by row, from the field table.
#pragma once

#include <string>
#include <vector>

namespace weir {

struct KeyRow {
  std::string key;    // "fluid.volumes[].box.min"
  std::string type;   // "number", "one of a, b", "vector", ...
  std::string unit;   // "" where there is none
  std::string value;  // default as written in a file; "" if there is none
  bool required = false;
  std::string range;  // "> 0", "0.5 .. 4", or ""
  std::string meaning;
};
std::vector<KeyRow> scene_keys();

}  // namespace weir
