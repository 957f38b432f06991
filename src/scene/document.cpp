#include "scene/document.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "scene/text.h"

namespace weir {

namespace {

// A scene needs ten levels; the limit keeps every recursion over a tree harmless.
constexpr std::size_t max_depth = 64;

// The YAML library counts lines and columns from 0, and columns in bytes.
class Positions {
 public:
  Positions(std::string_view text, int option) : text_(text), option_(option) {
    starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') starts_.push_back(i + 1);
    }
  }
  Position at(const YAML::Mark& mark) const {
    Position position{std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1, option_};
    if (mark.line < 0 || static_cast<std::size_t>(mark.line) >= starts_.size()) return position;
    const std::size_t start = starts_[static_cast<std::size_t>(mark.line)];
    const std::string_view before = text_.substr(start, static_cast<std::size_t>(std::max(mark.column, 0)));
    for (const char c : before) {
      if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) --position.column;  // within a character
    }
    return position;
  }

 private:
  std::string_view text_;
  int option_;
  std::vector<std::size_t> starts_;
};

class Builder : public YAML::EventHandler {
 public:
  Builder(const Positions& positions, std::vector<Mistake>& mistakes) : positions_(positions), mistakes_(mistakes) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) {
      throw SyntaxError{positions_.at(mark), "a second document begins here; a file holds one scene"};
    }
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_extras(mark, "", anchor);
    if (key_expected()) throw SyntaxError{positions_.at(mark), "a key without a name"};
    open(Node::Kind::nothing, mark);
    close();
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    if (key_expected()) throw SyntaxError{positions_.at(mark), "an alias cannot be a key"};
    open(Node::Kind::nothing, mark).quoted = true;
    refuse("aliases (*name) are not read; write the value out");
    close();
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    // The YAML library makes the escapes \N and \_ one byte each, which is not UTF-8; all other text was seen to be.
    std::string text = with_whole_characters(value);
    if (key_expected()) {
      key_ = std::move(text);
      key_at_ = positions_.at(mark);
      has_key_ = true;
      refuse_extras(mark, tag, anchor);
      return;
    }
    Node& node = open(Node::Kind::scalar, mark);
    node.text = std::move(text);
    node.quoted = tag == "!";  // how the parser marks quotes and block scalars
    refuse_extras(mark, tag, anchor);
    close();
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    start(Node::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    start(Node::Kind::map, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

  bool empty() const { return documents_ == 0; }
  Node take() { return std::move(root_); }

 private:
  bool key_expected() const { return !open_.empty() && open_.back().kind == Node::Kind::map && !has_key_; }

  void start(Node::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    if (key_expected())
      throw SyntaxError{positions_.at(mark), "a key must be a name, not a list or map; is a bracket left open?"};
    if (open_.size() >= max_depth) {
      throw SyntaxError{positions_.at(mark), fmt::format("nested deeper than {} levels", max_depth)};
    }
    open(kind, mark);
    refuse_extras(mark, tag, anchor);
  }
  Node& open(Node::Kind kind, const YAML::Mark& mark) {
    Node node;
    node.kind = kind;
    node.at = positions_.at(mark);
    if (has_key_) {
      node.key = std::exchange(key_, {});
      node.at = key_at_;
      has_key_ = false;
    }
    open_.push_back(std::move(node));
    return open_.back();
  }
  void close() {
    Node node = std::move(open_.back());
    open_.pop_back();
    if (open_.empty()) {
      root_ = std::move(node);
    } else {
      open_.back().children.push_back(std::move(node));
    }
  }
  void refuse_extras(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    if (tag != "" && tag != "?" && tag != "!")
      refuse_at(mark, fmt::format("tags ({}) are not read; leave it out", tag));
    if (anchor != YAML::NullAnchor) refuse_at(mark, "anchors (&name) are not read; leave it out");
  }
  void refuse_at(const YAML::Mark& mark, std::string message) {
    mistakes_.push_back({positions_.at(mark), path(), std::move(message)});
  }
  void refuse(std::string message) { mistakes_.push_back({open_.back().at, path(), std::move(message)}); }
  std::string path() const {
    std::string result;
    for (std::size_t i = 1; i < open_.size(); ++i) {
      const bool in_list = open_[i - 1].kind == Node::Kind::list;
      result = joined(result, in_list ? fmt::format("{}", open_[i - 1].children.size()) : open_[i].key);
    }
    return has_key_ ? joined(result, key_) : result;
  }

  const Positions& positions_;
  std::vector<Mistake>& mistakes_;
  std::vector<Node> open_;
  Node root_;
  std::string key_;
  Position key_at_;
  bool has_key_ = false;
  int documents_ = 0;
};

// The number that a segment of a path means, or -1.
std::ptrdiff_t list_index(std::string_view segment) {
  std::ptrdiff_t index = -1;
  const auto [rest, error] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  return error == std::errc() && rest == segment.data() + segment.size() && index >= 0 ? index : -1;
}

Node* step_into(Node& node, const std::string& segment, int option) {
  if (node.kind == Node::Kind::scalar || node.kind == Node::Kind::nothing) {
    node.kind = list_index(segment) >= 0 ? Node::Kind::list : Node::Kind::map;
    node.text.clear();
    node.at.option = option;
  }
  if (node.kind == Node::Kind::list) {
    const std::ptrdiff_t index = list_index(segment);
    const auto size = static_cast<std::ptrdiff_t>(node.children.size());
    if (index < 0 || index > size) return nullptr;
    if (index < size) return &node.children[static_cast<std::size_t>(index)];
  } else {
    for (Node& existing : node.children) {
      if (existing.key == segment) return &existing;
    }
  }
  Node made;
  if (node.kind == Node::Kind::map) made.key = segment;
  made.at.option = option;
  node.children.push_back(std::move(made));
  return &node.children.back();
}

void take_out(Node& root, const std::vector<std::string>& segments) {
  Node* node = &root;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::ptrdiff_t index = list_index(segments[i]);
    auto& children = node->children;
    auto found = children.end();
    if (node->kind == Node::Kind::list && index >= 0 && index < static_cast<std::ptrdiff_t>(children.size())) {
      found = children.begin() + index;
    } else if (node->kind == Node::Kind::map) {
      found = std::find_if(children.begin(), children.end(), [&](const Node& c) { return c.key == segments[i]; });
    }
    if (found == children.end()) return;
    if (i + 1 == segments.size()) {
      children.erase(found);
      return;
    }
    node = &*found;
  }
}

