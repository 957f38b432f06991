#include "support/golden.h"

#include <fmt/format.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace weir::test {

namespace {

namespace fs = std::filesystem;

// What the software renderer's code depends on beside its version: the instructions that it compiles shaders to.
std::string instructions() {
  std::string all;
  if (__builtin_cpu_supports("sse4.1")) all += " sse4.1";
  if (__builtin_cpu_supports("avx")) all += " avx";
  if (__builtin_cpu_supports("fma")) all += " fma";
  if (__builtin_cpu_supports("avx2")) all += " avx2";
  if (__builtin_cpu_supports("avx512f")) all += " avx512f";
  return all;
}

std::string machine(const std::string& gl_renderer) {
  return fmt::format("renderer: {}\ninstructions:{}\n", gl_renderer, instructions());
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Absolute differences, brightened so that 1/255 can be seen.
Image picture_of_difference(const Image& a, const Image& b) {
  Image image{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size())};
  for (std::size_t k = 0; k < a.rgba.size(); ++k)
    image.rgba[k] =
        k % 4 == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(std::min(255, 32 * std::abs(a.rgba[k] - b.rgba[k])));
  return image;
}

}  // namespace

Difference difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) throw std::invalid_argument("pictures of different sizes");
  Difference found;
  for (std::size_t k = 0; k < a.rgba.size(); k += 4) {
    int here = 0;
    for (std::size_t c = k; c < k + 4; ++c) here = std::max(here, std::abs(a.rgba[c] - b.rgba[c]));
    if (here > 0) ++found.pixels;
    found.largest = std::max(found.largest, here);
  }
  return found;
}

Image read_png(const fs::path& file) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load(file.c_str(), &image.width, &image.height, &channels, 4), stbi_image_free);
  if (!pixels) throw std::runtime_error(fmt::format("{}: {}", file.string(), stbi_failure_reason()));
  image.rgba.assign(pixels.get(), pixels.get() + std::size_t{4} * image.width * image.height);
  return image;
}

void write_png(const fs::path& file, const Image& image) {
  fs::create_directories(file.parent_path());
  if (stbi_write_png(file.c_str(), image.width, image.height, 4, image.rgba.data(), 0) == 0)
    throw std::runtime_error(fmt::format("{}: cannot write", file.string()));
}

testing::AssertionResult matches_golden(const Image& actual, const std::string& name, const std::string& gl_renderer) {
  const fs::path golden = fs::path("tests/golden") / (name + ".png");
  const fs::path made_by = golden.parent_path() / "renderer.txt";
  if (const char* bless = std::getenv("WEIR_BLESS"); bless != nullptr && std::string(bless) == "1") {
    write_png(golden, actual);
    std::ofstream(made_by) << machine(gl_renderer);
    return testing::AssertionSuccess();
  }
  if (!fs::exists(golden))
    return testing::AssertionFailure() << golden << " is not there; look at the picture, then bless it: WEIR_BLESS=1";

  const Image expected = read_png(golden);
  const fs::path failures = fs::path("out/golden-failures") / name;
  const auto fail = [&](const std::string& text) {
    write_png(failures.string() + ".actual.png", actual);
    write_png(failures.string() + ".expected.png", expected);
    return testing::AssertionFailure() << name << ": " << text << "; see " << failures.string() << ".*.png";
  };
  if (actual.width != expected.width || actual.height != expected.height)
    return fail(
        fmt::format("{} x {} pixels instead of {} x {}", actual.width, actual.height, expected.width, expected.height));
  const Difference found = difference(actual, expected);
  const bool same_machine = text_of(made_by) == machine(gl_renderer);
  const bool good = same_machine ? found.pixels == 0
                                 : found.largest <= 2 && found.pixels * 1000 <= 1LL * actual.width * actual.height;
  if (good) return testing::AssertionSuccess();
  write_png(failures.string() + ".difference.png", picture_of_difference(actual, expected));
  return fail(fmt::format("{} pixels differ, by up to {}/255 ({})", found.pixels, found.largest,
                          same_machine ? "made by the same renderer: must be equal" : "made by another renderer"));
}

}  // namespace weir::test
