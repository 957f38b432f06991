#include "frame/snapshot.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace weir {

bool SnapshotRequest::needs_refresh() const {
  return std::any_of(fluid.begin(), fluid.end(),
                     [](Quantity quantity) { return facts_of(quantity).stale == Stale::after_step; });
}

const FieldValues& SetSnapshot::field(Quantity quantity) const {
  for (const FieldValues& field : fields) {
    if (field.quantity == quantity) return field;
  }
  throw std::out_of_range("the snapshot has no field " + std::string(name_of(quantity)));
}

const std::vector<float>& SetSnapshot::reals(Quantity quantity) const {
  return std::get<std::vector<float>>(field(quantity).values);
}

const std::vector<std::int32_t>& SetSnapshot::integers(Quantity quantity) const {
  return std::get<std::vector<std::int32_t>>(field(quantity).values);
}

}  // namespace weir
