# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

# rupture/version.hpp has the version and the commit that is being built. It is looked at before each
# build, so that a new commit needs no new configuration.
set(RUPTURE_GENERATED_DIR ${CMAKE_BINARY_DIR}/generated)
set(_header ${RUPTURE_GENERATED_DIR}/rupture/version.hpp)
set(_write ${CMAKE_COMMAND} -D SOURCE=${CMAKE_SOURCE_DIR} -D VERSION=${PROJECT_VERSION}
           -D OUTPUT=${_header} -P ${CMAKE_CURRENT_LIST_DIR}/WriteVersion.cmake)
execute_process(COMMAND ${_write})  # for clang-tidy, which reads it without a build
add_custom_target(rupture_version COMMAND ${_write} BYPRODUCTS ${_header} COMMENT "")
