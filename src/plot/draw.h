// Drawing of the two kinds of figures.
#pragma once

#include "plot/plot.h"

namespace weir::plot {

void draw_lines(const std::filesystem::path& stem, const LinePlot& plot);
void draw_pictures(const std::filesystem::path& stem, const PictureGrid& grid);

}  // namespace weir::plot
