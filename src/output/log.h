// log.csv: the run's numbers, a row per log interval.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "frame/diagnostics.h"
#include "output/file.h"

namespace weir {

// A comma-separated row, numbers with the fewest digits that read back to the same double.
class CsvRow {
 public:
  CsvRow& add(double value);
  CsvRow& add(std::int64_t value);
  CsvRow& add(std::string_view text);  // without commas, quotes and line ends
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// "time[s],step,dt[s],...": diagnostic_columns(). Vectors have x and y in 2D.
std::string log_header(int dimension);
std::string log_row(const Diagnostics& diagnostics, int dimension);

// Each row is passed to the kernel when write() returns: a kill leaves complete rows. Throws OutputError.
class LogWriter {
 public:
  LogWriter(const std::filesystem::path& file, int dimension);
  void write(const Diagnostics& diagnostics);
  void close();

 private:
  GrowingFile file_;
  int dimension_;
};

}  // namespace weir
