#include "run/log_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace weir {

namespace {

constexpr const char* header =
    "time[s],step,dt[s],cfl[1],max_speed[m/s],mean_density_error[1],mean_compression[1],max_density_error[1],"
    "kinetic_energy[J],potential_energy[J],momentum_x[kg m/s],momentum_y[kg m/s],momentum_z[kg m/s],"
    "center_of_mass_x[m],center_of_mass_y[m],center_of_mass_z[m],simulated_time[s],limit\n";

// Of the interval: run time k/fps and k' * every may name the same instant and differ in the last bits.
constexpr double rounding = 1e-9;

}  // namespace

LogFile::LogFile(const std::filesystem::path& file, double every) : file_(file), every_(every) { file_.write(header); }

bool LogFile::due(double time) const { return time >= next(); }

double LogFile::next() const { return (static_cast<double>(multiple_) - rounding) * every_; }

void LogFile::write(const Diagnostics& row) {
  file_.write(fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.time, row.step, row.dt,
                          row.cfl, row.max_speed, row.mean_density_error, row.mean_compression, row.max_density_error,
                          row.kinetic_energy, row.potential_energy, row.momentum[0], row.momentum[1], row.momentum[2],
                          row.center_of_mass[0], row.center_of_mass[1], row.center_of_mass[2], row.simulated_time,
                          name_of(row.limit)));
  multiple_ = static_cast<std::int64_t>(std::floor(row.time / every_ + rounding)) + 1;
  last_time_ = row.time;
  max_density_error_ = std::max(max_density_error_, row.max_density_error);
}

}  // namespace weir
