// A scene's text is UTF-8 without control characters; checked before parsing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace weir {

struct TextMistake {
  int line = 0;
  int column = 0;       // in characters, from 1
  std::string message;  // empty: the text is fine
};
TextMistake find_text_mistake(std::string_view text);

// The text with each byte that begins no character made the character of that number.
std::string with_whole_characters(std::string_view text);

// The text without a byte order mark.
std::string_view without_mark(std::string_view text);

// Of `names`, the one that `word` was probably meant to be, or an empty text.
std::string_view nearest_name(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace weir
