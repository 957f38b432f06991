// Entries of the field table beside the key: unit, range, meaning, and the forms of a value.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "core/types.h"

namespace weir {

struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above = false;  // `min` itself is not allowed
};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0, std::numeric_limits<double>::infinity(), false};

struct Spec {
  std::string_view meaning;
  std::string_view unit = {};
  Range range = {};
  bool required = false;
  int multiple = 1;  // whole numbers: a multiple of this
  int least = 0;     // lists: elements at least
};

// One of several keys, holding a map that describes a T; `dimension` 0: any.
template <class T>
struct Named {
  std::string_view key;
  std::string_view meaning;
  int dimension = 0;
};
// One of several keys, holding a number.
template <class T>
struct Leaf {
  std::string_view key;
  double T::*member;
  Spec spec;
};
// One of several forms of a value.
template <class T>
struct Word {
  std::string_view word;
};
template <class T>
struct Map {
  int dimension = 0;
};

// A rotation: a number in 2D, a vector in 3D.
struct Spin {
  Vec3& value;
};
// A name of files and folders.
struct FileName {
  std::string& value;
};
// A number, or a word that stands for one.
template <class T>
struct OrWord {
  T& value;
  T stands_for;
  std::string_view word;
};
// Two increasing numbers, or `auto`.
struct AutoRange {
  std::optional<std::array<double, 2>>& value;
};

enum class EmptyForm { list, off, none };  // [], false, not even that

}  // namespace weir
