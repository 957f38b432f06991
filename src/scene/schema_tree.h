// The visitor that makes a JSON Schema of the field table. Beside the schema's own keywords each leaf carries
// "weir:kind", "weir:unit" and "weir:meaning" for the reference; scene_schema() turns them into descriptions.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "scene/describe.h"
#include "scene/leaves.h"
#include "scene/names.h"

namespace weir {

using Json = nlohmann::ordered_json;

// Numbers that are whole are written without a fraction.
inline Json number_json(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e9) return static_cast<std::int64_t>(value);
  return value;
}

// The JSON type of a leaf, by the type of the field; and its default.
class LeafSchema {
 public:
  explicit LeafSchema(const Spec& spec) : spec_(spec) {}

  Json type(double) const {
    Json result{{"type", "number"}, {"weir:kind", "number"}};
    add_range(result);
    return result;
  }
  Json type(int) const {
    Json result{{"type", "integer"}, {"weir:kind", "whole number"}};
    add_range(result);
    if (spec_.multiple != 1) result["multipleOf"] = spec_.multiple;
    return result;
  }
  Json type(bool) const { return {{"type", "boolean"}, {"weir:kind", "true or false"}}; }
  Json type(const std::string&) const { return {{"type", "string"}, {"weir:kind", "text"}}; }
  Json type(const FileName&) const {
    return {{"type", "string"},
            {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_.-]*$"},
            {"maxLength", longest_file_name},
            {"weir:kind", "text"}};
  }
  Json type(const Vec3&) const {
    return {{"type", "array"}, {"items", type(0.0)}, {"minItems", 2}, {"maxItems", 3}, {"weir:kind", "vector"}};
  }
  Json type(const Spin&) const {
    return {{"anyOf", Json::array({type(0.0), type(Vec3())})}, {"weir:kind", "number or vector"}};
  }
  Json type(const AutoRange&) const { return or_word("auto", type(std::array<double, 2>())); }
  template <class T>
  Json type(const OrWord<T>& value) const {
    return or_word(value.word, type(T{}));
  }
  template <class T>
  Json type(const std::optional<T>&) const {
    return type(T{});
  }
  template <class T, std::size_t N>
  Json type(const std::array<T, N>&) const {
    return {{"type", "array"},
            {"items", type(T{})},
            {"minItems", N},
            {"maxItems", N},
            {"weir:kind", fmt::format("{} {}s", N, kind(T{}))}};
  }
  template <class T>
  Json type(const std::vector<T>&) const {
    Json result{{"type", "array"}, {"items", type(T{})}, {"weir:kind", fmt::format("list of {}", plural(T{}))}};
    if (spec_.least > 0) result["minItems"] = spec_.least;
    if (std::is_enum_v<T>) result["uniqueItems"] = true;
    return result;
  }
  template <class E>
  requires std::is_enum_v<E> Json type(E)
  const {
    Json words = Json::array();
    std::string kind;
    for (const Name<E>& name : Names<E>::built) {
      words.push_back(name.text);
      kind += (kind.empty() ? "" : ", ") + std::string(name.text);
    }
    return {{"enum", words}, {"weir:kind", kind}};
  }

  Json value(double number) const { return number_json(number); }
  Json value(int number) const { return number; }
  Json value(bool truth) const { return truth; }
  Json value(const std::string& text) const { return text; }
  Json value(const FileName&) const { return nullptr; }  // by default the file's name
  Json value(const Vec3& vector) const { return Json::array({number_json(vector.x), number_json(vector.y)}); }
  Json value(const Spin& spin) const { return number_json(spin.value.z); }
  Json value(const AutoRange& range) const { return range.value ? value(*range.value) : Json("auto"); }
  template <class T>
  Json value(const OrWord<T>& number) const {
    return number.value == number.stands_for ? Json(number.word) : value(number.value);
  }
  template <class T>
  Json value(const std::optional<T>&) const {
    return nullptr;
  }
  template <class T, std::size_t N>
  Json value(const std::array<T, N>& values) const {
    return value(std::vector<T>(values.begin(), values.end()));
  }
  template <class T>
  Json value(const std::vector<T>& values) const {
    Json list = Json::array();
    for (const T& each : values) list.push_back(value(each));
    return list;
  }
  template <class E>
  requires std::is_enum_v<E> Json value(E each)
  const { return name_of(each); }

 private:
  template <class T>
  std::string kind(const T& each) const {
    return type(each).at("weir:kind");
  }
  std::string plural(double) const { return "numbers"; }
  std::string plural(const Vec3&) const { return "points"; }
  template <class E>
  requires std::is_enum_v<E> std::string plural(E each)
  const { return kind(each); }
  static Json or_word(std::string_view word, const Json& type) {
    return {{"anyOf", Json::array({Json{{"const", word}}, type})},
            {"weir:kind", fmt::format("{} or {}", word, type.at("weir:kind").get<std::string>())}};
  }
  void add_range(Json& type) const {
    const Range& range = spec_.range;
    if (std::isfinite(range.min)) type[range.above ? "exclusiveMinimum" : "minimum"] = number_json(range.min);
    if (std::isfinite(range.max)) type["maximum"] = number_json(range.max);
  }

  const Spec& spec_;
};

