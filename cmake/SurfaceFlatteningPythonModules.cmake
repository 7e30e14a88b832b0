# Python modules inside the plugin. ParaView's own way, PYTHON_MODULES of paraview_add_plugin, does not do: ParaView 6.1
# forgets a plugin's server-manager XML when it reads the plugin's modules.

# surfaceflattening_embed_modules(<variable> <module>...)
# Sets the variable to sources that hold the texts of the modules. PythonTexts.h has a table of them.
function (surfaceflattening_embed_modules variable)
  set(sources)
  set(includes)
  set(entries)
  foreach (module IN LISTS ARGN)
    get_filename_component(name "${module}" NAME_WE)
    vtk_encode_string(
      INPUT "${module}"
      NAME "${name}_text"
      HEADER_OUTPUT header
      SOURCE_OUTPUT source
      BINARY NUL_TERMINATE)
    list(APPEND sources "${header}" "${source}")
    string(APPEND includes "#include \"${name}_text.h\"\n")
    string(APPEND entries "  { \"${name}\", ${name}_text },\n")
  endforeach ()
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/PythonTexts.h" CONTENT
    "${includes}\nconstexpr struct\n{\n  const char* Name;\n  const unsigned char* Text;\n} PythonTexts[] = {\n${entries}};\n")
  set("${variable}" "${sources}" PARENT_SCOPE)
endfunction ()
