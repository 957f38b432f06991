// Every equation has one place in the code and one row in the index of src/equations/README.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// A tag ends the comment above a function: "... [Hinsch24 eq. 4.3]".
std::map<std::string, int> tags() {
  const std::regex tag(R"(\[([A-Z][A-Za-z]+[0-9]{2}[^\]]*|mechanics, [^\]]*)\]$)");
  std::map<std::string, int> found;
  for (const auto& entry : fs::directory_iterator("src/equations")) {
    std::ifstream lines(entry.path());
    for (std::string line; std::getline(lines, line);) {
      std::smatch match;
      if (line.find("//") != std::string::npos && std::regex_search(line, match, tag)) ++found[match[1]];
    }
  }
  return found;
}

TEST(EquationTags, StandOnceInTheCode) {
  const auto found = tags();
  EXPECT_GE(found.size(), 20);
  for (const auto& [tag, count] : found) EXPECT_EQ(count, 1) << tag;
}

// A row of the index: | tag | meaning | `file` Struct::function |.
struct Row {
  std::string file;
  std::string name;  // as it stands in the file: a member without its struct
};

std::map<std::string, Row> index_rows() {
  const std::regex row(R"(^\| ([^|]+) \| [^|]+ \| `([a-z_]+\.h)` (?:\w+::)?(\w+) \|$)");
  std::map<std::string, Row> rows;
  std::ifstream lines("src/equations/README.md");
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, row)) rows[match[1]] = {match[2], match[3]};
  }
  return rows;
}

TEST(EquationIndex, HasTheTagsOfTheCodeAndNoOthers) {
  const auto in_code = tags();
  const auto in_index = index_rows();
  for (const auto& [tag, count] : in_code) EXPECT_TRUE(in_index.contains(tag)) << tag;
  for (const auto& [tag, row] : in_index) EXPECT_TRUE(in_code.contains(tag)) << tag;
}

TEST(EquationIndex, NamesFunctionsOfTheFile) {
  for (const auto& [tag, row] : index_rows()) {
    const std::string text = text_of("src/equations/" + row.file);
    EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + row.name + "\\b")))
        << tag << ": " << row.file << ", " << row.name;
    EXPECT_NE(text.find('[' + tag + ']'), std::string::npos) << tag << " is not in " << row.file;
  }
}

TEST(Equations, IncludeNothingButCore) {
  const std::regex include("#include \"([^\"]*)\"");
  for (const auto& entry : fs::directory_iterator("src/equations")) {
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
      const std::string header = (*it)[1];
      EXPECT_TRUE(header.starts_with("core/") || header.starts_with("equations/")) << entry.path() << ": " << header;
    }
  }
}

}  // namespace
