#include "output/compare.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "helpers.h"
#include "output/decode.h"
#include "output/manifest.h"
#include "output/sink.h"

namespace weir::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Compare : public FolderTest {
 protected:
  std::filesystem::path png(const std::string& name, const Image& image) const {
    std::filesystem::create_directories((folder / name).parent_path());
    write_png(folder / name, image, true, provenance(), 0);
    return folder / name;
  }
  // Flat frames of these greys, encoded without visible loss.
  void movie(const std::string& subfolder, const std::vector<int>& greys, int width = 64, int fps = 10,
             const std::string& name = "wave") const {
    Scene scene = movie_scene(width, 48, fps);
    scene.name = name;
    scene.output.movie->quality = 1;
    std::filesystem::create_directories(folder / subfolder);
    const auto sink = make_movie_sink(folder / subfolder, scene, provenance());
    for (const int grey : greys) sink->write(movie_image(flat(width, 48, {grey, grey, grey, 255})));
    sink->finish();
  }
  void run_folder(const std::string& name, const std::string& hash, const std::string& log) const {
    std::filesystem::create_directories(folder / name);
    Manifest manifest;
    manifest.state_hash = hash;
    write_manifest(folder / name / "manifest.json", manifest);
    std::ofstream(folder / name / "log.csv") << log;
  }
};

std::vector<std::string> names_of(const ComparisonResult& result) {
  std::vector<std::string> names;
  for (const ComparisonItem& item : result.items) names.push_back(item.name);
  return names;
}

const ComparisonItem& item(const ComparisonResult& result, const std::string& name) {
  for (const ComparisonItem& one : result.items) {
    if (one.name == name) return one;
  }
  throw std::runtime_error("no item " + name);
}

TEST(PictureDifferences, EqualThoseComputedByHand) {
  const Image a = flat(10, 10, {100, 100, 100, 255});
  Image b = a;
  b.pixel(3, 4)[0] = 110;  // 10 up
  b.pixel(5, 6)[2] = 80;   // 20 down
  b.pixel(7, 8)[1] = 102;  // within 2
  const PictureDifference difference = difference_of(a, b, 2);
  EXPECT_EQ(difference.max, 20);
  EXPECT_DOUBLE_EQ(difference.mean, (10 + 20 + 2) / 300.0);
  EXPECT_DOUBLE_EQ(difference.psnr, 10 * std::log10(255.0 * 255.0 * 300 / (100 + 400 + 4)));
  EXPECT_DOUBLE_EQ(difference.fraction_above, 0.02);
}

TEST(PictureDifferences, OfEqualPicturesAreNone) {
  const Image a = flat(3, 3, {1, 2, 3, 4});
  const PictureDifference difference = difference_of(a, a, 0);
  EXPECT_EQ(difference.max, 0);
  EXPECT_EQ(difference.mean, 0);
  EXPECT_TRUE(std::isinf(difference.psnr));
  EXPECT_EQ(difference.fraction_above, 0);
}

TEST(PictureDifferences, CountAlphaButNotInTheMeans) {
  const PictureDifference difference = difference_of(flat(2, 2, {9, 9, 9, 255}), flat(2, 2, {9, 9, 9, 250}), 0);
  EXPECT_EQ(difference.max, 5);
  EXPECT_EQ(difference.fraction_above, 1);
  EXPECT_EQ(difference.mean, 0);
}

TEST_F(Compare, PicturesByTolerance) {
  Image other = flat(20, 10, {100, 100, 100, 255});
  const auto a = png("a.png", other);
  other.pixel(1, 1)[0] = 103;  // one pixel of 200
  const auto b = png("b.png", other);
  EXPECT_TRUE(compare(a, a, {}).same);
  EXPECT_FALSE(compare(a, b, {}).same);
  EXPECT_TRUE(compare(a, b, {.max = 3, .fraction = 0, .difference = {}}).same);
  EXPECT_FALSE(compare(a, b, {.max = 2, .fraction = 0, .difference = {}}).same);
  EXPECT_TRUE(compare(a, b, {.max = 2, .fraction = 0.005, .difference = {}}).same);
  EXPECT_FALSE(compare(a, b, {.max = 2, .fraction = 0.0049, .difference = {}}).same);
}

