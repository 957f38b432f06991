// Scenes, pictures, folders and limits that the output tests share.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "frame/image.h"
#include "output/sink.h"
#include "support/movie_image.h"

namespace weir::testing {

inline Provenance provenance() { return {.scene_sha256 = std::string(64, 'a'), .version = "1.2.3"}; }

inline Scene movie_scene(int width, int height, int fps) {
  Scene scene;
  scene.name = "wave";
  scene.title = "A wave";
  scene.render.size = {width, height};
  scene.render.fps = fps;
  return scene;
}

inline Image flat(int width, int height, std::array<int, 4> rgba) {
  Image image{.width = width, .height = height, .rgba = {}};
  for (int i = 0; i < width * height; ++i) {
    for (const int value : rgba) image.rgba.push_back(static_cast<std::uint8_t>(value));
  }
  return image;
}

// Picture number k of a series, recognised after any encoder by its grey level.
inline int grey_of(std::int64_t k) { return static_cast<int>(20 + 40 * (k % 6)); }
inline MovieImage numbered(int width, int height, std::int64_t k) {
  return movie_image(flat(width, height, {grey_of(k), grey_of(k), grey_of(k), 255}));
}

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A folder of its own for each test, gone afterwards.
class FolderTest : public ::testing::Test {
 protected:
  FolderTest() {
    std::string name = (std::filesystem::temp_directory_path() / "weir_output_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) ADD_FAILURE() << "no temporary folder";
    folder = name;
  }
  ~FolderTest() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder;
};

// While it lives, no file may grow beyond so many bytes: writing fails as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::uintmax_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

template <class Error, class Action>
std::string error_text(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace weir::testing
