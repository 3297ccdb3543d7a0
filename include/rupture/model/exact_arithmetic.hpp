// Stops compilation where the compiler itself says that it changes floating-point results.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || __FINITE_MATH_ONLY__ != 0 || FLT_EVAL_METHOD != 0 ||       \
    (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0)
#error "This build would compute other bits: remove options that change floating-point results"
#endif