TEST_F(Compare, ShowsTheDifferenceBrightOnBlack) {
  Image other = flat(20, 10, {100, 100, 100, 255});
  const auto a = png("a.png", other);
  other.pixel(1, 2)[0] = 104;
  other.pixel(3, 4)[2] = 98;
  const auto b = png("b.png", other);
  const ComparisonResult result = compare(a, b, {.max = 0, .fraction = 0, .difference = folder / "difference.png"});
  EXPECT_EQ(result.difference, folder / "difference.png");
  const Image shown = read_png(result.difference);
  const auto color = [&](int x, int y) {
    return std::vector<int>{shown.pixel(x, y)[0], shown.pixel(x, y)[1], shown.pixel(x, y)[2]};
  };
  EXPECT_THAT(color(1, 2), ElementsAre(255, 0, 0));
  EXPECT_THAT(color(3, 4), ElementsAre(0, 0, 128));  // half as much
  EXPECT_THAT(color(0, 0), ElementsAre(0, 0, 0));

  std::filesystem::remove(folder / "difference.png");
  EXPECT_TRUE(compare(a, a, {.max = 0, .fraction = 0, .difference = folder / "difference.png"}).difference.empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "difference.png"));
}

TEST_F(Compare, OtherSizesAreADifferenceInWords) {
  const auto a = png("a.png", flat(20, 10, {0, 0, 0, 255}));
  const auto b = png("b.png", flat(10, 20, {0, 0, 0, 255}));
  const ComparisonResult result = compare(a, b, {.max = 255, .fraction = 1, .difference = {}});
  EXPECT_FALSE(result.same);
  EXPECT_EQ(result.text(), "DIFFERENT a.png: 20 x 10 against 10 x 20 pixels\n");
}

TEST_F(Compare, MoviesFrameByFrame) {
  movie("a", {50, 100, 150, 200});
  movie("b", {50, 100, 150, 200});
  movie("c", {50, 100, 170, 240});
  const ComparisonResult same = compare(folder / "a/wave.mp4", folder / "b/wave.mp4", {});
  EXPECT_TRUE(same.same);
  EXPECT_EQ(same.text(), "same      wave.mp4: 4 frames; frame 0 most: the same pixels\n");

  const ComparisonResult other = compare(folder / "a/wave.mp4", folder / "c/wave.mp4",
                                         {.max = 3, .fraction = 0, .difference = folder / "difference.png"});
  EXPECT_FALSE(other.same);
  ASSERT_EQ(other.items.size(), 1U);
  EXPECT_EQ(other.items[0].first_frame_apart, 2);
  ASSERT_TRUE(other.items[0].pixels);
  EXPECT_NEAR(other.items[0].pixels->max, 40, 2);  // of frame 3
  EXPECT_EQ(other.items[0].pixels->fraction_above, 1);
  EXPECT_THAT(other.text(), HasSubstr("apart from frame 2 on; frame 3 most"));
  EXPECT_TRUE(std::filesystem::exists(folder / "difference.png"));
}

TEST_F(Compare, MoviesOfOtherLengthSizeOrRateDiffer) {
  movie("a", {50, 100, 150});
  movie("longer", {50, 100, 150, 200});
  movie("wider", {50, 100, 150}, 80);
  movie("faster", {50, 100, 150}, 64, 20);
  const auto text = [&](const char* other) {
    const ComparisonResult result =
        compare(folder / "a/wave.mp4", folder / other / "wave.mp4", {.max = 255, .fraction = 1, .difference = {}});
    EXPECT_FALSE(result.same);
    return result.text();
  };
  EXPECT_THAT(text("longer"), HasSubstr("3 against 4 frames"));
  EXPECT_THAT(text("wider"), HasSubstr("64 x 48 against 80 x 48 pixels"));
  EXPECT_THAT(text("faster"), HasSubstr("10 against 20 frames a second"));
}

