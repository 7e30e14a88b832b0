# What the Python package has besides the wrapped classes: its functions, one file per line, and the metadata by which
# Python's tools know its version and PyVista finds its accessor.
set(python_files
  __init__.py
  accessors.py
  errors.py
  functions.py
  meshes.py
  py.typed
  running.py
  settings.py
  volumes.py
)
set(package_directory "${CMAKE_BINARY_DIR}/${SURFACEFLATTENING_PYTHON_DESTINATION}")
foreach (file IN LISTS python_files)
  configure_file("Filters/Python/${file}" "${package_directory}/surfaceflattening/${file}" COPYONLY)
endforeach ()
list(TRANSFORM python_files PREPEND "Filters/Python/")
install(FILES ${python_files} DESTINATION "${SURFACEFLATTENING_PYTHON_DESTINATION}/surfaceflattening")

# Modules of the plugin that need VTK alone: readers of scans, files of the cortex, the table of regions. One per line.
set(plugin_modules
  surfaceflattening_dicom.py
  surfaceflattening_invesalius.py
  surfaceflattening_mgh.py
  surfaceflattening_neuro.py
  surfaceflattening_neuro_writers.py
  surfaceflattening_orientation.py
  surfaceflattening_patient_volume.py
  surfaceflattening_region_table.py
  surfaceflattening_scans.py
  surfaceflattening_voxel_files.py
  surfaceflattening_whole_file.py
)
foreach (file IN LISTS plugin_modules)
  configure_file("Plugin/${file}" "${package_directory}/${file}" COPYONLY)
endforeach ()
list(TRANSFORM plugin_modules PREPEND "Plugin/")
install(FILES ${plugin_modules} DESTINATION "${SURFACEFLATTENING_PYTHON_DESTINATION}")

if (SKBUILD)
  # Type stubs of the wrapped classes. (VTK's own way to them works within VTK's build alone.)
  set(stubs "${package_directory}/surfaceflattening/SurfaceFlatteningFilters.pyi")
  add_custom_command(
    OUTPUT "${stubs}"
    COMMAND "${Python3_EXECUTABLE}" -B -m vtkmodules.generate_pyi
      -p surfaceflattening -o "${package_directory}/surfaceflattening" SurfaceFlatteningFilters
    WORKING_DIRECTORY "${package_directory}"
    DEPENDS SurfaceFlatteningFiltersPython
    VERBATIM)
  add_custom_target(SurfaceFlatteningStubs ALL DEPENDS "${stubs}")
  install(FILES "${stubs}" DESTINATION "${SURFACEFLATTENING_PYTHON_DESTINATION}/surfaceflattening")
else () # pip writes the metadata itself
  set(metadata "surfaceflattening-${SURFACEFLATTENING_VERSION}.dist-info")
  file(WRITE "${package_directory}/${metadata}/METADATA"
    "Metadata-Version: 2.1\nName: surfaceflattening\nVersion: ${SURFACEFLATTENING_VERSION}\n"
    "Summary: ${PROJECT_DESCRIPTION}\nLicense: GPL-3.0-or-later\n")
  file(WRITE "${package_directory}/${metadata}/entry_points.txt"
    "[pyvista.accessors]\nflatten = surfaceflattening.accessors\n")
  file(WRITE "${package_directory}/${metadata}/INSTALLER" "cmake\n")
  install(DIRECTORY "${package_directory}/${metadata}" DESTINATION "${SURFACEFLATTENING_PYTHON_DESTINATION}")
endif ()
