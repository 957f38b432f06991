#include "render/unroll.h"

#include <cstddef>
#include <iterator>
#include <regex>
#include <stdexcept>

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

int value_of(const std::string& limit, const std::map<std::string, int>& constants) {
  const auto known = constants.find(limit);
  if (known != constants.end()) return known->second;
  if (limit.find_first_not_of("0123456789") != std::string::npos) {
    throw std::invalid_argument("the limit of a loop is no constant: " + limit);
  }
  return std::stoi(limit);
}

}  // namespace

std::string unrolled(std::string source, const std::map<std::string, int>& constants) {
  static const std::regex loop(R"(for \(int (\w+) = 0; \1 < (\w+); \+\+\1\)\s*)");
  while (true) {
    // The last one first: it holds no other.
    std::smatch found;
    for (std::sregex_iterator each(source.begin(), source.end(), loop), end; each != end; ++each) found = *each;
    if (found.empty()) return source;
    const auto begin = static_cast<std::size_t>(found.position());
    const std::size_t body_begin = begin + static_cast<std::size_t>(found.length());
    const std::size_t body_end = end_of_body(source, body_begin);
    const std::string body = source.substr(body_begin, body_end - body_begin);
    const std::regex name("\\b" + found.str(1) + "\\b");
    const int count = value_of(found.str(2), constants);
    std::string written;
    for (int k = 0; k < count; ++k) written += "{" + std::regex_replace(body, name, std::to_string(k)) + "}\n";
    source.replace(begin, body_end - begin, written);
  }
}

}  // namespace weir
