#include "plot/cairo.h"

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "core/error.h"
#include "font/font.h"

namespace weir::plot {

namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

// Never destroyed: cairo caches fonts, and its cache may outlive any owner here.
cairo_font_face_t* font_face() {
  static cairo_font_face_t* const face = [] {
    const auto bytes = font_dejavu_sans();
    FT_Library library = nullptr;
    FT_Face ft_face = nullptr;
    if (FT_Init_FreeType(&library) != 0 || FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                                                              static_cast<FT_Long>(bytes.size()), 0, &ft_face) != 0)
      throw std::runtime_error("FreeType cannot read the font inside the program");
    // Without hinting, which would shift letters by parts of a pixel, differently in each output.
    return cairo_ft_font_face_create_for_ft_face(ft_face, FT_LOAD_NO_HINTING);
  }();
  return face;
}

void check(cairo_status_t status, const std::filesystem::path& file) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw OutputError(fmt::format("cannot write {}: {}", file.string(), cairo_status_to_string(status)));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void save(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out << bytes;
  out.close();
  if (!out) throw OutputError(fmt::format("cannot write {}", file.string()));
}

// Renumbers surfaces and images from 1: cairo counts them over the life of the program, and equal data must give equal
// files. Replaces quoted names only, which base64 images do not contain.
std::string renumbered(const std::string& svg) {
  static constexpr std::array<std::string_view, 3> names{"\"surface", "\"image", "\"#image"};
  std::map<std::string, std::size_t> numbers;
  std::string result;
  std::size_t copied = 0;
  for (std::size_t at = svg.find('"'); at != std::string::npos; at = svg.find('"', at + 1))
    for (const std::string_view name : names) {
      if (svg.compare(at, name.size(), name) != 0) continue;
      const std::size_t digits = at + name.size();
      const std::size_t end = svg.find_first_not_of("0123456789", digits);
      if (end == digits || svg[end] != '"') continue;
      const auto number = numbers.emplace(svg.substr(digits, end - digits), numbers.size() + 1).first->second;
      result += svg.substr(copied, digits - copied) + std::to_string(number);
      copied = end;
    }
  return result + svg.substr(copied);
}

void draw_on(cairo_surface_t* surface, const std::filesystem::path& file, const std::function<void(Canvas&)>& draw) {
  const Context context(cairo_create(surface), cairo_destroy);
  Canvas canvas(context.get());
  draw(canvas);
  cairo_show_page(context.get());
  check(cairo_status(context.get()), file);
  cairo_surface_finish(surface);
  check(cairo_surface_status(surface), file);
}

}  // namespace

Color series_color(std::size_t k) {
  static constexpr std::array<Color, 7> okabe_ito{{{0, 114 / 255.0, 178 / 255.0},            // blue
                                                   {213 / 255.0, 94 / 255.0, 0},             // vermillion
                                                   {0, 158 / 255.0, 115 / 255.0},            // bluish green
                                                   {204 / 255.0, 121 / 255.0, 167 / 255.0},  // reddish purple
                                                   {230 / 255.0, 159 / 255.0, 0},            // orange
                                                   {86 / 255.0, 180 / 255.0, 233 / 255.0},   // sky blue
                                                   {0, 0, 0}}};
  return okabe_ito[k % okabe_ito.size()];
}

Canvas::Canvas(cairo_t* context) : context_(context) {
  cairo_set_font_face(context_, font_face());
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context_, options);
  cairo_font_options_destroy(options);
}

void Canvas::color(const Color& color) { cairo_set_source_rgb(context_, color.red, color.green, color.blue); }

void Canvas::line(double x0, double y0, double x1, double y1, double width) {
  cairo_set_line_width(context_, width);
  cairo_move_to(context_, x0, y0);
  cairo_line_to(context_, x1, y1);
  cairo_stroke(context_);
}

double Canvas::text_width(const std::string& text, double size) {
  cairo_set_font_size(context_, size);
  cairo_text_extents_t extents;
  cairo_text_extents(context_, text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(double x, double y, const std::string& text, double size, Anchor anchor) {
  const double width = text_width(text, size);
  const double before = anchor == Anchor::start ? 0 : anchor == Anchor::middle ? width / 2 : width;
  cairo_move_to(context_, x - before, y);
  cairo_show_text(context_, text.c_str());
}

void Canvas::text_upwards(double x, double y, const std::string& words, double size) {
  cairo_save(context_);
  cairo_translate(context_, x, y);
  cairo_rotate(context_, -std::acos(0.0));
  text(0, 0, words, size, Anchor::middle);
  cairo_restore(context_);
}

void write_all(const std::filesystem::path& stem, double width, double height, double pixels_per_point,
               const std::function<void(Canvas&)>& draw) {
  {
    const std::filesystem::path file = stem.string() + ".svg";
    std::string text;
    const Surface surface(cairo_svg_surface_create_for_stream(append, &text, width, height), cairo_surface_destroy);
    draw_on(surface.get(), file, draw);
    save(file, renumbered(text));
  }
  {
    const std::filesystem::path file = stem.string() + ".pdf";
    std::string text;
    const Surface surface(cairo_pdf_surface_create_for_stream(append, &text, width, height), cairo_surface_destroy);
    draw_on(surface.get(), file, draw);
    // Cairo always writes the date; blanks in its place keep the offsets of the objects that follow.
    if (const std::size_t date = text.rfind("/CreationDate (D:"); date != std::string::npos) {
      const std::size_t length = text.find(')', date) + 1 - date;
      text.replace(date, length, std::string(length, ' '));
    }
    save(file, text);
  }
  {
    const std::filesystem::path file = stem.string() + ".png";
    const Surface surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width * pixels_per_point)),
                                   static_cast<int>(std::ceil(height * pixels_per_point))),
        cairo_surface_destroy);
    check(cairo_surface_status(surface.get()), file);
    const Context context(cairo_create(surface.get()), cairo_destroy);
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
    cairo_scale(context.get(), pixels_per_point, pixels_per_point);
    Canvas canvas(context.get());
    draw(canvas);
    check(cairo_status(context.get()), file);
    std::string bytes;
    check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes), file);
    save(file, bytes);
  }
}

}  // namespace weir::plot
