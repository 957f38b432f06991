#include "scene/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace weir {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t digits(std::string_view text, std::size_t at) {
  std::size_t count = 0;
  while (at + count < text.size() && is_digit(text[at + count])) ++count;
  return count;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

// The probable meaning of a text that is not a number of this grammar; empty: nothing like a number.
std::string look_alike(std::string_view unsigned_text) {
  const std::string text = lower(unsigned_text);
  if (text == ".inf" || text == "inf" || text == "infinity") return "infinity is not a number here";
  if (text == ".nan" || text == "nan") return "nan is not a number here";
  if (text.starts_with("0x") || text.starts_with("0o") || text.starts_with("0b")) return "write the number in decimal";
  if (!text.empty() && is_digit(text[0]) && text.find('_') != std::string::npos) return "leave out the underscores";
  if (!text.empty() && is_digit(text[0]) && text.find(',') != std::string::npos) return "the decimal sign is a point";
  return "";
}

}  // namespace

ParsedNumber parse_number(std::string_view text) {
  const bool sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  const std::string_view body = text.substr(sign ? 1 : 0);
  const std::size_t whole = digits(body, 0);
  std::size_t end = whole;
  std::size_t fraction = 0;
  if (end < body.size() && body[end] == '.') {
    fraction = digits(body, end + 1);
    end += 1 + fraction;
  }
  bool fits = whole + fraction > 0;
  if (fits && end < body.size() && (body[end] == 'e' || body[end] == 'E')) {
    ++end;
    if (end < body.size() && (body[end] == '+' || body[end] == '-')) ++end;
    const std::size_t exponent = digits(body, end);
    fits = exponent > 0;
    end += exponent;
  }
  if (!fits || end != body.size()) return {std::nullopt, look_alike(body)};
  if (whole > 1 && body[0] == '0') return {std::nullopt, "a leading zero could mean octal; leave it out"};

  double value = 0;
  const auto [rest, error] = std::from_chars(body.data(), body.data() + body.size(), value);
  if (error != std::errc() || rest != body.data() + body.size()) {
    return {std::nullopt, "that does not fit a double-precision number"};
  }
  return {text[0] == '-' ? -value : value, ""};
}

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

}  // namespace weir
