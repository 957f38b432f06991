// YAML text as a plain tree with positions. Only document.cpp knows the YAML library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace weir {

// A position in the file, or in the option of that index.
struct Position {
  int line = 1;
  int column = 1;   // in characters
  int option = -1;  // index of the override; -1: the file
};

struct Node {
  enum class Kind { nothing, scalar, list, map };
  Kind kind = Kind::nothing;
  std::string key;             // in a map
  Position at;                 // of the key in a map, else of the value
  std::string text;            // of a scalar
  bool quoted = false;         // a scalar in quotes or in block form is text, whatever it looks like
  std::vector<Node> children;  // of a list or map, repeated keys included
};

struct Mistake {
  Position at;
  std::string path;
  std::string message;
};

// One document. Mistakes that do not stop the parser (tags, aliases) are added to `mistakes`; a syntax error is thrown as
// SyntaxError.
struct SyntaxError {
  Position at;
  std::string message;
};
Node parse_document(std::string_view text, int option, std::vector<Mistake>& mistakes);

const Node* child(const Node& node, std::string_view key);  // the first of that name
std::string joined(const std::string& path, std::string_view key);

// The node with that path ("walls.0.tank"), or the nearest one above it that exists.
const Node& nearest(const Node& root, std::string_view path);

// Keys whose names hold dots: all that follows "set" is one key.
std::vector<std::string> split_path(std::string_view path);

// Sets the value at `path`, creating maps on the way; a null value removes the key.
void merge_override(Node& root, const std::string& path, Node value, std::vector<Mistake>& mistakes);

// YAML text of a tree: block style, with short leaves in flow style.
std::string document_text(const Node& root);

}  // namespace weir
