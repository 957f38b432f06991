#include <fmt/format.h>

#include "scene/document.h"
#include "scene/keys.h"
#include "scene/number.h"
#include "scene/reader.h"
#include "scene/schema_tree.h"

namespace weir {

namespace {

Json tree() {
  return MapSchema::of<Scene>([](auto&) {});
}

// Meaning and unit become the description that editors show.
void finish(Json& node) {
  if (node.is_object()) {
    const std::string unit = node.value("weir:unit", "");
    std::string description = node.value("weir:meaning", "");
    if (!unit.empty() && unit != "1") description += fmt::format(" [{}]", unit);
    for (const char* extra : {"weir:kind", "weir:unit", "weir:meaning"}) node.erase(extra);
    if (!description.empty()) node["description"] = description;
  }
  for (Json& each : node) {
    if (each.is_structured()) finish(each);
  }
}

// The leaf's own limits, or those of the elements in it.
std::string range_text(const Json& type) {
  if (type.contains("items")) return range_text(type.at("items"));
  for (const Json& form : type.value("anyOf", Json::array())) {
    if (std::string text = range_text(form); !text.empty()) return text;
  }
  const std::string multiple = type.contains("multipleOf") ? fmt::format(", in {}s", type.at("multipleOf").dump()) : "";
  if (type.contains("exclusiveMinimum")) {
    const std::string low = "> " + type.at("exclusiveMinimum").dump();
    return (type.contains("maximum") ? fmt::format("{}, <= {}", low, type.at("maximum").dump()) : low) + multiple;
  }
  if (!type.contains("minimum")) return "";
  const std::string low = type.at("minimum").dump();
  return (type.contains("maximum") ? fmt::format("{} .. {}", low, type.at("maximum").dump()) : ">= " + low) + multiple;
}

std::string default_text(const Json& type) {
  if (!type.contains("default")) return "";
  const Json& value = type.at("default");
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return number_text(value.get<double>());
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& each : value) text += (text.empty() ? "" : ", ") + default_text({{"default", each}});
  return "[" + text + "]";
}

void collect(std::vector<KeyRow>& rows, const Json& map, const std::string& path);

void collect_value(std::vector<KeyRow>& rows, const Json& type, const std::string& path) {
  if (type.contains("properties")) return collect(rows, type, path);
  if (type.contains("items")) return collect_value(rows, type.at("items"), path + "[]");
  for (const Json& form : type.value("anyOf", Json::array())) collect_value(rows, form, path);
}

void collect(std::vector<KeyRow>& rows, const Json& map, const std::string& path) {
  const Json required = map.value("required", Json::array());
  for (const auto& [key, type] : map.at("properties").items()) {
    const bool reserved = !type.contains("weir:kind") && !type.contains("properties") && !type.contains("items") &&
                          !type.contains("anyOf");
    if (reserved) continue;
    KeyRow row;
    row.key = joined(path, key);
    row.type = type.value("weir:kind", type.contains("items")   ? "list of maps"
                                       : type.contains("anyOf") ? "several forms"
                                                                : "map");
    row.unit = type.value("weir:unit", "");
    row.value = default_text(type);
    row.required = std::find(required.begin(), required.end(), key) != required.end();
    row.range = range_text(type);
    row.meaning = type.value("weir:meaning", "");
    rows.push_back(row);
    // Holes are the same shapes everywhere; the reference says so instead of repeating them.
    if (key != "holes") collect_value(rows, type, row.key);
  }
}

}  // namespace

std::string scene_schema() {
  Json schema = tree();
  finish(schema);
  Json root{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "weir scene"}};
  root.update(schema);
  return root.dump(2) + "\n";
}

std::vector<KeyRow> scene_keys() {
  std::vector<KeyRow> rows;
  collect(rows, tree(), "");
  return rows;
}

}  // namespace weir
