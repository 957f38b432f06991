// The scene reference in scenes/README.md is what the field table says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "scene/advice.h"
#include "scene/keys.h"
#include "scene/reader.h"

namespace weir {
namespace {

constexpr const char* page = "scenes/README.md";
constexpr std::string_view begin_mark = "<!-- scene reference: begin -->\n";
constexpr std::string_view end_mark = "<!-- scene reference: end -->";

std::string text_of(const char* file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Escaped for Markdown and HTML; code between backticks stays as it is.
std::string cell(const std::string& text) {
  std::string result;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (c == '|') {
      result += "\\|";
    } else if (c == '<' && !code) {
      result += "&lt;";
    } else if (c == '*' && !code) {
      result += "\\*";
    } else {
      result += c;
    }
  }
  return result;
}

std::string in_code(const std::string& text) { return text.empty() ? "" : fmt::format("`{}`", text); }

bool is_map(const KeyRow& row) { return row.type == "map" || row.type == "list of maps"; }

// "fluid" of "fluid.volumes[].box".
std::string top_of(const std::string& key) { return key.substr(0, key.find_first_of(".[")); }

// A table of the keys that are values, then one for each key that holds others.
std::string reference() {
  std::string first;
  std::string rest;
  const std::string head =
      "| key | type | unit | default | range | meaning |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  std::string table;
  for (const KeyRow& row : scene_keys()) {
    const std::string line =
        fmt::format("| {} | {} | {} | {} | {} | {} |\n", in_code(row.key), cell(row.type), cell(row.unit),
                    row.required ? "required" : in_code(row.value), cell(row.range), cell(row.meaning));
    const bool at_top = top_of(row.key) == row.key;
    if (at_top && !is_map(row)) {
      first += line;
    } else if (at_top) {
      rest += fmt::format("\n#### `{}`: {}\n\n{}", row.key, cell(row.meaning), head);
    } else {
      rest += line;
    }
  }
  return head + first + rest;
}

TEST(SceneReference, IsTheFieldTable) {
  const std::string readme = text_of(page);
  const std::size_t mark = readme.find(begin_mark);
  const std::size_t end = readme.find(end_mark);
  ASSERT_TRUE(mark != std::string::npos && end != std::string::npos && mark < end)
      << page << " needs the lines " << begin_mark << "and " << end_mark;
  const std::size_t begin = mark + begin_mark.size();
  if (const char* bless = std::getenv("WEIR_BLESS"); bless != nullptr && std::string_view(bless) == "1") {
    std::ofstream(page) << readme.substr(0, begin) << reference() << readme.substr(end);
    return;
  }
  EXPECT_EQ(readme.substr(begin, end - begin), reference()) << "WEIR_BLESS=1 rewrites it";
}

// The scene between ```yaml and ``` on the front page.
TEST(FrontPage, ShowsAValidScene) {
  const std::string text = text_of("README.md");
  const std::string_view fence = "```yaml\n";
  const std::size_t begin = text.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t scene = begin + fence.size();
  const Scene read = read_scene_text(text.substr(scene, text.find("```\n", scene) - scene), "README.md");
  EXPECT_TRUE(advice(read).empty());
}

TEST(SceneReference, EscapesMarkdownOutsideCode) {
  EXPECT_EQ(cell("dt <= a | b * c"), "dt &lt;= a \\| b \\* c");
  EXPECT_EQ(cell("in place of `view <x>`"), "in place of `view <x>`");
}

}  // namespace
}  // namespace weir
