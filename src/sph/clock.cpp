#include "sph/clock.h"

#include <algorithm>
#include <cmath>

namespace weir {

namespace {

// Times that differ by less than this share of a frame are the same: sums such as 0.1 + 0.2 miss a frame time by
// rounding.
constexpr double same_instant_per_frame = 1e-6;

// A step count is rounded up unless it is this close to a whole number: an interval of exactly three limits takes
// three.
constexpr double whole_steps_tolerance = 1e-9;

}  // namespace

Clock::Clock(const Scene& scene) : fps_(scene.render.fps), duration_(scene.duration) {
  const auto snapped = [&](double t) {
    const double nearest = frame_time(std::llround(t * fps_));
    return std::abs(t - nearest) * fps_ < same_instant_per_frame ? nearest : t;
  };
  duration_ = snapped(duration_);
  for (const TimelineEvent& event : scene.timeline) {
    landings_.push_back(snapped(event.at));
    landings_.push_back(snapped(event.at + event.over));
  }
  landings_.push_back(duration_);
  std::sort(landings_.begin(), landings_.end());
}

double Clock::next_landing() const {
  const auto event = std::upper_bound(landings_.begin(), landings_.end(), time_);
  const double frame = frame_time(next_frame_);
  return event == landings_.end() ? frame : std::min(*event, frame);
}

double fitted_step(double limit, double way) {
  const double steps = std::max(1.0, std::ceil(way / limit - whole_steps_tolerance));
  return way / steps;
}

void Clock::advance(double dt) {
  const double landing = next_landing();
  // A step from fitted_step() is the last one before a landing, or ends at least half of itself before it.
  arrive(landing - time_ < 1.5 * dt ? landing : time_ + dt);
}

void Clock::advance_to_landing() { arrive(next_landing()); }

void Clock::arrive(double time) {
  time_ = time;
  frame_ = -1;
  if (time_ >= frame_time(next_frame_)) frame_ = next_frame_++;
}

}  // namespace weir
