// The loops of kernels.hpp, compiled once per instruction set: RUPTURE_ISA names this variant,
// RUPTURE_LANES is how many doubles its registers hold. Nothing here may include a library header
// with inline functions: the linker would keep one copy of each for all variants, possibly one that
// the processor cannot run.
#include "inexactness.hpp"
#include "interface.hpp"
#include "step.hpp"

#define RUPTURE_STRING_(x) #x
#define RUPTURE_STRING(x) RUPTURE_STRING_(x)
#define RUPTURE_JOIN_(a, b) a##b
#define RUPTURE_JOIN(a, b) RUPTURE_JOIN_(a, b)

namespace rupture {

extern const Kernels RUPTURE_JOIN(kernels_, RUPTURE_ISA);
const Kernels RUPTURE_JOIN(kernels_, RUPTURE_ISA) = {RUPTURE_STRING(RUPTURE_ISA),
                                                     inexactness,
                                                     scratch_size,
                                                     kick_drift,
                                                     elastic,
                                                     damping,
                                                     prepare,
                                                     finish,
                                                     contact,
                                                     trail};

}  // namespace rupture
