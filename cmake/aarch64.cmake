# Builds for aarch64 with Debian's cross compiler, against the arm64 libraries in CMAKE_SYSROOT:
#
#   tests/golden/sysroot.sh arm64 build
#   cmake -B build/aarch64 --toolchain cmake/aarch64.cmake -DCMAKE_SYSROOT=$PWD/build/sysroot-arm64
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${CMAKE_SYSROOT})

# Nothing of this machine's own but programs.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# FindHDF5 would ask h5cc, which answers for this machine.
set(HDF5_C_COMPILER_EXECUTABLE "")
