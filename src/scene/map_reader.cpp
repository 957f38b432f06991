#include "scene/map_reader.h"

namespace weir {

MapReader::MapReader(std::vector<Mistake>& mistakes, const Node& node, std::string path, int dimension)
    : mistakes_(mistakes),
      map_(node.kind == Node::Kind::map ? &node : nullptr),
      path_(std::move(path)),
      dimension_(dimension),
      at_(node.at) {
  if (map_ != nullptr) return;
  quiet_ = true;
  const std::string expected = path_.empty() ? "a scene is a map of keys, got " : "expects a map, got ";
  LeafReader(mistakes_, path_, dimension_).complain(node, expected + content(node));
}

void MapReader::missing(std::string_view key) {
  if (quiet_) return;
  const std::string path = joined(path_, key);
  add(at_, path, fmt::format("missing key '{}'", path));
}

void MapReader::version(std::string_view key, int number) {
  const Node* node = find(key);
  if (node == nullptr) {
    if (!quiet_)
      add({}, std::string(key), fmt::format("missing key '{}'; a scene begins with '{}: {}'", key, key, number));
    return;
  }
  int read = number;
  leaf(key).read(*node, read, Spec{});
  if (read == number) return;
  other_version_ = Mistake{node->at, std::string(key),
                           fmt::format("{} is {}: this program reads format version {}", key, read, number)};
}

void MapReader::not_built(std::string_view key, EmptyForm empty, std::string_view meaning) {
  const Node* node = find(key);
  if (node == nullptr) return;
  const bool no_list = empty == EmptyForm::list && node->kind == Node::Kind::list && node->children.empty();
  const bool off =
      empty == EmptyForm::off && node->kind == Node::Kind::scalar && !node->quoted && node->text == "false";
  if (no_list || off) return;
  const std::string path = joined(path_, key);
  add(node->at, path, fmt::format("{} is not built yet ({}); leave it out", path, meaning));
}

void MapReader::finish() {
  if (map_ == nullptr) return;
  for (const Node& each : map_->children) {
    if (std::find(known_.begin(), known_.end(), each.key) != known_.end()) continue;
    const std::string path = joined(path_, each.key);
    if (each.key == "<<") {
      add(each.at, path, fmt::format("merge keys ({}) are not read; write the keys out", path));
    } else if (std::find(foreign_.begin(), foreign_.end(), each.key) != foreign_.end()) {
      add(each.at, path, fmt::format("{} does not go with the other keys of {}", path, path_));
    } else {
      const std::string_view close = nearest_name(each.key, known_);
      add(each.at, path,
          fmt::format("unknown key '{}'{}", path, close.empty() ? "" : fmt::format("; did you mean '{}'?", close)));
    }
  }
}

}  // namespace weir
