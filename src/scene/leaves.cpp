#include "scene/leaves.h"

#include <algorithm>
#include <cmath>

#include "scene/number.h"

namespace weir {

namespace {

std::string with_unit(double value, const Spec& spec) {
  const bool unitless = spec.unit.empty() || spec.unit == "1";
  return unitless ? number_text(value) : fmt::format("{} {}", number_text(value), spec.unit);
}

bool looks_like_other_type(const std::string& text) {
  return text == "true" || text == "false" || parse_number(text).value.has_value();
}

}  // namespace

std::string range_mistake(double value, const Spec& spec) {
  const Range& range = spec.range;
  if (!std::isfinite(value)) return "must be finite";
  const bool low = range.above ? value <= range.min : value < range.min;
  if (!low && value <= range.max) return "";
  const std::string at_least = fmt::format("{} {}", range.above ? "above" : "at least", with_unit(range.min, spec));
  if (std::isinf(range.max)) return fmt::format("must be {}, got {}", at_least, number_text(value));
  return fmt::format("must be {} and at most {}, got {}", at_least, with_unit(range.max, spec), number_text(value));
}

std::string file_name_mistake(const std::string& name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  };
  if (name.empty()) return "must not be empty";
  if (name.front() == '.' || name.front() == '-') {
    return fmt::format("must begin with a letter, a digit or _, got '{}'", name);
  }
  if (!std::all_of(name.begin(), name.end(), allowed)) {
    return fmt::format("must hold only letters (a-z, A-Z), digits, _ - and ., got '{}'", name);
  }
  if (name.size() > longest_file_name) {
    return fmt::format("must have at most {} characters, got {}", longest_file_name, name.size());
  }
  return "";
}

std::string content(const Node& node) {
  switch (node.kind) {
    case Node::Kind::nothing:
      return "nothing";
    case Node::Kind::list:
      return "a list";
    case Node::Kind::map:
      return "a map";
    case Node::Kind::scalar:
      break;
  }
  const std::string shown = node.text.size() > 60 ? node.text.substr(0, 60) + "..." : node.text;
  return fmt::format("{}'{}'", node.quoted ? "the text " : "", shown);
}

void LeafReader::complain(const Node& node, const std::string& message) {
  if (node.kind == Node::Kind::nothing && node.quoted) return;  // an alias, complained about already
  mistakes_.push_back({node.at, path_, fmt::format("{}{}{}", path_, path_.empty() ? "" : " ", message)});
}

bool LeafReader::is_scalar(const Node& node, const std::string& expected) {
  if (node.kind == Node::Kind::scalar) return true;
  complain(node, fmt::format("expects {}, got {}", expected, content(node)));
  return false;
}

bool LeafReader::is_list(const Node& node, const std::string& expected) {
  if (node.kind == Node::Kind::list) return true;
  complain(node, fmt::format("expects {}, got {}", expected, content(node)));
  return false;
}

bool LeafReader::number(const Node& node, double& value, const Spec& spec, const std::string& expected) {
  if (!is_scalar(node, expected)) return false;
  const ParsedNumber parsed = node.quoted ? ParsedNumber{} : parse_number(node.text);
  if (!parsed.value) {
    complain(node, fmt::format("expects {}, got {}{}", expected, content(node),
                               parsed.why.empty() ? "" : fmt::format("; {}", parsed.why)));
    return false;
  }
  const std::string wrong = range_mistake(*parsed.value, spec);
  if (!wrong.empty()) {
    complain(node, wrong);
    return false;
  }
  value = *parsed.value;
  return true;
}

void LeafReader::read(const Node& node, double& value, const Spec& spec) { number(node, value, spec, "a number"); }

void LeafReader::read(const Node& node, int& value, const Spec& spec) {
  Spec within = spec;  // whatever the table says, the number must fit an int
  within.range.min = std::max(spec.range.min, -2147483648.0);
  within.range.max = std::min(spec.range.max, 2147483647.0);
  double read_value = 0;
  if (!number(node, read_value, within, "a whole number")) return;
  if (read_value != std::floor(read_value)) {
    return complain(node, fmt::format("expects a whole number, got {}", number_text(read_value)));
  }
  const int whole = static_cast<int>(read_value);
  if (whole % spec.multiple != 0)
    return complain(node, fmt::format("must be a multiple of {}, got {}", spec.multiple, whole));
  value = whole;
}

