#include "plot/plot.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/error.h"

// Declarations only; the code is in the library libstb.
#include <stb/stb_image.h>

namespace weir {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

fs::path folder() {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(testing::TempDir()) / "weir_plot" / test->name();
}

Image decode_png(const fs::path& file) {
  Image image;
  int channels = 0;
  stbi_uc* const data = stbi_load(file.c_str(), &image.width, &image.height, &channels, 4);
  EXPECT_NE(data, nullptr) << file;
  if (data == nullptr) return image;
  image.rgba.assign(data, data + 4 * static_cast<std::ptrdiff_t>(image.width) * image.height);
  stbi_image_free(data);
  return image;
}

// Names of the elements. Throws unless tags nest and attributes are quoted.
std::vector<std::string> elements(const std::string& xml) {
  std::vector<std::string> names;
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) throw std::runtime_error("unterminated tag");
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (tag.starts_with('?') || tag.starts_with('!')) continue;
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) throw std::runtime_error("unbalanced quotes: " + tag);
    const std::string name = tag.substr(tag.starts_with('/') ? 1 : 0, tag.find_first_of(" \n/", 1) - (tag[0] == '/'));
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != name) throw std::runtime_error("end tag without start tag: " + name);
      open.pop_back();
      continue;
    }
    names.push_back(name);
    if (!tag.ends_with('/')) open.push_back(name);
  }
  if (!open.empty()) throw std::runtime_error("missing end tag: " + open.back());
  return names;
}

LinePlot waves() {
  LinePlot plot;
  plot.title = "Waves < & > \"others\"";
  plot.x = {"time t in s", "time[s]"};
  plot.y = {"height in m", "height[m]"};
  plot.legend = "frequency f in Hz";
  plot.series_column = "frequency[Hz]";
  for (const double frequency : {1.0, 2.0, 3.0}) {
    Series series;
    series.label = std::to_string(static_cast<int>(frequency));
    for (int k = 0; k <= 200; ++k) {
      series.x.push_back(0.01 * k);
      series.y.push_back(std::exp(-0.01 * k) * std::sin(6.283185307 * frequency * 0.01 * k) / frequency);
    }
    plot.series.push_back(series);
  }
  return plot;
}

Image plain(int width, int height, std::array<std::uint8_t, 4> color) {
  Image image{width, height, {}};
  for (int k = 0; k < width * height; ++k) image.rgba.insert(image.rgba.end(), color.begin(), color.end());
  return image;
}

PictureGrid squares() {
  PictureGrid grid;
  grid.title = "Squares";
  grid.columns = 2;
  grid.pictures = {{plain(120, 80, {200, 10, 20, 255}), "red"},
                   {plain(120, 80, {10, 200, 20, 255}), "green"},
                   {plain(120, 80, {0, 0, 0, 0}), "nothing"}};
  return grid;
}

std::size_t count_near(const Image& image, int red, int green, int blue) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < image.rgba.size(); k += 4)
    count += std::abs(image.rgba[k] - red) <= 2 && std::abs(image.rgba[k + 1] - green) <= 2 &&
             std::abs(image.rgba[k + 2] - blue) <= 2;
  return count;
}

TEST(Plot, WritesSvgThatIsXml) {
  write_plot(folder() / "waves", waves());
  const std::string svg = read(folder() / "waves.svg");
  std::vector<std::string> names;
  ASSERT_NO_THROW(names = elements(svg));
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), "svg");
  EXPECT_THAT(names, testing::Contains("path"));
}

TEST(Plot, WritesPngWithALineInEachColour) {
  write_plot(folder() / "waves", waves());
  const Image image = decode_png(folder() / "waves.png");
  EXPECT_EQ(image.width, 1380);
  EXPECT_EQ(image.height, 900);
  // Okabe and Ito's blue, vermillion and bluish green, as published in 8 bits. A line of 3.6 pixels across 1200 columns
  // covers well over 2000 pixels fully.
  EXPECT_GT(count_near(image, 0, 114, 178), 2000u);
  EXPECT_GT(count_near(image, 213, 94, 0), 2000u);
  EXPECT_GT(count_near(image, 0, 158, 115), 2000u);
  EXPECT_EQ(count_near(image, 204, 121, 167), 0u);
}

