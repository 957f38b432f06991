// Vectors of four floats or integers in vector types of the compiler, for particles and pixels on the processor.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>
#include <span>

namespace weir {

using Four = float __attribute__((vector_size(16)));
using FourWhole = std::int32_t __attribute__((vector_size(16)));

inline Four smaller(Four a, Four b) { return a < b ? a : b; }
inline Four larger(Four a, Four b) { return a > b ? a : b; }
inline Four all(float value) { return Four{} + value; }
inline FourWhole truncated(Four value) { return __builtin_convertvector(value, FourWhole); }
inline Four floats(FourWhole value) { return __builtin_convertvector(value, Four); }

// Columns become rows.
inline std::array<Four, 4> transposed(const std::array<Four, 4>& of) {
  const Four low_a = __builtin_shufflevector(of[0], of[1], 0, 4, 1, 5);
  const Four low_b = __builtin_shufflevector(of[2], of[3], 0, 4, 1, 5);
  const Four high_a = __builtin_shufflevector(of[0], of[1], 2, 6, 3, 7);
  const Four high_b = __builtin_shufflevector(of[2], of[3], 2, 6, 3, 7);
  return {__builtin_shufflevector(low_a, low_b, 0, 1, 4, 5), __builtin_shufflevector(low_a, low_b, 2, 3, 6, 7),
          __builtin_shufflevector(high_a, high_b, 0, 1, 4, 5), __builtin_shufflevector(high_a, high_b, 2, 3, 6, 7)};
}

// Calls visit with four vectors at a time, of all x, y, z and w of four of them; what is missing to the last four is
// not a number.
template <class Visit>
void visit_by_four(std::span<const glm::vec4> vectors, const Visit& visit) {
  const auto load = [](const glm::vec4& from) {
    Four lanes;
    std::memcpy(&lanes, &from, sizeof(lanes));
    return lanes;
  };
  const auto visit_four = [&](const glm::vec4* from) {
    visit(transposed({load(from[0]), load(from[1]), load(from[2]), load(from[3])}));
  };
  std::size_t k = 0;
  for (; k + 4 <= vectors.size(); k += 4) visit_four(&vectors[k]);
  if (k == vectors.size()) return;
  std::array<glm::vec4, 4> rest;
  rest.fill(glm::vec4(std::numeric_limits<float>::quiet_NaN()));
  std::copy(vectors.begin() + k, vectors.end(), rest.begin());
  visit_four(rest.data());
}

}  // namespace weir
