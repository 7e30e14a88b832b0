# The libraries of ParaView's window, for Plugin/Client. Asked for them as components, an installed ParaView demands
# the development files of some dozens of libraries that they use, none of which the plugin includes. So the plugin
# links to these libraries alone and not to what they link to.
set(client_libraries
  ParaView::pqApplicationComponents
  ParaView::pqComponents
  ParaView::pqCore
  ParaView::pqPython
  ParaView::RemotingViews
  VTK::PythonInterpreter)

# surfaceflattening_find_client(<variable>)
# Whether the plugin can have its part in the window.
function (surfaceflattening_find_client found)
  set("${found}" OFF PARENT_SCOPE)
  if (NOT PARAVIEW_USE_QT)
    return ()
  endif ()
  if (NOT TARGET "${surfaceflattening_qt}::Widgets")
    message(STATUS "No development files of ${surfaceflattening_qt} (Debian: qtbase5-dev or qt6-base-dev): the plugin "
      "goes without icons and without its part in ParaView's window.")
    return ()
  endif ()
  foreach (target IN LISTS client_libraries)
    if (NOT TARGET "${target}")
      message(STATUS "No ${target}: the plugin goes without its part in ParaView's window.")
      return ()
    endif ()
  endforeach ()
  foreach (target IN LISTS client_libraries)
    get_target_property(imported "${target}" IMPORTED)
    if (imported)
      set_target_properties("${target}" PROPERTIES INTERFACE_LINK_LIBRARIES "")
      get_target_property(configurations "${target}" IMPORTED_CONFIGURATIONS)
      foreach (configuration IN LISTS configurations)
        set_target_properties("${target}" PROPERTIES
          "IMPORTED_LINK_DEPENDENT_LIBRARIES_${configuration}" "")
      endforeach ()
    endif ()
  endforeach ()
  set("${found}" ON PARENT_SCOPE)
endfunction ()
