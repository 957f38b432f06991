// Pictures compared with committed ones.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "frame/image.h"

namespace weir::test {

// How two pictures of one size differ.
struct Difference {
  long long pixels = 0;  // in which any channel differs
  int largest = 0;       // of any channel, of 255
};
Difference difference(const Image& a, const Image& b);

Image read_png(const std::filesystem::path& file);
void write_png(const std::filesystem::path& file, const Image& image);

// Compares with tests/golden/<name>.png. Where the golden's folder says in renderer.txt that it was made by this
// renderer on a processor with these instructions, every pixel must be the same; elsewhere at most 0.1 % of the pixels
// may differ, by at most 2/255. A failure leaves <name>.actual.png, .expected.png and .difference.png in
// out/golden-failures. With WEIR_BLESS=1 in the environment the picture becomes the golden instead.
testing::AssertionResult matches_golden(const Image& actual, const std::string& name, const std::string& gl_renderer);

}  // namespace weir::test
