#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/ticks.h"
#include "plot/cairo.h"
#include "plot/draw.h"

namespace weir::plot {

namespace {

// Points; the figure fits the text width of an A4 page.
constexpr double figure_width = 460;
constexpr double figure_height = 300;
constexpr double pixels_per_point = 3;
constexpr double title_size = 10;
constexpr double label_size = 9;
constexpr double tick_size = 8;
constexpr double margin = 6;
constexpr double right_margin = 14;  // room for half a tick label
constexpr double title_height = 20;
constexpr double legend_height = 17;
constexpr double bottom_height = 36;
constexpr double tick_length = 3;

// From data to points along one axis.
class Scale {
 public:
  Scale(double low, double high, double from, double to, bool logarithmic)
      : logarithmic_(logarithmic), low_(along(low)), high_(along(high)), from_(from), to_(to) {}
  double operator()(double value) const { return from_ + (along(value) - low_) / (high_ - low_) * (to_ - from_); }

 private:
  double along(double value) const { return logarithmic_ ? std::log10(value) : value; }
  bool logarithmic_;
  double low_, high_, from_, to_;
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

bool drawable(double value, const PlotAxis& axis) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

// What the points span, a little wider by `padding` of it.
Range range_of(const LinePlot& plot, std::vector<double> Series::*values, const PlotAxis& axis, double padding) {
  Range range;
  for (const Series& series : plot.series)
    for (const double value : series.*values)
      if (drawable(value, axis)) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
      }
  if (range.low > range.high)
    throw std::invalid_argument(fmt::format("plot '{}': nothing to draw along '{}'", plot.title, axis.title));
  if (axis.logarithmic) {
    const double factor = range.high > range.low ? std::pow(range.high / range.low, padding) : 2;
    return {range.low / factor, range.high * factor};
  }
  // A span of rounding errors is drawn as a constant.
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  const double span = range.high - range.low;
  const double more = span > 1e-8 * size ? padding * span : size > 0 ? 0.1 * size : 1;
  return {range.low - more, range.high + more};
}

std::vector<Tick> ticks_of(const Range& range, const PlotAxis& axis, int most) {
  return axis.logarithmic ? logarithmic_ticks(range.low, range.high) : linear_ticks(range.low, range.high, most);
}

class Figure {
 public:
  Figure(Canvas& canvas, const LinePlot& plot)
      : canvas_(canvas),
        plot_(plot),
        x_range_(range_of(plot, &Series::x, plot.x, 0)),
        y_range_(range_of(plot, &Series::y, plot.y, 0.05)),
        x_ticks_(ticks_of(x_range_, plot.x, 9)),
        y_ticks_(ticks_of(y_range_, plot.y, 8)),
        left_(margin + label_size + 8 + widest_label() + tick_length),
        right_(figure_width - right_margin),
        top_(title_height + legend_height + 4),
        bottom_(figure_height - bottom_height),
        x_(x_range_.low, x_range_.high, left_, right_, plot.x.logarithmic),
        y_(y_range_.low, y_range_.high, bottom_, top_, plot.y.logarithmic) {}

  void draw() {
    draw_grid();
    draw_series();
    draw_axes();
    draw_legend();
  }

 private:
  double widest_label() {
    double widest = 0;
    for (const Tick& tick : y_ticks_) widest = std::max(widest, canvas_.text_width(tick.label, tick_size));
    return widest;
  }

  void draw_grid() {
    canvas_.color(faint);
    for (const Tick& tick : x_ticks_)
      if (!tick.label.empty()) canvas_.line(x_(tick.value), top_, x_(tick.value), bottom_, 0.5);
    for (const Tick& tick : y_ticks_)
      if (!tick.label.empty()) canvas_.line(left_, y_(tick.value), right_, y_(tick.value), 0.5);
    // A zero line for signed quantities.
    if (!plot_.y.logarithmic && y_range_.low < 0 && y_range_.high > 0) {
      canvas_.color({0.55, 0.55, 0.55});
      canvas_.line(left_, y_(0), right_, y_(0), 0.7);
    }
  }

  void draw_series() {
    cairo_t* const context = canvas_.context();
    cairo_save(context);
    cairo_rectangle(context, left_, top_, right_ - left_, bottom_ - top_);
    cairo_clip(context);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    for (std::size_t k = 0; k < plot_.series.size(); ++k) {
      const Series& series = plot_.series[k];
      canvas_.color(series_color(k));
      // Each line is narrower than those below it, so that coinciding lines are all visible.
      cairo_set_line_width(context, 1.2 + 1.0 * static_cast<double>(plot_.series.size() - 1 - k));
      bool drawing = false;
      for (std::size_t point = 0; point < series.x.size(); ++point) {
        const bool here = drawable(series.x[point], plot_.x) && drawable(series.y[point], plot_.y);
        if (here && drawing) cairo_line_to(context, x_(series.x[point]), y_(series.y[point]));
        if (here && !drawing) cairo_move_to(context, x_(series.x[point]), y_(series.y[point]));
        drawing = here;
      }
      cairo_stroke(context);
    }
    cairo_restore(context);
  }

  void draw_axes() {
    canvas_.color(ink);
    canvas_.line(left_, bottom_, right_, bottom_, 0.8);
    canvas_.line(left_, top_, left_, bottom_, 0.8);
    for (const Tick& tick : x_ticks_) {
      canvas_.line(x_(tick.value), bottom_, x_(tick.value), bottom_ + (tick.label.empty() ? 1.5 : tick_length), 0.8);
      canvas_.text(x_(tick.value), bottom_ + tick_length + tick_size + 1, tick.label, tick_size, Anchor::middle);
    }
    for (const Tick& tick : y_ticks_) {
      canvas_.line(left_ - (tick.label.empty() ? 1.5 : tick_length), y_(tick.value), left_, y_(tick.value), 0.8);
      // The baseline that centres digits vertically.
      canvas_.text(left_ - tick_length - 2, y_(tick.value) + 0.36 * tick_size, tick.label, tick_size, Anchor::end);
    }
    canvas_.text((left_ + right_) / 2, figure_height - margin - 2, plot_.x.title, label_size, Anchor::middle);
    canvas_.text_upwards(margin + label_size, (top_ + bottom_) / 2, plot_.y.title, label_size);
    canvas_.text(left_, 14, plot_.title, title_size);
  }

  // A row above the plot.
  void draw_legend() {
    const double baseline = title_height + 10;
    double x = left_;
    if (!plot_.legend.empty()) {
      canvas_.text(x, baseline, plot_.legend + ":", tick_size);
      x += canvas_.text_width(plot_.legend + ":", tick_size) + 10;
    }
    for (std::size_t k = 0; k < plot_.series.size(); ++k) {
      canvas_.color(series_color(k));
      canvas_.line(x, baseline - 3, x + 18, baseline - 3, 1.8);
      canvas_.color(ink);
      canvas_.text(x + 22, baseline, plot_.series[k].label, tick_size);
      x += 22 + canvas_.text_width(plot_.series[k].label, tick_size) + 14;
    }
  }

  Canvas& canvas_;
  const LinePlot& plot_;
  Range x_range_, y_range_;
  std::vector<Tick> x_ticks_, y_ticks_;
  double left_, right_, top_, bottom_;
  Scale x_, y_;
};

}  // namespace

void draw_lines(const std::filesystem::path& stem, const LinePlot& plot) {
  write_all(stem, figure_width, figure_height, pixels_per_point, [&](Canvas& canvas) { Figure(canvas, plot).draw(); });
}

}  // namespace weir::plot
