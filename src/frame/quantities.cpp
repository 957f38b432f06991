#include "frame/quantities.h"

namespace weir {

namespace {

// A quantity is the index of its line.
constexpr bool in_order() {
  for (std::size_t line = 0; line < quantities.size(); ++line) {
    if (static_cast<std::size_t>(quantities[line].quantity) != line) return false;
  }
  return true;
}
static_assert(in_order(), "the table of quantities has the order of the enumeration");

}  // namespace

std::string name_with_unit(Quantity quantity) {
  const QuantityFacts& facts = facts_of(quantity);
  std::string text(facts.name);
  if (!facts.unit.empty()) text.append(" [").append(facts.unit).append("]");
  return text;
}

std::string typeset(std::string_view unit) {
  std::string text;
  for (std::size_t at = 0; at < unit.size(); ++at) {
    const std::string_view power = unit.substr(at, 2);
    if (power == "^2" || power == "^3") {
      text += power == "^2" ? "²" : "³";
      ++at;
    } else {
      text += unit[at];
    }
  }
  return text;
}

}  // namespace weir
