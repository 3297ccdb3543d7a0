# Compiler flags on which equal checksums rest, and a refusal of those that would break them.
#
# -ffp-contract=off keeps a*b+c as two rounded operations. The two others only tell the compiler that
# nobody reads errno or floating-point traps, so that square roots and selections vectorise; they
# change no value.
set(RUPTURE_BIT_FOR_BIT_FLAGS -ffp-contract=off -fno-math-errno -fno-trapping-math -fopenmp-simd)

string(TOUPPER "${CMAKE_BUILD_TYPE}" _type)
set(_given " ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${_type}} ${RUPTURE_KERNEL_FLAGS} ${RUPTURE_LIBRARY_FLAGS} \
$ENV{CXXFLAGS} ")
foreach(_flag -ffast-math -Ofast -funsafe-math-optimizations -fassociative-math
              -freciprocal-math -ffp-contract=fast -ffinite-math-only)
  if("${_given}" MATCHES "[ ;]${_flag}[ ;]")
    message(FATAL_ERROR "${_flag} changes floating-point results, so checkpoints would no longer be "
                        "bit for bit the same on every machine: remove it from the compiler flags.")
  endif()
endforeach()
