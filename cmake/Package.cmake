# `cpack --config build/release/CPackConfig.cmake -B build/package` makes rupture_VERSION_amd64.deb there, of what is installed.
# Libraries that it needs are found by dpkg-shlibdeps; what `rupture reproduce` needs is in packages.txt.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rupture)
set(CPACK_PACKAGE_CONTACT "The rupture authors <rupture@rupture.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulate and analyse the rupture of frictional interfaces")
set(CPACK_PACKAGE_DESCRIPTION
    "A computer model of a loaded slider whose frictional interface is made of
thousands of microscopic junctions, and the programs to do experiments with it.
It reproduces the figures of a paper on slow slip and slow fronts.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

file(STRINGS packages.txt _rows REGEX "^run ")
list(TRANSFORM _rows REPLACE "^run +| *#.*" "")
list(JOIN _rows ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
# For films, tables and labelled arrays; to compile programs against the library.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, python3-pandas")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "python3-h5netcdf, paraview, g++, cmake, libeigen3-dev, libhdf5-dev, libfmt-dev, libssl-dev")

# What Debian's policy asks of every package: copyright, and a changelog in a form of its own.
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(_changelog ${CMAKE_BINARY_DIR}/package/changelog)
file(WRITE ${_changelog} "rupture (${PROJECT_VERSION}) unstable; urgency=medium

  * The changes are listed in /usr/share/doc/rupture/CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${_date}
")
execute_process(COMMAND gzip --force --best --no-name ${_changelog} COMMAND_ERROR_IS_FATAL ANY)
set(_doc ${CMAKE_INSTALL_DATADIR}/doc/rupture)
install(FILES LICENSE DESTINATION ${_doc} RENAME copyright)
install(FILES ${_changelog}.gz README.md CHANGELOG.md DESTINATION ${_doc})

include(CPack)
