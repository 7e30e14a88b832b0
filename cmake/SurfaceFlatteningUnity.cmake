# Compiling the files of a folder, or of several, as one takes a third of the processor time that compiling each alone takes,
# because nearly all of that time goes into the headers of CGAL, Eigen and VTK.
option(SURFACEFLATTENING_UNITY_BUILD
  "Compile the files of a folder as one; OFF compiles each alone, which is faster after a change of one file" ON)

# surfaceflattening_unity(<target> <group> <source> ...): these sources of the target are compiled as one. Two of them
# may not define the same name in an anonymous namespace.
function (surfaceflattening_unity target group)
  if (SURFACEFLATTENING_UNITY_BUILD)
    set_target_properties("${target}" PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP "${group}")
  endif ()
endfunction ()
