// Figures of reports as SVG, PDF and PNG, their data as CSV. The same data gives the same bytes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frame/image.h"

namespace weir {

struct PlotAxis {
  std::string title;   // with its unit, as drawn: "time t in s"
  std::string column;  // of the CSV: "time[s]"
  bool logarithmic = false;
};

struct Series {
  std::string label;  // in the legend and in the CSV: a value of LinePlot::series_column
  std::vector<double> x;
  std::vector<double> y;  // as long as x; the line has a gap where one of the two is not finite
};

struct LinePlot {
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::string legend;         // what the series differ in, as drawn: "stiffness k in Pa"
  std::string series_column;  // the same for the CSV: "stiffness[Pa]"
  std::vector<Series> series;
};

struct Picture {
  Image image;
  std::string caption;
};

// Pictures of one size, row by row.
struct PictureGrid {
  std::string title;
  int columns = 3;
  std::vector<Picture> pictures;
};

// Write `stem`.svg, .pdf and .png (and .csv for lines) and create the folder. Throw OutputError naming the file, and
// std::invalid_argument for data that cannot be drawn: no series, x and y of different lengths, pictures of different
// sizes.
void write_plot(const std::filesystem::path& stem, const LinePlot& plot);
void write_plot(const std::filesystem::path& stem, const PictureGrid& grid);

// One row per point: series, x, y; numbers are the shortest that read back to the same bits.
std::string csv_of(const LinePlot& plot);

}  // namespace weir
