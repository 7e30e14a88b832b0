# What lets another project say find_package(SurfaceFlattening).
include(CMakePackageConfigHelpers)

set(SURFACEFLATTENING_VTK_DIR "${VTK_DIR}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/SurfaceFlatteningConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${SURFACEFLATTENING_CMAKE_DESTINATION}/SurfaceFlatteningConfig.cmake"
  INSTALL_DESTINATION "${SURFACEFLATTENING_CMAKE_DESTINATION}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${SURFACEFLATTENING_CMAKE_DESTINATION}/SurfaceFlatteningConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
vtk_module_export_find_packages(
  CMAKE_DESTINATION "${SURFACEFLATTENING_CMAKE_DESTINATION}"
  FILE_NAME SurfaceFlattening-vtk-module-find-packages.cmake
  MODULES ${modules})
install(
  FILES
    "${CMAKE_CURRENT_LIST_DIR}/SurfaceFlatteningPythonTargets.cmake"
    "${CMAKE_BINARY_DIR}/${SURFACEFLATTENING_CMAKE_DESTINATION}/SurfaceFlatteningConfig.cmake"
    "${CMAKE_BINARY_DIR}/${SURFACEFLATTENING_CMAKE_DESTINATION}/SurfaceFlatteningConfigVersion.cmake"
  DESTINATION "${SURFACEFLATTENING_CMAKE_DESTINATION}"
  COMPONENT development)
