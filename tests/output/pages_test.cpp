// scenes/README.md describes every column of log.csv and every field of manifest.json, in order.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "helpers.h"
#include "output/log.h"
#include "output/manifest.h"

namespace weir::testing {
namespace {

using ::testing::ElementsAreArray;

// The code spans in the first column of the table between <!-- mark: begin --> and <!-- mark: end -->.
std::vector<std::string> described(const std::string& mark) {
  std::istringstream lines(content_of("scenes/README.md"));
  std::vector<std::string> names;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "<!-- " + mark + ": begin -->") inside = true;
    if (line == "<!-- " + mark + ": end -->") inside = false;
    if (!inside || !line.starts_with("| `")) continue;
    const std::string first = line.substr(0, line.find('|', 1));
    const std::regex code("`([^`]*)`");
    for (std::sregex_iterator it(first.begin(), first.end(), code), end; it != end; ++it) names.push_back((*it)[1]);
  }
  return names;
}

TEST(LogColumns, AreDescribedInTheScenesPage) {
  std::vector<std::string> columns;
  std::istringstream header(log_header(3));
  for (std::string column; std::getline(header, column, ',');) columns.push_back(column);
  EXPECT_THAT(described("log.csv"), ElementsAreArray(columns));
}

void append_fields(const nlohmann::ordered_json& object, const std::string& prefix, std::vector<std::string>& fields) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_object()) {
      append_fields(value, prefix + name + '.', fields);
    } else {
      fields.push_back(prefix + name);
    }
  }
}

class ManifestFields : public FolderTest {};

TEST_F(ManifestFields, AreDescribedInTheScenesPage) {
  write_manifest(folder / "manifest.json", Manifest());
  std::vector<std::string> fields;
  append_fields(nlohmann::ordered_json::parse(content_of(folder / "manifest.json")), "", fields);
  EXPECT_THAT(described("manifest.json"), ElementsAreArray(fields));
}

}  // namespace
}  // namespace weir::testing
