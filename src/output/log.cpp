#include "output/log.h"

#include <fmt/format.h>

#include <array>
#include <variant>

namespace weir {

namespace {

// Calls visit(suffix, value) for every component of a column: once for all but vectors.
template <class Visit>
void for_each_component(const DiagnosticColumn& column, const Diagnostics& row, int dimension, const Visit& visit) {
  if (const auto* vector = std::get_if<std::array<double, 3> Diagnostics::*>(&column.value)) {
    static constexpr std::array<std::string_view, 3> suffixes{"_x", "_y", "_z"};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      visit(suffixes[axis], (row.**vector)[axis]);
    }
  } else if (const auto* limit = std::get_if<StepLimit Diagnostics::*>(&column.value)) {
    visit("", name_of(row.**limit));
  } else if (const auto* count = std::get_if<std::int64_t Diagnostics::*>(&column.value)) {
    visit("", row.**count);
  } else {
    visit("", row.*std::get<double Diagnostics::*>(column.value));
  }
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
  CsvRow row;
  for (const DiagnosticColumn& column : diagnostic_columns()) {
    const std::string unit = column.unit.empty() ? "" : fmt::format("[{}]", column.unit);
    for_each_component(column, {}, dimension, [&](std::string_view suffix, const auto&) {
      row.add(std::string_view(fmt::format("{}{}{}", column.name, suffix, unit)));
    });
  }
  return row.text();
}

std::string log_row(const Diagnostics& diagnostics, int dimension) {
  CsvRow row;
  for (const DiagnosticColumn& column : diagnostic_columns()) {
    for_each_component(column, diagnostics, dimension,
                       [&](std::string_view /*suffix*/, const auto& value) { row.add(value); });
  }
  return row.text();
}

LogWriter::LogWriter(const std::filesystem::path& file, int dimension) : file_(file), dimension_(dimension) {
  file_.append(log_header(dimension_) + '\n');
}

void LogWriter::write(const Diagnostics& diagnostics) { file_.append(log_row(diagnostics, dimension_) + '\n'); }

void LogWriter::close() { file_.close(); }

}  // namespace weir
