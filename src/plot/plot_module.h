// Interface of the module weir_plot. Exceptions pass through.
#pragma once

#include "plot/plot.h"

extern "C" {
void weir_plot_lines(const std::filesystem::path& stem, const weir::LinePlot& plot);
void weir_plot_pictures(const std::filesystem::path& stem, const weir::PictureGrid& grid);
}
