#include "render/unroll.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace weir {

namespace {

// Where the statement or block that begins at `begin` ends.
std::size_t end_of_body(const std::string& source, std::size_t begin) {
  if (source.compare(begin, 1, "{") != 0) {
    const std::size_t end = source.find(';', begin);
    if (end == std::string::npos) throw std::invalid_argument("a loop's statement does not end");
    return end + 1;
  }
  int depth = 0;
  for (std::size_t at = begin; at < source.size(); ++at) {
    if (source[at] == '{') ++depth;
    if (source[at] == '}' && --depth == 0) return at + 1;
  }
  throw std::invalid_argument("a loop's block does not end");
}

bool in_a_name(char c) {
  return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// The name or number that begins at `begin`.
std::string word_at(const std::string& source, std::size_t begin) {
  std::size_t end = begin;
  while (end < source.size() && in_a_name(source[end])) ++end;
  return source.substr(begin, end - begin);
}

std::string with_number(const std::string& body, const std::string& name, int number) {
  std::string text;
  for (std::size_t at = 0; at < body.size();) {
    std::string word = word_at(body, at);
    if (word.empty()) word = body[at];
    at += word.size();
    text += word == name ? std::to_string(number) : word;
  }
  return text;
}

int value_of(const std::string& limit, const std::map<std::string, int>& constants) {
  const auto known = constants.find(limit);
  if (known != constants.end()) return known->second;
  if (limit.find_first_not_of("0123456789") != std::string::npos) {
    throw std::invalid_argument("the limit of a loop is no constant: " + limit);
  }
  return std::stoi(limit);
}

struct Loop {
  std::size_t begin = 0;
  std::size_t body = 0;
  std::string name;
  std::string limit;
};

constexpr std::string_view opening = "for (int ";

// The loop that begins at `begin`, if its head is of the kind that can be written out.
std::optional<Loop> loop_at(const std::string& source, std::size_t begin) {
  Loop loop;
  loop.begin = begin;
  loop.name = word_at(source, begin + opening.size());
  const std::string start = std::string(opening) + loop.name + " = 0; " + loop.name + " < ";
  if (source.compare(begin, start.size(), start) != 0) return std::nullopt;
  loop.limit = word_at(source, begin + start.size());
  const std::string head = start + loop.limit + "; ++" + loop.name + ")";
  if (source.compare(begin, head.size(), head) != 0) return std::nullopt;
  loop.body = std::min(source.find_first_not_of(" \n", begin + head.size()), source.size());
  return loop;
}

}  // namespace

std::string unrolled(std::string source, const std::map<std::string, int>& constants) {
  // From the last to the first: so each is met after those that it holds.
  for (std::size_t at = source.rfind(opening); at != std::string::npos;
       at = at == 0 ? std::string::npos : source.rfind(opening, at - 1)) {
    const std::optional<Loop> loop = loop_at(source, at);
    if (!loop) continue;
    const std::size_t end = end_of_body(source, loop->body);
    const std::string body = source.substr(loop->body, end - loop->body);
    const int count = value_of(loop->limit, constants);
    std::string written;
    for (int k = 0; k < count; ++k) written += "{" + with_number(body, loop->name, k) + "}\n";
    source.replace(at, end - at, written);
  }
  return source;
}

}  // namespace weir
