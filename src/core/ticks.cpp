#include "core/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace weir {

namespace {

// Tolerance of quotients: 0.3 / 0.1 rounds to less than 3.
constexpr double slack = 1e-9;

std::string power_of_ten(int exponent) {
  static constexpr std::array<std::string_view, 10> superscript{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += superscript[static_cast<std::size_t>(digit - '0')];
  return text;
}

// digits * 10^exponent with the digits given.
std::string scientific(const std::string& digits, int exponent) {
  if (digits == "0") return digits;
  std::string power = power_of_ten(exponent);
  if (digits == "1") return power;
  return digits == "-1" ? "−" + power : digits + "·" + power;
}

// The minus sign is as wide as a digit; a hyphen is narrower.
std::string with_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

struct Step {
  int digit = 1;     // 1, 2 or 5
  int exponent = 0;  // of ten
  double value() const { return digit * std::pow(10.0, exponent); }
};

// The smallest step with at most `most` multiples inside a span.
Step step_for(double span, int most) {
  const double coarsest = span / std::max(most - 1, 1) * (1 - slack);
  const int exponent = static_cast<int>(std::floor(std::log10(coarsest)));
  for (const int digit : {1, 2, 5})
    if (const Step step{digit, exponent}; step.value() >= coarsest) return step;
  return {1, exponent + 1};
}

}  // namespace

std::vector<Tick> linear_ticks(double low, double high, int most) {
  const Step step = step_for(high - low, most);
  const double size = step.value();
  const bool small = step.exponent < -4;
  const bool large = std::max(std::abs(low), std::abs(high)) >= 1e5;
  const auto first = static_cast<long long>(std::ceil(low / size - slack));
  const auto last = static_cast<long long>(std::floor(high / size + slack));
  std::vector<Tick> ticks;
  for (long long k = first; k <= last; ++k) {
    const double value = static_cast<double>(k) * size;
    const std::string label = small || large ? scientific(std::to_string(k * step.digit), step.exponent)
                                             : fmt::format("{:.{}f}", value, std::max(0, -step.exponent));
    ticks.push_back({value, with_minus(label)});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(double low, double high) {
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  const bool few = std::floor(std::log10(high) + slack) - std::ceil(std::log10(low) - slack) < 1;
  std::vector<Tick> ticks;
  for (int exponent = first; exponent <= last; ++exponent)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, exponent);
      if (value < low * (1 - slack) || value > high * (1 + slack)) continue;
      const bool labelled = digit == 1 || (few && (digit == 2 || digit == 5));
      ticks.push_back({value, labelled ? scientific(std::to_string(digit), exponent) : std::string()});
    }
  return ticks;
}

}  // namespace weir
