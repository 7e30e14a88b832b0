# What cpack makes of the project: a Debian package beside Debian's own ParaView. Utilities/package.sh runs it.
option(SURFACEFLATTENING_AUTOLOAD
  "Install a paraview.conf where ParaView's programs look for it, so that they load the plugin when they start" OFF)
if (SURFACEFLATTENING_AUTOLOAD)
  # ParaView reads a paraview.conf: one list of plugins per line, relative to its folder. Debian's ParaView looks for it
  # beside its folder of plugins, where it has one of its own from Debian 13 on, and then beside the programs.
  get_filename_component(conf_folder "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}" DIRECTORY)
  set(replaced_conf "${CMAKE_INSTALL_PREFIX}/${conf_folder}/paraview.conf")
  set(conf_lines "")
  if (EXISTS "${replaced_conf}")
    file(STRINGS "${replaced_conf}" conf_lines)
    list(FILTER conf_lines EXCLUDE REGEX "surfaceflattening")
  else ()
    set(replaced_conf "")
    set(conf_folder "${CMAKE_INSTALL_BINDIR}")
  endif ()
  file(RELATIVE_PATH plugin_list
    "/${conf_folder}"
    "/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/surfaceflattening.xml")
  list(APPEND conf_lines "${plugin_list}")
  list(JOIN conf_lines "\n" conf_text)
  file(WRITE "${CMAKE_BINARY_DIR}/paraview.conf" "${conf_text}\n")
  install(FILES "${CMAKE_BINARY_DIR}/paraview.conf" DESTINATION "${conf_folder}")
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
# While the package is installed, dpkg keeps ParaView's own paraview.conf under another name.
if (SURFACEFLATTENING_AUTOLOAD AND replaced_conf)
  set(divert "dpkg-divert --package ${CPACK_PACKAGE_NAME} --rename --divert '${replaced_conf}.distrib'")
  file(WRITE "${CMAKE_BINARY_DIR}/preinst" "#!/bin/sh
set -e
if [ \"$1\" = install ] || [ \"$1\" = upgrade ]; then
  ${divert} --add '${replaced_conf}'
fi
")
  file(WRITE "${CMAKE_BINARY_DIR}/postrm" "#!/bin/sh
set -e
if [ \"$1\" = remove ] || [ \"$1\" = abort-install ] || [ \"$1\" = disappear ]; then
  ${divert} --remove '${replaced_conf}'
fi
")
  list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_BINARY_DIR}/preinst" "${CMAKE_BINARY_DIR}/postrm")
endif ()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
include(CPack)
