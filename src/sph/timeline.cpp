#include "sph/timeline.h"

#include "equations/state.h"

namespace weir {

namespace {

// Run times are moved onto frame times that they miss by rounding (clock.h); so far an event may be early.
constexpr double rounding = 1e-9;

}  // namespace

template <class T>
void Timeline::Ramp<T>::begin(const TimelineEvent& event, const T& now, const T& target) {
  start = event.at;
  length = event.over;
  from = now;
  to = target;
  active = true;
}

template <class T>
void Timeline::Ramp<T>::apply(double time, T& value) {
  if (!active) return;
  active = time < start + length - rounding;
  value = active ? from + (time - start) / length * (to - from) : to;
}

Timeline::Timeline(const Scene& scene) : scene_(&scene), state_(initial_parameters(scene)) {}

void Timeline::start(const TimelineEvent& event) {
  if (event.set.gravity) gravity_.begin(event, state_.gravity, *event.set.gravity);
  if (event.set.viscosity) viscosity_.begin(event, state_.viscosity, *event.set.viscosity);
  if (event.set.surface_tension) surface_tension_.begin(event, state_.surface_tension, *event.set.surface_tension);
  if (event.set.stiffness) stiffness_.begin(event, state_.stiffness, *event.set.stiffness);
  if (event.set.sound_speed) {
    const double k = stiffness_of_state(*event.set.sound_speed, scene_->solver.exponent, scene_->fluid.rest_density);
    stiffness_.begin(event, state_.stiffness, k);
  }
  if (event.pause) paused_ = *event.pause;
}

bool Timeline::advance_to(double time) {
  bool reset = false;
  const auto apply = [&](double t) {
    gravity_.apply(t, state_.gravity);
    viscosity_.apply(t, state_.viscosity);
    surface_tension_.apply(t, state_.surface_tension);
    stiffness_.apply(t, state_.stiffness);
  };
  for (; next_ < scene_->timeline.size() && scene_->timeline[next_].at <= time + rounding; ++next_) {
    const TimelineEvent& event = scene_->timeline[next_];
    apply(event.at);
    start(event);
    reset = reset || event.reset;
  }
  apply(time);
  return reset;
}

}  // namespace weir