void LeafReader::read(const Node& node, bool& value, const Spec&) {
  if (!is_scalar(node, "true or false")) return;
  if (node.quoted || (node.text != "true" && node.text != "false")) {
    return complain(node, fmt::format("expects true or false, got {}", content(node)));
  }
  value = node.text == "true";
}

void LeafReader::read(const Node& node, std::string& value, const Spec&) {
  if (!is_scalar(node, "text")) return;
  if (!node.quoted && looks_like_other_type(node.text)) {
    return complain(node, fmt::format("expects text, got {}; put it in quotes", content(node)));
  }
  value = node.text;
}

void LeafReader::read(const Node& node, FileName name, const Spec& spec) {
  std::string read_value = name.value;
  read(node, read_value, spec);
  const std::string wrong = file_name_mistake(read_value);
  if (!wrong.empty() && node.kind == Node::Kind::scalar) return complain(node, wrong);
  name.value = read_value;
}

void LeafReader::read(const Node& node, Vec3& value, const Spec& spec) {
  const std::string expected = dimension_ == 2   ? "2 numbers [x, y]"
                               : dimension_ == 3 ? "3 numbers [x, y, z]"
                                                 : "a list of numbers, one per dimension";
  if (!is_list(node, expected)) return;
  const std::size_t size = node.children.size();
  if (dimension_ != 0 ? size != static_cast<std::size_t>(dimension_) : size != 2 && size != 3) {
    return complain(node, fmt::format("expects {}, got {}", expected, size));
  }
  Vec3 read_value(0);
  for (int axis = 0; axis < static_cast<int>(size); ++axis) {
    LeafReader(mistakes_, joined(path_, fmt::format("{}", axis)), dimension_)
        .read(node.children[static_cast<std::size_t>(axis)], read_value[axis], spec);
  }
  value = read_value;
}

void LeafReader::read(const Node& node, Spin spin, const Spec& spec) {
  if (dimension_ == 3 || node.kind == Node::Kind::list) {
    if (dimension_ == 2) return complain(node, "expects a number in 2D, got a list");
    return read(node, spin.value, spec);
  }
  double turn = 0;
  read(node, turn, spec);
  spin.value = Vec3(0, 0, turn);
}

void LeafReader::read(const Node& node, AutoRange range, const Spec& spec) {
  if (node.kind == Node::Kind::scalar && node.text == "auto") {
    range.value.reset();
    return;
  }
  if (!is_list(node, "auto or two numbers [low, high]")) return;
  if (node.children.size() != 2) {
    return complain(node, fmt::format("expects auto or two numbers [low, high], got {}", node.children.size()));
  }
  std::array<double, 2> ends{};
  for (std::size_t i = 0; i < 2; ++i) {
    LeafReader(mistakes_, joined(path_, fmt::format("{}", i)), dimension_).read(node.children[i], ends[i], spec);
  }
  range.value = ends;
}

void LeafReader::read(const Node& node, std::array<int, 2>& value, const Spec& spec) {
  if (!is_list(node, "two whole numbers")) return;
  if (node.children.size() != 2) {
    return complain(node, fmt::format("expects two whole numbers, got {}", node.children.size()));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    LeafReader(mistakes_, joined(path_, fmt::format("{}", i)), dimension_).read(node.children[i], value[i], spec);
  }
}

void LeafReader::read(const Node& node, std::vector<double>& value, const Spec& spec) {
  if (!is_list(node, "a list of numbers")) return;
  value.clear();
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    double item = 0;
    LeafReader(mistakes_, joined(path_, fmt::format("{}", i)), dimension_).read(node.children[i], item, spec);
    value.push_back(item);
  }
}

void LeafReader::read(const Node& node, std::vector<Vec3>& value, const Spec& spec) {
  if (!is_list(node, "a list of points")) return;
  if (node.children.size() < static_cast<std::size_t>(spec.least)) {
    return complain(node, fmt::format("needs at least {} points, got {}", spec.least, node.children.size()));
  }
  value.clear();
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    Vec3 point(0);
    LeafReader(mistakes_, joined(path_, fmt::format("{}", i)), dimension_).read(node.children[i], point, spec);
    value.push_back(point);
  }
}

}  // namespace weir
