#include "plot/plot.h"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

#include "core/error.h"
#include "core/module.h"
#include "core/write_text.h"
#include "plot/plot_module.h"

namespace weir {

namespace {

void make_folder(const std::filesystem::path& stem) {
  const std::filesystem::path folder = stem.parent_path();
  std::error_code trouble;
  if (!folder.empty()) std::filesystem::create_directories(folder, trouble);
  if (trouble) throw OutputError(fmt::format("cannot make {}: {}", folder.string(), trouble.message()));
}

void check(const LinePlot& plot) {
  if (plot.series.empty()) throw std::invalid_argument(fmt::format("plot '{}': no series", plot.title));
  for (const Series& series : plot.series)
    if (series.x.size() != series.y.size())
      throw std::invalid_argument(fmt::format("plot '{}', series '{}': {} x and {} y", plot.title, series.label,
                                              series.x.size(), series.y.size()));
}

void check(const PictureGrid& grid) {
  if (grid.pictures.empty()) throw std::invalid_argument(fmt::format("grid '{}': no pictures", grid.title));
  if (grid.columns < 1) throw std::invalid_argument(fmt::format("grid '{}': {} columns", grid.title, grid.columns));
  const Image& first = grid.pictures.front().image;
  for (const Picture& picture : grid.pictures)
    if (picture.image.width != first.width || picture.image.height != first.height)
      throw std::invalid_argument(fmt::format("grid '{}': pictures of {}x{} and {}x{}", grid.title, first.width,
                                              first.height, picture.image.width, picture.image.height));
}

}  // namespace

void write_plot(const std::filesystem::path& stem, const LinePlot& plot) {
  check(plot);
  make_folder(stem);
  write_text(stem.string() + ".csv", csv_of(plot));
  module_function<decltype(weir_plot_lines)>("weir_plot", "weir_plot_lines")(stem, plot);
}

void write_plot(const std::filesystem::path& stem, const PictureGrid& grid) {
  check(grid);
  make_folder(stem);
  module_function<decltype(weir_plot_pictures)>("weir_plot", "weir_plot_pictures")(stem, grid);
}

}  // namespace weir
