#include <fmt/format.h>

#include "plot/plot.h"

namespace weir {

namespace {

// A field after RFC 4180: quoted if it contains a comma, a quote or a line end.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

}  // namespace

std::string csv_of(const LinePlot& plot) {
  std::string text = fmt::format("{},{},{}\n", field(plot.series_column), field(plot.x.column), field(plot.y.column));
  for (const Series& series : plot.series)
    for (std::size_t k = 0; k < series.x.size(); ++k)
      text += fmt::format("{},{},{}\n", field(series.label), series.x[k], series.y[k]);
  return text;
}

}  // namespace weir
