// Tree -> YAML text.
#include <fmt/format.h>

#include <algorithm>

#include "scene/document.h"

namespace weir {

namespace {

// In double quotes, where every character can be written.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string flow(const Node& node) {
  const bool map = node.kind == Node::Kind::map;
  if (!map && node.kind != Node::Kind::list) return node.quoted ? quoted(node.text) : node.text;
  std::string text;
  for (const Node& each : node.children) {
    if (!text.empty()) text += ", ";
    if (map) text += each.key + ": ";
    text += flow(each);
  }
  return map ? "{" + text + "}" : "[" + text + "]";
}

bool holds_map(const Node& node) {
  return node.kind == Node::Kind::map || std::any_of(node.children.begin(), node.children.end(), holds_map);
}

// A list of maps, or a map that holds one, is written line by line; all else fits one line.
bool is_block(const Node& node) {
  return std::any_of(node.children.begin(), node.children.end(), holds_map) ||
         (node.kind == Node::Kind::map && flow(node).size() > 90);
}

void write(std::string& text, const Node& node, std::size_t indent, bool first_is_indented) {
  const std::string margin(indent, ' ');
  for (const Node& each : node.children) {
    if (!first_is_indented) text += margin;
    first_is_indented = false;
    if (node.kind == Node::Kind::list) {
      text += "- ";
      if (is_block(each)) {
        write(text, each, indent + 2, true);
      } else {
        text += flow(each) + "\n";
      }
    } else if (is_block(each)) {
      text += each.key + ":\n";
      write(text, each, indent + 2, false);
    } else {
      text += fmt::format("{}: {}\n", each.key, flow(each));
    }
  }
}

}  // namespace

std::string document_text(const Node& root) {
  std::string text;
  write(text, root, 0, false);
  return text;
}

}  // namespace weir
