// When the observers of a run are asked to look.
#include "run/observer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/fakes.h"
#include "pipeline/small_scene.h"
#include "run/outputs.h"

namespace weir {

namespace {

using testing::ElementsAre;

// Due every `every` steps.
class Counting final : public Observer {
 public:
  Counting(std::int64_t every, std::vector<std::int64_t>& looks) : every_(every), looks_(looks) {}
  bool due(const Simulation& simulation) const override { return simulation.steps() % every_ == 0; }
  void look(Simulation& simulation) override { looks_.push_back(simulation.steps()); }

 private:
  std::int64_t every_;
  std::vector<std::int64_t>& looks_;
};

TEST(Observers, LookOnlyWhenTheyAreDue) {
  behave({});
  const auto simulation = make_simulation(small_scene(), 1);
  std::vector<std::int64_t> often;
  std::vector<std::int64_t> seldom;
  Observers observers;
  observers.push_back(std::make_unique<Counting>(2, often));
  observers.push_back(std::make_unique<Counting>(3, seldom));
  for (; simulation->steps() <= 6; simulation->step()) look(observers, *simulation);
  EXPECT_THAT(often, ElementsAre(0, 2, 4, 6));
  EXPECT_THAT(seldom, ElementsAre(0, 3, 6));
}

TEST(Observers, HaveNoPicturesUnlessTheSceneAsksForThem) {
  behave({});
  Scene scene = small_scene();
  const auto simulation = make_simulation(scene, 1);
  const RunOptions options;
  const Provenance provenance;
  const RunContext context{scene, options, provenance, 1, *simulation};
  EXPECT_EQ(make_observers(context).size(), 2U);
  scene.output.movie.reset();
  EXPECT_EQ(make_observers(context).size(), 1U);
}

TEST(Outputs, NameTheFilesThatTheSceneAsksFor) {
  Scene scene = small_scene();
  const auto files = [&scene] {
    std::vector<std::string> names;
    for (const OutputKind& kind : output_kinds()) {
      for (const auto& file : kind.files(scene)) names.push_back(file.string());
    }
    return names;
  };
  scene.output.stills = {0.25};
  EXPECT_THAT(files(), ElementsAre("small.mp4", "stills/still_00005.png", "log.csv"));
  scene.output.movie.reset();
  scene.output.stills.clear();
  EXPECT_THAT(files(), ElementsAre("log.csv"));
  scene.output.particles.emplace();
  scene.duration = 0.05;
  EXPECT_THAT(files(), ElementsAre("log.csv", "particles.pvd", "particles_00000.vtp", "particles_00001.vtp"));
  // How many there are depends on the steps.
  scene.output.particles->every = 0.001;
  EXPECT_THAT(files(), ElementsAre("log.csv", "particles.pvd", "particles_00000.vtp"));
}

}  // namespace

}  // namespace weir
