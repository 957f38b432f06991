// A reader of particle files as weir writes them: points and fields of appended raw bytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace weir::test {

class ParticleFile {
 public:
  explicit ParticleFile(std::string content) : content_(std::move(content)) {
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t at = content_.find(mark);
    if (at == std::string::npos) throw std::runtime_error("no appended data");
    head_ = content_.substr(0, at);
    data_ = std::string_view(content_).substr(at + mark.size());
  }

  // Of the tag that opens a piece, field or file: `attribute("Piece", "NumberOfPoints")`.
  std::string attribute(const std::string& tag, const std::string& name) const {
    std::smatch found;
    if (!std::regex_search(head_, found, std::regex("<" + tag + "[^>]* " + name + "=\"([^\"]*)\""))) return "";
    return found[1];
  }
  std::string attribute_of_array(const std::string& array, const std::string& name) const {
    std::smatch found;
    if (!std::regex_search(head_, found, std::regex("<DataArray[^>]*Name=\"" + array + "\"[^>]*>"))) return "";
    const std::string tag = found[0];
    return std::regex_search(tag, found, std::regex(" " + name + "=\"([^\"]*)\"")) ? found[1].str() : "";
  }

  template <class T>
  std::vector<T> values(const std::string& array) const {
    const std::size_t offset = std::stoul(attribute_of_array(array, "offset"));
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, data_.substr(offset).data(), sizeof(bytes));
    const std::string_view block = data_.substr(offset + sizeof(bytes), bytes);
    if (block.size() != bytes || bytes % sizeof(T) != 0) throw std::runtime_error("the array " + array + " is cut off");
    std::vector<T> result(bytes / sizeof(T));
    if (bytes > 0) std::memcpy(result.data(), block.data(), bytes);
    return result;
  }
  const std::string& head() const { return head_; }
  bool is_closed() const { return content_.ends_with("\n</AppendedData>\n</VTKFile>\n"); }

 private:
  std::string content_;
  std::string head_;
  std::string_view data_;
};

// Attributes of this name in a collection, in its order: "timestep", "file".
inline std::vector<std::string> listed_in_collection(const std::string& content, const std::string& name) {
  std::vector<std::string> values;
  const std::regex entry("<DataSet[^>]* " + name + "=\"([^\"]*)\"");
  for (std::sregex_iterator it(content.begin(), content.end(), entry), end; it != end; ++it) {
    values.push_back((*it)[1]);
  }
  return values;
}

}  // namespace weir::test
