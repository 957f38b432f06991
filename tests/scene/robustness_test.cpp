// Whatever the bytes, the reader returns a scene or mistakes with positions.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scene/texts.h"

namespace weir {
namespace {

// Few particles, so that a digit more or less does not make millions.
const std::string seed_text =
    "weir: 1\ndimension: 2\nduration: 2\nparticles: {spacing: 0.5}\n"
    "fluid: {volumes: [{box: {min: [0, 0], max: [1, 1]}}]}\n"
    "walls: [{tank: {min: [0, 0], max: [3, 2], open: [top]}}]\n"
    "solver: {kernel: {name: wendland_c2}, time_step: {fixed: 0.5}}\n"
    "timeline:\n  - {at: 1, set: {gravity: [1, 0]}}\n"
    "render: {size: [64, 48], overlay: [time, cfl]}\n";

void expect_an_answer(const std::string& text) {
  try {
    read_scene_text(text, "s.yaml");
  } catch (const SceneError& error) {
    ASSERT_FALSE(error.mistakes.empty());
    for (const SceneMistake& mistake : error.mistakes) {
      ASSERT_TRUE(mistake.where.starts_with("s.yaml")) << mistake.where;
      ASSERT_FALSE(mistake.message.empty());
    }
  }
}

TEST(Robustness, AnswersToRandomBytes) {
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::string text(random() % 200, ' ');
    for (char& c : text) c = static_cast<char>(random());
    expect_an_answer(text);
  }
}

TEST(Robustness, AnswersToRandomYamlCharacters) {
  const std::string alphabet = "{}[]:,-?&*!|>'\"%@`#~ \n\n  ab01.e<";
  std::mt19937 random(8);
  for (int i = 0; i < 10000; ++i) {
    std::string text(random() % 80, ' ');
    for (char& c : text) c = alphabet[random() % alphabet.size()];
    expect_an_answer(text);
  }
}

TEST(Robustness, AnswersToMutatedScenes) {
  std::mt19937 random(9);
  const std::string alphabet = "{}[]:,-1. \nabcxyz'\"";
  for (int i = 0; i < 3000; ++i) {
    std::string text = seed_text;
    for (auto k = random() % 6 + 1; k > 0; --k) {
      const std::size_t at = random() % text.size();
      const std::size_t length = std::min<std::size_t>(random() % 12, text.size() - at);
      switch (random() % 4) {
        case 0:
          text[at] = alphabet[random() % alphabet.size()];
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, text.substr(random() % text.size(), length));
          break;
        default:
          text.insert(at, 1, alphabet[random() % alphabet.size()]);
      }
      if (text.empty()) break;
    }
    expect_an_answer(text);
  }
}

}  // namespace
}  // namespace weir