TEST_F(Compare, RunFoldersByEveryFile) {
  for (const char* name : {"a", "b"}) {
    run_folder(name, "h1", "time[s],step\n0,0\n0.01,3\n");
    movie(name, {50, 100}, 64, 10, name);  // a movie named after its scene
    png(std::string(name) + "/frames/frame_00000.png", flat(4, 4, {1, 2, 3, 255}));
  }
  const ComparisonResult same = compare(folder / "a", folder / "b", {});
  EXPECT_TRUE(same.same);
  EXPECT_THAT(names_of(same), ElementsAre("frames/frame_00000.png", "movie", "state_hash", "log.csv"));

  png("a/still.png", flat(4, 4, {1, 2, 3, 255}));
  png("b/frames/frame_00000.png", flat(4, 4, {1, 2, 4, 255}));
  run_folder("b", "h2", "time[s],step\n0,0\n0.01,4\n");
  const ComparisonResult other = compare(folder / "a", folder / "b", {});
  EXPECT_FALSE(other.same);
  EXPECT_EQ(item(other, "frames/frame_00000.png").pixels->max, 1);
  EXPECT_TRUE(item(other, "movie").same);
  EXPECT_EQ(item(other, "still.png").text, "only in " + (folder / "a").string());
  EXPECT_EQ(item(other, "state_hash").text, "h1 against h2");
  EXPECT_EQ(item(other, "log.csv").text,
            "2 and 2 rows, apart from row 2 on; most in step: 1, which is 0.25 of its largest value");
}

TEST_F(Compare, AToleranceOfPixelsCoversStateHashAndLog) {
  for (const char* name : {"a", "b"}) {
    run_folder(name, name, std::string("time[s]\n0\n") + name + '\n');
    png(std::string(name) + "/still.png", flat(4, 4, {1, 2, *name == 'a' ? 3 : 4, 255}));
  }
  EXPECT_FALSE(compare(folder / "a", folder / "b", {}).same);
  const ComparisonResult result = compare(folder / "a", folder / "b", {.max = 1, .fraction = 0, .difference = {}});
  EXPECT_TRUE(result.same);
  EXPECT_EQ(item(result, "state_hash").text, "a against b");
  std::filesystem::remove(folder / "a/still.png");  // nothing to see: the numbers decide
  std::filesystem::remove(folder / "b/still.png");
  EXPECT_FALSE(compare(folder / "a", folder / "b", {.max = 1, .fraction = 0, .difference = {}}).same);
}

TEST_F(Compare, LogsOfOtherColumnsOrLengthDiffer) {
  run_folder("a", "h", "time[s],step\n0,0\n");
  run_folder("b", "h", "time[s]\n0\n");
  run_folder("c", "h", "time[s],step\n0,0\n1,1\n");
  EXPECT_EQ(item(compare(folder / "a", folder / "b", {}), "log.csv").text, "the columns are not the same");
  const ComparisonResult longer = compare(folder / "a", folder / "c", {});
  EXPECT_FALSE(longer.same);
  EXPECT_EQ(item(longer, "log.csv").text, "1 and 2 rows");
}

TEST_F(Compare, IsWrittenAsJson) {
  Image other = flat(10, 10, {100, 100, 100, 255});
  const auto a = png("a.png", other);
  other.pixel(1, 1)[0] = 103;
  const auto b = png("b.png", other);
  const auto json = nlohmann::json::parse(compare(a, b, {}).json());
  EXPECT_EQ(json["same"], false);
  EXPECT_EQ(json["items"][0]["name"], "a.png");
  EXPECT_EQ(json["items"][0]["max"], 3);
  EXPECT_DOUBLE_EQ(json["items"][0]["mean"].get<double>(), 0.01);
  EXPECT_DOUBLE_EQ(json["items"][0]["fraction_above"].get<double>(), 0.01);
  EXPECT_TRUE(nlohmann::json::parse(compare(a, a, {}).json())["items"][0]["psnr_db"].is_null());
}

TEST_F(Compare, RefusesFilesThatCannotBeCompared) {
  const auto a = png("a.png", flat(4, 4, {1, 2, 3, 255}));
  std::filesystem::create_directories(folder / "empty");
  std::ofstream(folder / "a.txt") << "text";
  const auto text = [&](const std::filesystem::path& x, const std::filesystem::path& y) {
    return error_text<OutputError>([&] { compare(x, y, {}); });
  };
  EXPECT_THAT(text(a, folder / "none.png"), HasSubstr("none.png: it is not there"));
  EXPECT_THAT(text(folder / "a.txt", folder / "a.txt"), HasSubstr("neither .png, .mp4 nor a run folder"));
  EXPECT_THAT(text(a, folder / "empty"), HasSubstr("two pictures, two movies or two run folders"));
  EXPECT_THAT(text(folder / "empty", folder / "empty"), HasSubstr("neither holds a run"));
}

}  // namespace
}  // namespace weir::testing
