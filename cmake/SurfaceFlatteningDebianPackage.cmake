# What cpack makes of the project: a Debian package beside Debian's own ParaView. Utilities/package.sh runs it.
option(SURFACEFLATTENING_AUTOLOAD
  "Install a paraview.conf beside ParaView's programs, so that they load the plugin when they start" OFF)
if (SURFACEFLATTENING_AUTOLOAD)
  # ParaView reads <folder of the program>/paraview.conf: one list of plugins per line, relative to that folder.
  # Debian's ParaView has no such file.
  file(RELATIVE_PATH plugin_list
    "/${CMAKE_INSTALL_BINDIR}"
    "/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/surfaceflattening.xml")
  file(WRITE "${CMAKE_BINARY_DIR}/paraview.conf" "${plugin_list}\n")
  install(FILES "${CMAKE_BINARY_DIR}/paraview.conf" DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif ()
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/paraview-surfaceflattening" RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME paraview-surfaceflattening)
set(CPACK_PACKAGE_VERSION "${SURFACEFLATTENING_VERSION}")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "the authors of SurfaceFlattening")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ParaView plugin that flattens surfaces with every area kept")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Flattens surfaces from CT and MRI to a disk, a rectangle or a polygon such that
every triangle keeps its area, and measures the distortion. ParaView loads the plugin when it starts; the
package also has the VTK module and its Python package.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # reads what the libraries need
# A plugin loads only into the ParaView that it was built for.
math(EXPR next_minor "${ParaView_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${ParaView_VERSION}), paraview (<< ${ParaView_VERSION_MAJOR}.${next_minor}~)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-paraview, libopenblas0-serial, python3-nibabel, python3-pydicom, python3-gdcm")

# Python compiles the package when root imports it, into files that dpkg does not know.
file(WRITE "${CMAKE_BINARY_DIR}/prerm" "#!/bin/sh
set -e
rm -rf '${CMAKE_INSTALL_PREFIX}/${SURFACEFLATTENING_PYTHON_DESTINATION}/surfaceflattening/__pycache__'
")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_BINARY_DIR}/prerm")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
include(CPack)
