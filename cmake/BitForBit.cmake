# Compiler flags on which equal checksums rest. What other flags make of the arithmetic, the compiler is
# asked in rupture/model/exact_arithmetic.hpp, and each program at its start.
#
# -ffp-contract=off keeps a*b+c as two rounded operations. The two others only tell the compiler that
# nobody reads errno or floating-point traps, so that square roots and selections vectorise; they
# change no value.
set(RUPTURE_BIT_FOR_BIT_FLAGS -ffp-contract=off -fno-math-errno -fno-trapping-math -fopenmp-simd)
