// The visitor that turns a scene into a document tree, by the field table.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/describe.h"
#include "scene/document.h"
#include "scene/names.h"
#include "scene/number.h"

namespace weir {

class MapWriter {
 public:
  MapWriter(Node& map, int dimension) : map_(map), dimension_(dimension) { map_.kind = Node::Kind::map; }

  template <class T>
  void field(std::string_view key, T&& value, const Spec&) {
    if (std::optional<Node> node = leaf(value)) add(key, std::move(*node));
  }

  template <class Describer>
  void group(std::string_view key, std::string_view, Describer describer) {
    Node node;
    MapWriter sub(node, dimension_);
    describer(sub);
    if (!node.children.empty()) add(key, std::move(node));
  }

  template <class T>
  void list(std::string_view key, std::vector<T>& values, const Spec&) {
    Node node = list_node();
    for (T& value : values) {
      Node item;
      MapWriter sub(item, dimension_);
      describe(sub, value);
      node.children.push_back(std::move(item));
    }
    add(key, std::move(node));
  }

  template <class Variant, class More, class... T>
  void one_of(Variant& value, More more, const Named<T>&... alternatives) {
    (write_alternative(value, more, alternatives), ...);
  }

  template <class Variant, class... T>
  void one_field_of(Variant& value, const Leaf<T>&... leaves) {
    (write_leaf(value, leaves), ...);
  }

  template <class Variant, class... Form>
  void forms(std::string_view key, Variant& value, std::string_view, const Form&... all) {
    (write_form(key, value, all), ...);
  }

  template <class Variant, class... T>
  void by_dimension(Variant& value, const Map<T>&...) {
    const auto write = [&](auto* kind) {
      if (kind != nullptr) describe(*this, *kind);
    };
    (write(std::get_if<T>(&value)), ...);
  }

  template <class T>
  void toggle(std::string_view key, std::optional<T>& value, std::string_view) {
    if (!value) return add(key, scalar("false"));
    group(key, "", [&](auto& sub) { describe(sub, *value); });
  }

  template <class T>
  void option(std::string_view key, std::optional<T>& value, std::string_view) {
    if (value) group(key, "", [&](auto& sub) { describe(sub, *value); });
  }

  void version(std::string_view key, int number) { add(key, scalar(fmt::format("{}", number))); }
  void not_built(std::string_view, EmptyForm, std::string_view) {}

 private:
  static Node scalar(std::string text, bool quoted = false) {
    Node node;
    node.kind = Node::Kind::scalar;
    node.text = std::move(text);
    node.quoted = quoted;
    return node;
  }
  static Node list_node() {
    Node node;
    node.kind = Node::Kind::list;
    return node;
  }
  void add(std::string_view key, Node node) {
    node.key = key;
    map_.children.push_back(std::move(node));
  }

  // Nothing: the key is left out.
  std::optional<Node> leaf(double value) const { return scalar(number_text(value)); }
  std::optional<Node> leaf(int value) const { return scalar(fmt::format("{}", value)); }
  std::optional<Node> leaf(bool value) const { return scalar(value ? "true" : "false"); }
  std::optional<Node> leaf(const std::string& value) const { return scalar(value, true); }
  std::optional<Node> leaf(const FileName& name) const { return leaf(name.value); }
  std::optional<Node> leaf(const Vec3& value) const {
    Node node = list_node();
    for (int axis = 0; axis < dimension_; ++axis) node.children.push_back(*leaf(value[axis]));
    return node;
  }
  std::optional<Node> leaf(const Spin& spin) const { return dimension_ == 2 ? leaf(spin.value.z) : leaf(spin.value); }
  std::optional<Node> leaf(const AutoRange& range) const {
    return range.value ? leaf(*range.value) : std::optional<Node>(scalar("auto"));
  }
  template <class T>
  std::optional<Node> leaf(const OrWord<T>& value) const {
    const bool stands_for = value.value == value.stands_for;
    return stands_for ? std::optional<Node>(scalar(std::string(value.word))) : leaf(value.value);
  }
  template <class T>
  std::optional<Node> leaf(const std::optional<T>& value) const {
    return value ? leaf(*value) : std::nullopt;
  }
  template <class T, std::size_t N>
  std::optional<Node> leaf(const std::array<T, N>& values) const {
    return leaf(std::vector<T>(values.begin(), values.end()));
  }
  template <class T>
  std::optional<Node> leaf(const std::vector<T>& values) const {
    Node node = list_node();
    for (const T& value : values) node.children.push_back(*leaf(value));
    return node;
  }
  template <class E>
  requires std::is_enum_v<E> std::optional<Node> leaf(E value)
  const { return scalar(std::string(name_of(value))); }

  template <class Variant, class More, class T>
  void write_alternative(Variant& value, More more, const Named<T>& alternative) {
    T* kind = std::get_if<T>(&value);
    if (kind == nullptr || (alternative.dimension != 0 && alternative.dimension != dimension_)) return;
    group(alternative.key, "", [&](auto& sub) {
      describe(sub, *kind);
      more(sub);
    });
  }
  template <class Variant, class T>
  void write_leaf(Variant& value, const Leaf<T>& alternative) {
    if (const T* kind = std::get_if<T>(&value)) add(alternative.key, *leaf(kind->*alternative.member));
  }
  template <class Variant, class T>
  void write_form(std::string_view key, Variant& value, const Word<T>& form) {
    if (std::holds_alternative<T>(value)) add(key, scalar(std::string(form.word)));
  }
  template <class Variant, class T>
  void write_form(std::string_view key, Variant& value, const Map<T>&) {
    T* kind = std::get_if<T>(&value);
    if (kind != nullptr) group(key, "", [&](auto& sub) { describe(sub, *kind); });
  }

  Node& map_;
  int dimension_;
};

}  // namespace weir
