#include "scene/check.h"

#include "scene/checker.h"

namespace weir {

std::vector<Violation> check(const Scene& scene) {
  return check(scene, [](const std::string&) { return false; });
}

std::vector<Violation> check(const Scene& scene, const Unread& unread) {
  Checker checker(scene, unread);
  check_ranges(checker);
  check_geometry(checker);
  check_periodic(checker);
  check_solver(checker);
  check_overlap(checker);
  check_timeline(checker);
  check_pictures(checker);
  return checker.take();
}

}  // namespace weir
