// Dynamic pruning of lists: a loop that has the distances at hand leaves later ones only the clusters within the support.
#pragma once

#include "simd/lanes.h"
#include "sph/pair_lists.h"

namespace weir::WEIR_INSTRUCTION_SET {

class Pruned {
 public:
  // `out` has room for as much as is pruned. Those clusters remain that are within the support radius (m), and perhaps
  // some that are hardly beyond.
  WEIR_INLINE Pruned(std::int32_t* out, float support_radius)
      : limit_(1.00001F * support_radius * support_radius), out_(out) {}

  WEIR_INLINE void append(std::int32_t number) { *out_++ = number; }
  // A header, then those clusters offered that are near.
  WEIR_INLINE void begin() { header_ = out_++; }
  WEIR_INLINE void offer(std::int32_t slot, Lanes r2) {
    *out_ = slot;
    out_ += any(less(r2, limit_)) ? 1 : 0;
  }
  WEIR_INLINE void end_count() { *header_ = count(); }
  // Without clusters there is no segment. Returns whether there are any.
  WEIR_INLINE bool end_segment(std::int32_t code) {
    const std::int32_t found = count();
    if (found == 0) {
      out_ = header_;
    } else {
      *header_ = found << segment_code_bits | code;
    }
    return found > 0;
  }
  WEIR_INLINE std::int32_t* end() const { return out_; }
  WEIR_INLINE void cut(std::int32_t* end) { out_ = end; }

 private:
  WEIR_INLINE std::int32_t count() const { return static_cast<std::int32_t>(out_ - header_ - 1); }

  Lanes limit_;
  std::int32_t* out_;
  std::int32_t* header_ = nullptr;
};

// Of a loop that does not prune.
struct Unpruned {
  static WEIR_INLINE void append(std::int32_t) {}
  static WEIR_INLINE void begin() {}
  static WEIR_INLINE void offer(std::int32_t, Lanes) {}
  static WEIR_INLINE void end_count() {}
  static WEIR_INLINE bool end_segment(std::int32_t) { return true; }
  static WEIR_INLINE std::int32_t* end() { return nullptr; }
  static WEIR_INLINE void cut(std::int32_t*) {}
};

}  // namespace weir::WEIR_INSTRUCTION_SET
