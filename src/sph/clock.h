// Run time: frame times, timeline events and the duration are landings that steps meet exactly, whether or not anything
// is drawn, so that results do not depend on what is written.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace weir {

// The longest step that is at most `limit` (s) and divides the way to the next landing (s) evenly: no sliver is left.
double fitted_step(double limit, double way);

class Clock {
 public:
  explicit Clock(const Scene& scene);

  double time() const { return time_; }  // s
  bool finished() const { return time_ >= duration_; }
  std::int64_t frame_index() const { return frame_; }  // k if time() is exactly k / fps, else -1
  double next_landing() const;                         // s; the first after time()

  double way() const { return next_landing() - time_; }  // s, to the next landing

  // Moves on by a step from fitted_step(); lands exactly.
  void advance(double dt);
  void advance_to_landing();

 private:
  double frame_time(std::int64_t k) const { return static_cast<double>(k) / fps_; }
  void arrive(double time);

  int fps_;
  double duration_;
  std::vector<double>
      landings_;  // of the timeline, and the duration; ascending, moved onto frame times they nearly are
  double time_ = 0;
  std::int64_t frame_ = 0;
  std::int64_t next_frame_ = 1;
};

}  // namespace weir