class MapSchema {
 public:
  template <class T>
  void field(std::string_view key, T&& value, const Spec& spec) {
    const LeafSchema leaf(spec);
    Json type = leaf.type(value);
    type["weir:meaning"] = spec.meaning;
    type["weir:unit"] = spec.unit;
    if (spec.required) {
      required_.push_back(key);
    } else if (Json given = leaf.value(value); !given.is_null()) {
      type["default"] = std::move(given);
    }
    add(key, std::move(type));
  }

  template <class Describer>
  void group(std::string_view key, std::string_view meaning, Describer describer) {
    MapSchema sub;
    describer(sub);
    if (!sub.required_.empty()) required_.push_back(key);
    add(key, with_meaning(sub.schema(), meaning));
  }

  template <class T>
  void list(std::string_view key, std::vector<T>&, const Spec& spec) {
    Json type{{"type", "array"}, {"items", of<T>([](auto&) {})}};
    if (spec.least > 0) type["minItems"] = spec.least;
    if (spec.required) {
      required_.push_back(key);
    } else {
      type["default"] = Json::array();
    }
    add(key, with_meaning(std::move(type), spec.meaning));
  }

  template <class Variant, class More, class... T>
  void one_of(Variant&, More more, const Named<T>&... alternatives) {
    Json choices = Json::array();
    (add_alternative(choices, more, alternatives), ...);
    constraints_.push_back({{"oneOf", std::move(choices)}});
  }

  template <class Variant, class First, class Second>
  void one_field_of(Variant&, const Leaf<First>& first, const Leaf<Second>& second) {
    First standard{};
    field(first.key, standard.*first.member, first.spec);
    std::optional<double> none;
    field(second.key, none, second.spec);
    constraints_.push_back({{"not", {{"required", Json::array({first.key, second.key})}}}});
  }

  template <class Variant, class... Form>
  void forms(std::string_view key, Variant& value, std::string_view meaning, const Form&... all) {
    Json choices = Json::array();
    Json type;
    (add_form(choices, type, value, all), ...);
    type["anyOf"] = std::move(choices);
    add(key, with_meaning(std::move(type), meaning));
  }

  template <class Variant, class... T>
  void by_dimension(Variant&, const Map<T>&...) {
    Json choices = Json::array();
    const auto merge = [&](auto* type) {
      MapSchema sub;
      std::remove_pointer_t<decltype(type)> value{};
      describe(sub, value);
      for (const auto& [key, property] : sub.properties_.items()) add(key, property);
      choices.push_back({{"required", sub.required_}});
    };
    (merge(static_cast<T*>(nullptr)), ...);
    constraints_.push_back({{"oneOf", std::move(choices)}});
  }

  template <class T>
  void toggle(std::string_view key, std::optional<T>& value, std::string_view meaning) {
    Json type{{"anyOf", Json::array({Json{{"type", "boolean"}}, of<T>([](auto&) {})})}, {"default", value.has_value()}};
    add(key, with_meaning(std::move(type), meaning));
  }

  template <class T>
  void option(std::string_view key, std::optional<T>&, std::string_view meaning) {
    add(key, with_meaning(of<T>([](auto&) {}), meaning));
  }

  void version(std::string_view key, int number) {
    required_.push_back(key);
    add(key, {{"const", number}, {"weir:kind", fmt::format("{}", number)}, {"weir:meaning", "version of the format"}});
  }

  void not_built(std::string_view key, EmptyForm empty, std::string_view meaning) {
    Json type;
    if (empty == EmptyForm::list) type = {{"type", "array"}, {"maxItems", 0}};
    if (empty == EmptyForm::off) type = {{"const", false}};
    if (empty == EmptyForm::none) type = {{"not", Json::object()}};
    add(key, with_meaning(std::move(type), fmt::format("{}: not built yet", meaning)));
  }

  Json schema() const {
    Json result{{"type", "object"}, {"properties", properties_}};
    if (!required_.empty()) result["required"] = required_;
    result["additionalProperties"] = false;
    if (!constraints_.empty()) result["allOf"] = constraints_;
    return result;
  }

  template <class T, class More>
  static Json of(More more) {
    MapSchema sub;
    T value{};
    describe(sub, value);
    more(sub);
    return sub.schema();
  }

 private:
  static Json with_meaning(Json type, std::string_view meaning) {
    type["weir:meaning"] = meaning;
    return type;
  }
  void add(std::string_view key, Json type) { properties_[std::string(key)] = std::move(type); }

  template <class More, class T>
  void add_alternative(Json& choices, More more, const Named<T>& alternative) {
    add(alternative.key, with_meaning(of<T>(more), alternative.meaning));
    choices.push_back({{"required", Json::array({alternative.key})}});
  }
  template <class Variant, class T>
  void add_form(Json& choices, Json& type, Variant& value, const Word<T>& form) {
    choices.push_back({{"const", form.word}});
    if (std::holds_alternative<T>(value)) type["default"] = form.word;
  }
  template <class Variant, class T>
  void add_form(Json& choices, Json&, Variant&, const Map<T>&) {
    choices.push_back(of<T>([](auto&) {}));
  }

  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json constraints_ = Json::array();
};

}  // namespace weir
