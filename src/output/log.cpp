#include "output/log.h"

#include <fmt/format.h>

namespace weir {

namespace {

std::string components(std::string_view name, std::string_view unit, int dimension) {
  std::string text;
  for (const char axis : std::string_view("xyz").substr(0, static_cast<std::size_t>(dimension))) {
    text += fmt::format(",{}_{}[{}]", name, axis, unit);
  }
  return text;
}

}  // namespace

CsvRow& CsvRow::add(double value) { return add(std::string_view(fmt::format("{}", value))); }

CsvRow& CsvRow::add(std::int64_t value) { return add(std::string_view(fmt::format("{}", value))); }

CsvRow& CsvRow::add(std::string_view text) {
  if (!text_.empty()) text_ += ',';
  text_ += text;
  return *this;
}

std::string log_header(int dimension) {
  return "time[s],step,dt[s],cfl[1],max_speed[m/s],mean_density_error[1],mean_compression[1],max_density_error[1],"
         "kinetic_energy[J],potential_energy[J]" +
         components("momentum", "kg*m/s", dimension) + ",simulated_time[s],limit" +
         components("center_of_mass", "m", dimension);
}

std::string log_row(const Diagnostics& diagnostics, int dimension) {
  CsvRow row;
  row.add(diagnostics.time).add(diagnostics.step).add(diagnostics.dt).add(diagnostics.cfl).add(diagnostics.max_speed);
  row.add(diagnostics.mean_density_error).add(diagnostics.mean_compression).add(diagnostics.max_density_error);
  row.add(diagnostics.kinetic_energy).add(diagnostics.potential_energy);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) row.add(diagnostics.momentum[axis]);
  row.add(diagnostics.simulated_time).add(name_of(diagnostics.limit));
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    row.add(diagnostics.center_of_mass[axis]);
  }
  return row.text();
}

LogWriter::LogWriter(const std::filesystem::path& file, int dimension) : file_(file), dimension_(dimension) {
  file_.append(log_header(dimension_) + '\n');
}

void LogWriter::write(const Diagnostics& diagnostics) { file_.append(log_row(diagnostics, dimension_) + '\n'); }

void LogWriter::close() { file_.close(); }

}  // namespace weir
