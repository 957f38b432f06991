// `weir compare`: facts and verdict for images, movies and run folders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"
#include "cli/scene_text.h"
#include "output/decode.h"
#include "output/sink.h"
#include "pipeline/temporary_folder.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::AllOf;
using testing::HasSubstr;

class Compare : public testing::Test {
 protected:
  // 10 x 10 grey, with the first `count` pixels brighter by `step` in red.
  fs::path picture(const std::string& name, int count, int step) const {
    Image image{.width = 10, .height = 10, .rgba = std::vector<std::uint8_t>(400, 100)};
    for (int i = 0; i < 100; ++i) image.rgba[4 * static_cast<std::size_t>(i) + 3] = 255;
    for (int i = 0; i < count; ++i) image.rgba[4 * static_cast<std::size_t>(i)] += static_cast<std::uint8_t>(step);
    write_png(temporary_ / name, image, false, {}, 0);
    return temporary_ / name;
  }
  Outcome compare(const fs::path& a, const fs::path& b, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"compare", a.string(), b.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return weir_program(arguments);
  }
  fs::path run(const std::string& name, const std::vector<std::string>& more) {
    put_file(temporary_ / "small.yaml", small_scene_text);
    std::vector<std::string> arguments{"run", (temporary_ / "small.yaml").string(), "-o", (temporary_ / name).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = weir_program(arguments);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return temporary_ / name;
  }

  TemporaryFolder temporary_;
};

TEST_F(Compare, FindsEqualPicturesTheSame) {
  const Outcome outcome = compare(picture("a.png", 0, 0), picture("b.png", 0, 0));
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("the same pixels"), HasSubstr("\nthe same\n")));
}

TEST_F(Compare, CountsDifferingPixels) {
  const Outcome outcome = compare(picture("a.png", 0, 0), picture("b.png", 5, 20));
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out, HasSubstr(" 5 % of the pixels over 0/255"));
  EXPECT_THAT(outcome.out, HasSubstr("largest difference 20/255"));
  EXPECT_THAT(outcome.out, HasSubstr("mean 0.333/255"));  // 5 * 20 / 300: opaque pictures have three channels
  EXPECT_THAT(outcome.out, HasSubstr("PSNR 39.9 dB"));    // 10 log10(255^2 / (5 * 20^2 / 300))
  EXPECT_THAT(outcome.out, HasSubstr("\ndifferent\n"));
}

TEST_F(Compare, HasAToleranceAndAFraction) {
  const fs::path a = picture("a.png", 0, 0);
  const fs::path b = picture("b.png", 5, 20);
  EXPECT_EQ(compare(a, b, {"--tolerance", "19"}).exit, 1);
  EXPECT_EQ(compare(a, b, {"--tolerance", "20"}).exit, 0);
  EXPECT_EQ(compare(a, b, {"--fraction", "0.049"}).exit, 1);
  EXPECT_EQ(compare(a, b, {"--fraction", "0.05"}).exit, 0);
}

TEST_F(Compare, WritesTheDifference) {
  const fs::path file = temporary_ / "difference.png";
  compare(picture("a.png", 0, 0), picture("b.png", 5, 20), {"--difference", file.string()});
  const Image image = read_png(file);
  EXPECT_EQ(image.pixel(0, 0)[0], 255);  // stretched
  EXPECT_EQ(image.pixel(0, 0)[1], 0);
  EXPECT_EQ(image.pixel(5, 0)[0], 0);
}

TEST_F(Compare, ComparesRunFolders) {
  const fs::path a = run("a", {"--set", "output.frames=true"});
  const fs::path b = run("b", {"--set", "output.frames=true", "--threads", "3"});
  const Outcome same = compare(a, b);
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
  EXPECT_THAT(same.out, HasSubstr("state_hash: the same"));
  EXPECT_THAT(same.out, AllOf(HasSubstr("movie: 6 frames"), HasSubstr("frame_00005.png: the same pixels")));

  const fs::path c = run("c", {"--set", "output.frames=true", "--set", "fluid.rest_density=900"});
  const Outcome other = compare(a, c);
  EXPECT_EQ(other.exit, 1);
  EXPECT_THAT(other.out, HasSubstr("against"));

  fs::remove(b / "frames" / "frame_00003.png");
  const Outcome missing = compare(a, b);
  EXPECT_EQ(missing.exit, 1);
  EXPECT_THAT(missing.out, HasSubstr("frame_00003.png: only in " + a.string()));
}

TEST_F(Compare, ComparesMovies) {
  const fs::path a = run("a", {}) / "small.mp4";
  const fs::path longer = run("b", {"--set", "duration=0.2"}) / "small.mp4";
  EXPECT_EQ(compare(a, a).exit, 0);
  const Outcome other = compare(a, longer);
  EXPECT_EQ(other.exit, 1);
  EXPECT_THAT(other.out, HasSubstr("6 against 11 frames"));
}

TEST_F(Compare, ComparesRunsWithoutPicturesByTheirParticles) {
  const fs::path a = run("a", {"--set", "output.movie=false"});
  const fs::path b = run("b", {"--set", "output.movie=false", "--set", "gravity=[0, -9]"});
  EXPECT_EQ(compare(a, a).exit, 0);
  const Outcome other = compare(a, b);
  EXPECT_EQ(other.exit, 1);
  EXPECT_THAT(other.out, HasSubstr("DIFFERENT state_hash"));
}

TEST_F(Compare, FindsSizesDifferent) {
  write_png(temporary_ / "wide.png", {.width = 2, .height = 1, .rgba = std::vector<std::uint8_t>(8, 255)}, false, {},
            0);
  const Outcome outcome = compare(picture("a.png", 0, 0), temporary_ / "wide.png");
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out, HasSubstr("10 x 10 against 2 x 1"));
}

TEST_F(Compare, RefusesFilesThatItCannotCompare) {
  const fs::path a = picture("a.png", 0, 0);
  put_file(temporary_ / "text.png", "no picture");
  EXPECT_EQ(compare(a, temporary_ / "nowhere.png").exit, 2);
  EXPECT_EQ(compare(a, temporary_ / "text.png").exit, 2);
  EXPECT_EQ(compare(a, temporary_.path()).exit, 2);
}

}  // namespace

}  // namespace weir