void mark_option(Node& node, int option) {
  node.at.option = option;
  for (Node& each : node.children) mark_option(each, option);
}

}  // namespace

Node parse_document(std::string_view text, int option, std::vector<Mistake>& mistakes) {
  const Positions positions(text, option);
  Builder builder(positions, mistakes);
  try {
    std::istringstream stream{std::string(text)};
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    throw SyntaxError{positions.at(error.mark), fmt::format("not YAML: {}", error.msg)};
  }
  return builder.take();
}

const Node* child(const Node& node, std::string_view key) {
  for (const Node& each : node.children) {
    if (each.key == key) return &each;
  }
  return nullptr;
}

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

std::vector<std::string> split_path(std::string_view path) {
  std::vector<std::string> segments;
  while (!path.empty()) {
    const bool rest_is_one = !segments.empty() && segments.back() == "set";
    const std::size_t dot = rest_is_one ? std::string_view::npos : path.find('.');
    segments.emplace_back(path.substr(0, dot));
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  }
  return segments;
}

const Node& nearest(const Node& root, std::string_view path) {
  const Node* node = &root;
  for (const std::string& segment : split_path(path)) {
    const Node* next = nullptr;
    if (node->kind == Node::Kind::list) {
      const std::ptrdiff_t index = list_index(segment);
      if (index >= 0 && index < static_cast<std::ptrdiff_t>(node->children.size())) {
        next = &node->children[static_cast<std::size_t>(index)];
      }
    } else {
      next = child(*node, segment);
    }
    if (next == nullptr) break;
    node = next;
  }
  return *node;
}

void merge_override(Node& root, const std::string& path, Node value, std::vector<Mistake>& mistakes) {
  const int option = value.at.option;
  const std::vector<std::string> segments = split_path(path);
  if (value.kind == Node::Kind::nothing && !value.quoted) {
    take_out(root, segments);
    return;
  }
  Node* node = &root;
  std::string so_far;
  for (const std::string& segment : segments) {
    const std::size_t elements = node->children.size();
    Node* next = step_into(*node, segment, option);
    if (next == nullptr) {
      mistakes.push_back({value.at, path,
                          fmt::format("{} is a list of {}: its elements are numbered from 0, and {} would add one; "
                                      "'{}' names none",
                                      so_far, elements, elements, segment)});
      return;
    }
    so_far = joined(so_far, segment);
    node = next;
  }
  value.key = node->key;
  *node = std::move(value);
  mark_option(*node, option);
}

}  // namespace weir
