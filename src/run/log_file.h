// log.csv: one row of diagnostics per log interval.
#pragma once

#include <cstdint>
#include <filesystem>

#include "frame/diagnostics.h"
#include "run/text_file.h"

namespace weir {

class LogFile {
 public:
  // `every` in s of run time. Throws OutputError, as do the others.
  LogFile(const std::filesystem::path& file, double every);

  // Whether run time has passed a multiple of the interval since the last row.
  bool due(double time) const;
  void write(const Diagnostics& row);
  void close() { file_.close(); }

  double last_time() const { return last_time_; }                  // s, of the last row; negative before the first
  double max_density_error() const { return max_density_error_; }  // over all rows

 private:
  double next() const;  // run time from which a row is due, s

  TextFile file_;
  double every_;
  std::int64_t multiple_ = 0;  // of the interval, that the next row is for
  double last_time_ = -1;
  double max_density_error_ = 0;
};

}  // namespace weir
