// Every equation has one place in the code and one row in the README's index.
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

TEST(EquationTags, StandInTheReadmesIndex) {
  const std::string readme = text_of("README.md");
  for (const auto& [tag, count] : tags()) EXPECT_NE(readme.find("| " + tag + " |"), std::string::npos) << tag;
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
