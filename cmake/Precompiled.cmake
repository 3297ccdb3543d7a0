# Headers of other projects that many files read, compiled once. None of our own is among them, so a
# change of ours compiles nothing again that does not include it. `./reproduce.sh check` compiles each
# file alone, without them: what it uses, it includes itself or through another header of ours.
set(RUPTURE_PRECOMPILED <Eigen/Core> <algorithm> <cmath> <cstdint> <filesystem> <fmt/format.h>
                        <functional> <optional> <span> <string> <vector>)

# With ccache, a compiler needs to be told that such headers may be used (and ccache itself wants
# sloppiness=pch_defines,time_macros); gcc would otherwise read the headers that were preprocessed.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
elseif(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>")
endif()
