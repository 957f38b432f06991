// Cairo with ownership and error checks, and the font and colours of all figures.
#pragma once

#include <cairo.h>

#include <filesystem>
#include <functional>
#include <string>

namespace weir::plot {

struct Color {
  double red = 0, green = 0, blue = 0;
};
inline constexpr Color ink{0.13, 0.13, 0.13};
inline constexpr Color faint{0.88, 0.88, 0.88};

// Colour of the k-th line: the palette of M. Okabe and K. Ito, Color Universal Design (2008), distinguishable with any
// kind of colour vision; darker colours first, without the yellow, which is too pale for a line on white.
Color series_color(std::size_t k);

enum class Anchor { start, middle, end };

// Draws in points (1/72 inch), y downwards.
class Canvas {
 public:
  explicit Canvas(cairo_t* context);

  void color(const Color& color);
  void line(double x0, double y0, double x1, double y1, double width);
  // `y` is the baseline.
  void text(double x, double y, const std::string& text, double size, Anchor anchor = Anchor::start);
  // Upward text, centred at (x, y); x is the baseline.
  void text_upwards(double x, double y, const std::string& text, double size);
  double text_width(const std::string& text, double size);
  cairo_t* context() { return context_; }

 private:
  cairo_t* context_;
};

// Draws once into each of `stem`.svg, .pdf and .png. A point is `pixels_per_point` pixels of the PNG.
void write_all(const std::filesystem::path& stem, double width, double height, double pixels_per_point,
               const std::function<void(Canvas&)>& draw);

}  // namespace weir::plot
