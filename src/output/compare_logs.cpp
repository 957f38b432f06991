#include "output/compare_logs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace weir {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

// The largest difference of a column, against the largest value in it.
struct ColumnDifference {
  double largest = 0;
  double apart = 0;

  void add(std::string_view a, std::string_view b) {
    double x = 0;
    double y = 0;
    if (std::from_chars(a.data(), a.data() + a.size(), x).ec != std::errc{}) return;
    if (std::from_chars(b.data(), b.data() + b.size(), y).ec != std::errc{}) return;
    largest = std::max({largest, std::abs(x), std::abs(y)});
    apart = std::max(apart, std::abs(x - y));
  }
  double relative() const { return largest > 0 ? apart / largest : 0; }
};

}  // namespace

ComparisonItem compare_logs(std::string_view a, std::string_view b) {
  ComparisonItem item{.name = "log.csv", .same = a == b, .text = "the same", .pixels = {}, .first_frame_apart = {}};
  if (item.same) return item;
  const std::vector<std::string_view> rows_a = split(a, '\n');
  const std::vector<std::string_view> rows_b = split(b, '\n');
  if (rows_a.empty() || rows_b.empty() || rows_a.front() != rows_b.front()) {
    item.text = "the columns are not the same";
    return item;
  }
  const std::vector<std::string_view> names = split(rows_a.front(), ',');
  std::vector<ColumnDifference> columns(names.size());
  const std::size_t common = std::min(rows_a.size(), rows_b.size());
  std::size_t first = common;
  for (std::size_t row = 1; row < common; ++row) {
    if (rows_a[row] != rows_b[row]) first = std::min(first, row);
    const std::vector<std::string_view> cells_a = split(rows_a[row], ',');
    const std::vector<std::string_view> cells_b = split(rows_b[row], ',');
    for (std::size_t i = 0; i < std::min({names.size(), cells_a.size(), cells_b.size()}); ++i) {
      columns[i].add(cells_a[i], cells_b[i]);
    }
  }
  const auto worst = std::ranges::max_element(columns, {}, &ColumnDifference::relative);
  item.text = fmt::format("{} and {} rows", rows_a.size() - 1, rows_b.size() - 1);
  if (first < common) {
    item.text += fmt::format(", apart from row {} on; most in {}: {:.3g}, which is {:.3g} of its largest value", first,
                             names[static_cast<std::size_t>(worst - columns.begin())], worst->apart, worst->relative());
  }
  return item;
}

}  // namespace weir
