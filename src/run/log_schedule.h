// When a row of the log is due.
#pragma once

#include <cstdint>

namespace weir {

// A row at the start, and whenever run time has passed another multiple of the interval. Steps do not land on these
// times: a log never changes a run.
class LogSchedule {
 public:
  explicit LogSchedule(double every) : every_(every) {}  // s of run time

  bool due(double time) const;
  void written(double time);
  double last() const { return last_; }  // run time of the last row, s; negative before the first

 private:
  double every_;
  std::int64_t multiple_ = 0;  // that the next row is for
  double last_ = -1;
};

}  // namespace weir
