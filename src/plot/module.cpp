#include "plot/draw.h"
#include "plot/plot_module.h"

extern "C" void weir_plot_lines(const std::filesystem::path& stem, const weir::LinePlot& plot) {
  weir::plot::draw_lines(stem, plot);
}

extern "C" void weir_plot_pictures(const std::filesystem::path& stem, const weir::PictureGrid& grid) {
  weir::plot::draw_pictures(stem, grid);
}
