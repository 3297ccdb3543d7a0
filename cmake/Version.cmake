# RUPTURE_VERSION_SOURCE has the version and the commit that is being built. It is looked at before
# each build, so that a new commit needs no new configuration.
set(RUPTURE_VERSION_SOURCE ${CMAKE_BINARY_DIR}/version.cpp)
set(_write ${CMAKE_COMMAND} -D SOURCE=${CMAKE_SOURCE_DIR} -D VERSION=${PROJECT_VERSION}
           -D OUTPUT=${RUPTURE_VERSION_SOURCE} -P ${CMAKE_CURRENT_LIST_DIR}/WriteVersion.cmake)
add_custom_target(rupture_version COMMAND ${_write} BYPRODUCTS ${RUPTURE_VERSION_SOURCE} COMMENT ""
                  VERBATIM)
