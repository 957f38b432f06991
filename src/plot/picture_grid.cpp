#include <algorithm>
#include <cstring>
#include <memory>

#include "plot/cairo.h"
#include "plot/draw.h"

namespace weir::plot {

namespace {

// Points.
constexpr double page_width = 510;  // the text width of an A4 page with 15 mm margins
constexpr double margin = 4;
constexpr double gap = 8;
constexpr double title_height = 22;
constexpr double caption_height = 15;
constexpr double title_size = 10;
constexpr double caption_size = 8;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

// Cairo takes native-endian words with premultiplied alpha.
Surface surface_of(const Image& image) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height), cairo_surface_destroy);
  cairo_surface_flush(surface.get());
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* const from = image.pixel(x, y);
      const std::uint32_t alpha = from[3];
      const auto premultiplied = [&](int channel) { return (from[channel] * alpha + 127) / 255; };
      const std::uint32_t word = alpha << 24 | premultiplied(0) << 16 | premultiplied(1) << 8 | premultiplied(2);
      std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * static_cast<std::ptrdiff_t>(x), &word,
                  sizeof word);
    }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

}  // namespace

void draw_pictures(const std::filesystem::path& stem, const PictureGrid& grid) {
  const Image& first = grid.pictures.front().image;
  const int count = static_cast<int>(grid.pictures.size());
  const int columns = std::min(grid.columns, count);
  const int rows = (count + columns - 1) / columns;
  const double cell_width = (page_width - 2 * margin - (columns - 1) * gap) / columns;
  const double cell_height = cell_width * first.height / first.width;
  const double top = grid.title.empty() ? margin : title_height;
  const double height = top + rows * (cell_height + caption_height) + margin;
  // One pixel of the PNG per pixel of a picture.
  const double pixels_per_point = first.width / cell_width;

  std::vector<Surface> surfaces;
  surfaces.reserve(grid.pictures.size());
  for (const Picture& picture : grid.pictures) surfaces.push_back(surface_of(picture.image));

  write_all(stem, page_width, height, pixels_per_point, [&](Canvas& canvas) {
    cairo_t* const context = canvas.context();
    canvas.color(ink);
    canvas.text(margin, 14, grid.title, title_size);
    for (int k = 0; k < count; ++k) {
      const int row = k / columns;
      const double x = margin + (k % columns) * (cell_width + gap);
      const double y = top + row * (cell_height + caption_height);
      cairo_save(context);
      cairo_translate(context, x, y);
      cairo_scale(context, cell_width / first.width, cell_width / first.width);
      cairo_set_source_surface(context, surfaces[static_cast<std::size_t>(k)].get(), 0, 0);
      cairo_paint(context);
      cairo_restore(context);
      canvas.color(faint);
      cairo_set_line_width(context, 0.5);
      cairo_rectangle(context, x, y, cell_width, cell_height);
      cairo_stroke(context);
      canvas.color(ink);
      canvas.text(x + cell_width / 2, y + cell_height + 10, grid.pictures[static_cast<std::size_t>(k)].caption,
                  caption_size, Anchor::middle);
    }
  });
}

}  // namespace weir::plot
