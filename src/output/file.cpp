#include "output/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace weir {

namespace {

const char* way_out(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return " (free some space, or choose another folder with -o)";
    case EFBIG:
      return " (raise the limit, see ulimit -f, or choose another folder with -o)";
    case EACCES:
    case EPERM:
    case EROFS:
      return " (choose a folder that you may write to with -o)";
    default:
      return "";
  }
}

int create(const std::filesystem::path& file) {
  return ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

// False with errno set; a signal or a short write is no failure.
bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

void throw_file_error(std::string_view doing, const std::filesystem::path& file) {
  const int error = errno;
  throw OutputError(
      fmt::format("cannot {} {}: {}{}", doing, file.string(), std::generic_category().message(error), way_out(error)));
}

std::filesystem::path temporary_of(const std::filesystem::path& file) {
  std::filesystem::path temporary = file;
  return temporary += ".tmp";
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  const std::filesystem::path temporary = temporary_of(file);
  const int descriptor = create(temporary);
  if (descriptor < 0) throw_file_error("write", file);
  const bool written = write_all(descriptor, content);
  int error = written ? 0 : errno;
  if (::close(descriptor) != 0 && written) error = errno;
  if (error == 0 && ::rename(temporary.c_str(), file.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  errno = error;
  throw_file_error("write", file);
}

std::string read_file(const std::filesystem::path& file) {
  // A stream opens a directory and only fails to read it, without saying why.
  if (std::error_code unknown; std::filesystem::is_directory(file, unknown)) {
    errno = EISDIR;
    throw_file_error("read", file);
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw_file_error("read", file);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw_file_error("read", file);
  return content;
}

GrowingFile::GrowingFile(std::filesystem::path file) : path_(std::move(file)), descriptor_(create(path_)) {
  if (descriptor_ < 0) throw_file_error("write", path_);
}

GrowingFile::~GrowingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void GrowingFile::append(std::string_view piece) {
  if (write_all(descriptor_, piece)) {
    size_ += static_cast<std::int64_t>(piece.size());
    return;
  }
  const int error = errno;
  // Should the cut fail as well, the reader finds an unfinished piece at the end; the first error is the one to report.
  if (::ftruncate(descriptor_, size_) == 0) ::lseek(descriptor_, size_, SEEK_SET);
  errno = error;
  throw_file_error("write", path_);
}

void GrowingFile::close() {
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor >= 0 && ::close(descriptor) != 0) throw_file_error("write", path_);
}

}  // namespace weir
