#include "sph/engine/engine.h"

#include <stdexcept>

namespace weir {

// In loops_2d.cpp and loops_3d.cpp, which are built once per instruction set.
namespace baseline {
template <int Dim>
Loops<Dim> loops(const Terms& terms);
}
#if defined(__x86_64__)
namespace avx2 {
template <int Dim>
Loops<Dim> loops(const Terms& terms);
}
namespace avx512 {
template <int Dim>
Loops<Dim> loops(const Terms& terms);
}
#endif

template <int Dim>
Loops<Dim> loops_for(InstructionSet set, const Terms& terms) {
  switch (set) {
    case InstructionSet::baseline:
      return baseline::loops<Dim>(terms);
#if defined(__x86_64__)
    case InstructionSet::avx2:
      return avx2::loops<Dim>(terms);
    case InstructionSet::avx512:
      return avx512::loops<Dim>(terms);
#endif
    default:
      throw std::logic_error("instruction set that this program was not built with");
  }
}

template Loops<2> loops_for<2>(InstructionSet set, const Terms& terms);
template Loops<3> loops_for<3>(InstructionSet set, const Terms& terms);

}  // namespace weir
