#include "scene/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/error.h"
#include "scene/check.h"
#include "scene/document.h"
#include "scene/leaves.h"
#include "scene/map_reader.h"
#include "scene/path_set.h"
#include "scene/text.h"

namespace weir {

namespace {

namespace fs = std::filesystem;

// More than any scene; bounds the cost of a wrong file name.
constexpr std::uintmax_t max_bytes = std::uintmax_t{16} << 20U;

[[noreturn]] void refuse_file(const fs::path& file, const std::string& why) {
  throw SceneError({{file.string(), why}});
}

std::string file_text(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) refuse_file(file, "there is no such file");
  if (error) refuse_file(file, fmt::format("cannot be read: {}", error.message()));
  if (fs::is_directory(status)) refuse_file(file, "is a folder; name a scene file in it");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file(file, "cannot be opened; may this user read it?");
  std::string text;
  char buffer[65536];
  while (stream.read(buffer, sizeof buffer) || stream.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_bytes) refuse_file(file, "is longer than 16 MiB; that is no scene");
  }
  if (stream.bad()) refuse_file(file, "cannot be read to its end");
  return text;
}

void find_repeated_keys(const Node& node, const std::string& path, std::vector<Mistake>& mistakes) {
  std::vector<const Node*> by_name;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Node& each = node.children[i];
    const bool in_map = node.kind == Node::Kind::map;
    if (in_map) by_name.push_back(&each);
    find_repeated_keys(each, joined(path, in_map ? each.key : fmt::format("{}", i)), mistakes);
  }
  std::stable_sort(by_name.begin(), by_name.end(), [](const Node* a, const Node* b) { return a->key < b->key; });
  for (std::size_t i = 1, first = 0; i < by_name.size(); ++i) {
    if (by_name[i]->key != by_name[first]->key) {
      first = i;
      continue;
    }
    const std::string full = joined(path, by_name[i]->key);
    mistakes.push_back(
        {by_name[i]->at, full, fmt::format("repeated key '{}', first at line {}", full, by_name[first]->at.line)});
  }
}

// The dimension if it can be known; mistakes in it are reported where it is read.
int peek_dimension(const Node& root) {
  const Node* node = child(root, "dimension");
  if (node == nullptr || node->quoted) return 0;
  return node->text == "2" ? 2 : node->text == "3" ? 3 : 0;
}

class Reading {
 public:
  Reading(const std::string& text, const fs::path& file, const std::vector<Override>& overrides)
      : file_(file), overrides_(overrides) {
    const TextMistake wrong = find_text_mistake(text);
    if (!wrong.message.empty()) refuse_file(at_text(wrong.line, wrong.column), wrong.message);
    root_ = parse(without_mark(text), -1);
    if (root_.kind == Node::Kind::nothing && !root_.quoted) {
      refuse_file(file_, fmt::format("the file is empty; a scene begins with 'weir: {}'", format_version));
    }
    if (root_.kind == Node::Kind::map) merge();
  }

  Scene scene() {
    Scene scene;
    scene.name = file_.stem().string();
    scene.dimension = 2;
    const int dimension = peek_dimension(root_);
    if (dimension != 0) scene.dimension = dimension;
    scene.gravity = default_gravity(scene.dimension);
    find_repeated_keys(root_, "", mistakes_);
    MapReader reader(mistakes_, root_, "", dimension);
    describe(reader, scene);
    reader.finish();
    if (reader.other_version()) {
      mistakes_ = {*reader.other_version()};
      fail();
    }
    if (child(root_, "name") == nullptr) check_name_of_file(scene.name);
    if (dimension != 0) add_violations(scene);
    if (!mistakes_.empty()) fail();
    return scene;
  }

 private:
  Node parse(std::string_view text, int option) {
    try {
      return parse_document(text, option, mistakes_);
    } catch (const SyntaxError& error) {
      throw SceneError({{where(error.at), error.message}});
    }
  }

  void merge() {
    for (std::size_t i = 0; i < overrides_.size(); ++i) {
      const int option = static_cast<int>(i);
      const TextMistake wrong = find_text_mistake(overrides_[i].value);
      if (!wrong.message.empty()) throw SceneError({{where({1, 1, option}), wrong.message}});
      Node value = parse(overrides_[i].value, option);
      value.at.option = option;
      merge_override(root_, overrides_[i].key, std::move(value), mistakes_);
    }
  }

  void check_name_of_file(const std::string& name) {
    const std::string wrong = file_name_mistake(name);
    if (!wrong.empty()) mistakes_.push_back({root_.at, "name", "name, by default the file's, " + wrong});
  }

  // Rules between fields, where all fields that a rule looks at could be read.
  void add_violations(const Scene& scene) {
    PathSet broken;
    for (const Mistake& mistake : mistakes_) broken.add(mistake.path);
    const auto unread = [&](const std::string& path) { return broken.touches(path); };
    for (const Violation& violation : check(scene, unread)) {
      mistakes_.push_back({blamed(nearest(root_, violation.path)), violation.path,
                           fmt::format("{} {}", violation.path, violation.message)});
    }
  }

  // A broken rule is blamed on an option that changed a value there.
  static Position blamed(const Node& node) {
    if (node.at.option >= 0) return node.at;
    for (const Node& each : node.children) {
      if (const Position at = blamed(each); at.option >= 0) return at;
    }
    return node.at;
  }

  [[noreturn]] void fail() {
    std::stable_sort(mistakes_.begin(), mistakes_.end(), [](const Mistake& a, const Mistake& b) {
      if (a.at.option != b.at.option) return a.at.option < b.at.option;
      if (a.at.line != b.at.line) return a.at.line < b.at.line;
      return a.at.column < b.at.column;
    });
    std::vector<SceneMistake> all;
    for (const Mistake& mistake : mistakes_) all.push_back({where(mistake.at), mistake.message});
    throw SceneError(std::move(all));
  }

  std::string at_text(int line, int column) const { return fmt::format("{}:{}:{}", file_.string(), line, column); }
  std::string where(const Position& at) const {
    if (at.option < 0) return at_text(at.line, at.column);
    const Override& option = overrides_[static_cast<std::size_t>(at.option)];
    return fmt::format("--set {}={}", option.key, option.value);
  }

  fs::path file_;
  const std::vector<Override>& overrides_;
  std::vector<Mistake> mistakes_;
  Node root_;
};

}  // namespace

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  if (equals == std::string::npos || key.empty() || key.front() == '.' || key.back() == '.' ||
      key.find("..") != std::string::npos) {
    throw UsageError(fmt::format("--set {}: expects KEY=VALUE, like render.fps=30", text));
  }
  return {key, text.substr(equals + 1)};
}

Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides) {
  return read_scene_text(file_text(file), file, overrides);
}

Scene read_scene_text(const std::string& text, const std::filesystem::path& file,
                      const std::vector<Override>& overrides) {
  return Reading(text, file, overrides).scene();
}

}  // namespace weir