TEST(Plot, WritesPdfWithItsFontInside) {
  write_plot(folder() / "waves", waves());
  const std::string pdf = read(folder() / "waves.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-1."));
  EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
  EXPECT_TRUE(pdf.find("DejaVuSans") != std::string::npos);
  EXPECT_TRUE(pdf.find("/FontFile") != std::string::npos);
}

TEST(Plot, SameDataGivesTheSameBytes) {
  write_plot(folder() / "one", waves());
  write_plot(folder() / "grid_one", squares());
  // Dates have a resolution of one second.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write_plot(folder() / "two", waves());
  write_plot(folder() / "grid_two", squares());
  for (const char* const ending : {".svg", ".pdf", ".png"}) {
    EXPECT_TRUE(read((folder() / "one").string() + ending) == read((folder() / "two").string() + ending)) << ending;
    EXPECT_TRUE(read((folder() / "grid_one").string() + ending) == read((folder() / "grid_two").string() + ending))
        << ending;
  }
  EXPECT_EQ(read(folder() / "one.csv"), read(folder() / "two.csv"));
}

TEST(Plot, CsvHoldsTheNumbersExactly) {
  LinePlot plot = waves();
  plot.series.resize(1);
  plot.series[0] = {"a, \"b\"", {0.1, 1.0 / 3}, {-2.5e-9, 7}};
  EXPECT_EQ(csv_of(plot),
            "frequency[Hz],time[s],height[m]\n"
            "\"a, \"\"b\"\"\",0.1,-2.5e-09\n"
            "\"a, \"\"b\"\"\",0.3333333333333333,7\n");
}

TEST(Plot, LogarithmicAxisDrawsPowersOfTenAsAStraightLine) {
  LinePlot plot;
  plot.x = {"x", "x[1]"};
  plot.y = {"y", "y[1]", true};
  plot.series = {{"only", {}, {}}};
  for (int k = 0; k <= 40; ++k) {
    plot.series[0].x.push_back(k);
    plot.series[0].y.push_back(std::pow(10.0, -0.1 * k));
  }
  write_plot(folder() / "log", plot);
  const Image image = decode_png(folder() / "log.png");
  // Centre of the line in two columns and in the middle between them.
  const auto center = [&](int x) {
    double sum = 0;
    int count = 0;
    for (int y = 150; y < image.height; ++y)
      if (const auto* p = image.pixel(x, y); p[0] <= 2 && std::abs(p[1] - 114) <= 2 && std::abs(p[2] - 178) <= 2) {
        sum += y;
        ++count;
      }
    EXPECT_GT(count, 0) << x;
    return sum / count;
  };
  EXPECT_NEAR(center(700), (center(500) + center(900)) / 2, 1.0);  // pixels
  EXPECT_GT(center(900), center(500) + 100);
}

TEST(Plot, GridKeepsThePixelsOfItsPictures) {
  write_plot(folder() / "grid", squares());
  const Image image = decode_png(folder() / "grid.png");
  // 120 x 80 each, less the frame's line, drawn over the edge.
  EXPECT_NEAR(static_cast<double>(count_near(image, 200, 10, 20)), 120 * 80, 2 * (120 + 80));
  EXPECT_NEAR(static_cast<double>(count_near(image, 10, 200, 20)), 120 * 80, 2 * (120 + 80));
  ASSERT_NO_THROW(elements(read(folder() / "grid.svg")));
  EXPECT_TRUE(read(folder() / "grid.pdf").starts_with("%PDF"));
}

TEST(Plot, RefusesWhatCannotBeDrawn) {
  LinePlot plot = waves();
  plot.series[1].y.pop_back();
  EXPECT_THROW(write_plot(folder() / "x", plot), std::invalid_argument);
  plot.series.clear();
  EXPECT_THROW(write_plot(folder() / "x", plot), std::invalid_argument);
  plot.series = {{"nan", {NAN}, {NAN}}};
  EXPECT_THROW(write_plot(folder() / "x", plot), std::invalid_argument);
  PictureGrid grid = squares();
  grid.pictures[2].image = plain(10, 10, {0, 0, 0, 255});
  EXPECT_THROW(write_plot(folder() / "x", grid), std::invalid_argument);
}

TEST(Plot, NamesTheFileThatCannotBeWritten) {
  fs::create_directories(folder());
  std::ofstream(folder() / "file") << "in the way";
  try {
    write_plot(folder() / "file" / "plot", waves());
    FAIL() << "written into a file";
  } catch (const OutputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr((folder() / "file").string()));
  }
}

}  // namespace
}  // namespace weir
