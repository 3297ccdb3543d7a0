# Files that `cmake --install` copies besides the programs (src/tools): the library with its headers,
# the CMake package through which other projects use them (docs/library.md), and the recipes with what
# they read, for `rupture reproduce`.
include(CMakePackageConfigHelpers)
set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/rupture)

install(DIRECTORY python/rupture DESTINATION lib/python3/dist-packages PATTERN __pycache__ EXCLUDE)
install(TARGETS rupture rupture_flags EXPORT ruptureTargets
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/rupture
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT ruptureTargets NAMESPACE rupture:: DESTINATION ${_package})

configure_package_config_file(cmake/ruptureConfig.cmake.in ruptureConfig.cmake
                              INSTALL_DESTINATION ${_package})
write_basic_package_version_file(ruptureConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ruptureConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/ruptureConfigVersion.cmake
        DESTINATION ${_package})

# Here every file has the place that it has in the sources, so that the recipes find it. A link leads to
# the Python package.
set(_share ${CMAKE_INSTALL_DATADIR}/rupture)
set(_link ${CMAKE_BINARY_DIR}/installed/rupture)
file(CREATE_LINK ../../../lib/python3/dist-packages/rupture ${_link} SYMBOLIC)
install(FILES ${_link} DESTINATION ${_share}/python)
install(PROGRAMS reproduce.sh DESTINATION ${_share})
install(DIRECTORY recipes checkpoints docs DESTINATION ${_share} USE_SOURCE_PERMISSIONS
        PATTERN __pycache__ EXCLUDE)
install(DIRECTORY benchmarks/lammps DESTINATION ${_share}/benchmarks FILES_MATCHING PATTERN *.in)
install(FILES CITATION.cff DESTINATION ${_share})
