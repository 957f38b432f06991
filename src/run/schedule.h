// When an output with an interval of its own is due.
#pragma once

#include <cstdint>

namespace weir {

// At the start, and whenever run time has passed another multiple of the interval. Steps do not land on these times: such
// an output never changes a run.
class Schedule {
 public:
  explicit Schedule(double every) : every_(every) {}  // s of run time

  bool due(double time) const;
  void written(double time);
  double last() const { return last_; }  // run time last written at, s; negative before the first

 private:
  double every_;
  std::int64_t multiple_ = 0;  // that is written next
  double last_ = -1;
};

}  // namespace weir
