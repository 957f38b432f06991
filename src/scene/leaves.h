// Reads one value of each type that a field can have; reports mistakes with their position.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/describe.h"
#include "scene/document.h"
#include "scene/names.h"
#include "scene/text.h"

namespace weir {

class LeafReader {
 public:
  // `dimension` 0: not known.
  LeafReader(std::vector<Mistake>& mistakes, std::string path, int dimension)
      : mistakes_(mistakes), path_(std::move(path)), dimension_(dimension) {}

  void read(const Node& node, double& value, const Spec& spec);
  void read(const Node& node, int& value, const Spec& spec);
  void read(const Node& node, bool& value, const Spec& spec);
  void read(const Node& node, std::string& value, const Spec& spec);
  void read(const Node& node, FileName name, const Spec& spec);
  void read(const Node& node, Vec3& value, const Spec& spec);
  void read(const Node& node, Spin spin, const Spec& spec);
  void read(const Node& node, AutoRange range, const Spec& spec);
  void read(const Node& node, std::array<int, 2>& value, const Spec& spec);
  void read(const Node& node, std::vector<double>& value, const Spec& spec);
  void read(const Node& node, std::vector<Vec3>& value, const Spec& spec);

  template <class T>
  void read(const Node& node, std::optional<T>& value, const Spec& spec) {
    T read_value{};
    read(node, read_value, spec);
    value = read_value;
  }

  template <class T>
  void read(const Node& node, OrWord<T> value, const Spec& spec) {
    if (node.kind == Node::Kind::scalar && node.text == value.word) {
      value.value = value.stands_for;
    } else {
      read(node, value.value, spec);
    }
  }

  template <class E>
  requires std::is_enum_v<E>
  void read(const Node& node, E& value, const Spec&) {
    if (!is_scalar(node, fmt::format("one of {}", choices<E>()))) return;
    for (const Name<E>& name : Names<E>::built) {
      if (node.text == name.text) {
        value = name.value;
        return;
      }
    }
    std::vector<std::string_view> names;
    for (const Name<E>& name : Names<E>::built) names.push_back(name.text);
    for (const std::string_view later : Names<E>::later) {
      if (node.text == later)
        return complain(node, fmt::format("'{}' is not built yet; choose from {}", later, choices<E>()));
    }
    const std::string_view close = nearest_name(node.text, names);
    complain(node, fmt::format("expects one of {}, got '{}'{}", choices<E>(), node.text,
                               close.empty() ? "" : fmt::format("; did you mean '{}'?", close)));
  }

  template <class E>
  requires std::is_enum_v<E>
  void read(const Node& node, std::vector<E>& value, const Spec& spec) {
    if (!is_list(node, fmt::format("a list from {}", choices<E>()))) return;
    value.clear();
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      E item{};
      const std::size_t before = mistakes_.size();
      LeafReader(mistakes_, joined(path_, fmt::format("{}", i)), dimension_).read(node.children[i], item, spec);
      if (mistakes_.size() != before) continue;
      for (const E other : value) {
        if (other == item) return complain(node.children[i], fmt::format("holds '{}' twice", name_of(item)));
      }
      value.push_back(item);
    }
  }

  void complain(const Node& node, const std::string& message);

 private:
  template <class E>
  static std::string choices() {
    std::string text;
    for (const Name<E>& name : Names<E>::built) text += (text.empty() ? "" : ", ") + std::string(name.text);
    return text;
  }
  bool is_scalar(const Node& node, const std::string& expected);
  bool is_list(const Node& node, const std::string& expected);
  bool number(const Node& node, double& value, const Spec& spec, const std::string& expected);

  std::vector<Mistake>& mistakes_;
  std::string path_;
  int dimension_;
};

// The demand of the range of `spec` that a value breaks, or an empty text.
std::string range_mistake(double value, const Spec& spec);

// The mistake in the name of a file or folder, or an empty text. The same on all systems: a name that one system or
// shell would misread is refused everywhere.
std::string file_name_mistake(const std::string& name);
inline constexpr int longest_file_name = 200;  // characters; with an ending, systems allow 255

// The content of a node, for messages: "the text 'abc'", "a list".
std::string content(const Node& node);

}  // namespace weir
