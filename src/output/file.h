// Files that are whole or absent: written under another name and renamed, or grown by whole pieces.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace weir {

// "cannot <doing> <file>: <errno's text>" and, where there is one, a remedy. Reads errno first.
[[noreturn]] void throw_file_error(std::string_view doing, const std::filesystem::path& file);

// A reader sees the old content or all of the new, whenever this process ends. Throws OutputError; leaves no temporary.
void write_file(const std::filesystem::path& file, std::string_view content);
std::string read_file(const std::filesystem::path& file);  // throws OutputError

// The name under which a file that takes long to write grows before it is renamed to `file`.
std::filesystem::path temporary_of(const std::filesystem::path& file);

// A file that grows by whole pieces: after a failure it is cut back to the last one, after a kill it ends with it
// unless the kernel was caught copying.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path file);  // created or emptied; throws OutputError
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void append(std::string_view piece);  // throws OutputError
  void close();                         // reports errors that a network file system delays; throws OutputError
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;  // bytes, whole pieces
};

}  // namespace weir
