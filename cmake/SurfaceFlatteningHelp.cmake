# Pages for ParaView's help: surfaceflattening_help(<variable> <server-manager XML>...) sets the variable to the
# arguments of paraview_add_plugin that put them into the plugin. Without the tools that ParaView's help takes
# (Debian 12: qttools5-dev, qtxmlpatterns5-dev-tools, newer: qt6-tools-dev, qt6-tools-dev-tools, xsltproc; and
# python3-markdown, python3-pil) the plugin has no help, and says so here.
function (surfaceflattening_help variable)
  set("${variable}" XML_DOCUMENTATION OFF PARENT_SCOPE)
  if (NOT PARAVIEW_USE_QT)
    return ()
  endif ()
  if (surfaceflattening_qt STREQUAL "Qt6" AND ParaView_VERSION VERSION_LESS 6.0)
    message(STATUS "ParaView ${ParaView_VERSION} makes no help for plugins with Qt 6: the pages are in docs/README.md")
    return ()
  endif ()
  set(missing)
  if (surfaceflattening_qt STREQUAL "Qt5")
    find_package(Qt5 QUIET COMPONENTS Help)
    if (NOT Qt5Help_FOUND)
      list(APPEND missing qttools5-dev)
    endif ()
    find_program(qt_xmlpatterns_executable NAMES xmlpatterns-qt5 xmlpatterns
      HINTS "${Qt5_DIR}/../../../qt5/bin")
    mark_as_advanced(qt_xmlpatterns_executable)
    execute_process(COMMAND "${qt_xmlpatterns_executable}" -version
      RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET) # Debian's qtchooser has a link to what is not installed
    if (NOT status EQUAL 0)
      list(APPEND missing qtxmlpatterns5-dev-tools)
    endif ()
  else ()
    find_package(Qt6 QUIET COMPONENTS Help Tools)
    if (NOT Qt6Help_FOUND OR NOT TARGET Qt6::qhelpgenerator)
      list(APPEND missing qt6-tools-dev qt6-tools-dev-tools)
    endif ()
    find_program(ParaViewClient_xsltproc_executable NAMES xsltproc)
    mark_as_advanced(ParaViewClient_xsltproc_executable)
    if (NOT ParaViewClient_xsltproc_executable)
      list(APPEND missing xsltproc)
    endif ()
  endif ()
  find_package(Python3 QUIET COMPONENTS Interpreter)
  execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import markdown"
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if (NOT status EQUAL 0)
    list(APPEND missing python3-markdown)
  endif ()
  execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import PIL"
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if (NOT status EQUAL 0)
    list(APPEND missing python3-pil)
  endif ()
  if (missing)
    list(JOIN missing ", " missing)
    message(STATUS "The plugin has no pages in ParaView's help, for lack of ${missing}")
    return ()
  endif ()

  set(repository "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..")
  set(pages "${CMAKE_CURRENT_BINARY_DIR}/help_pages")
  set(script "${repository}/Plugin/Help/help_pages.py")
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE xmls)
  file(GLOB_RECURSE docs CONFIGURE_DEPENDS "${repository}/docs/*.md" "${repository}/docs/*.png")
  add_custom_command(
    OUTPUT "${pages}/index.html"
    COMMAND "${Python3_EXECUTABLE}" -B "${script}" "${pages}" "${repository}" ${xmls}
    DEPENDS "${script}" "${repository}/Utilities/docs/reference.py" "${repository}/README.md" ${xmls} ${docs}
    COMMENT "Writing the pages of ParaView's help"
    VERBATIM)
  set("${variable}"
    XML_DOCUMENTATION ON
    DOCUMENTATION_DIR "${pages}"
    DOCUMENTATION_DEPENDENCIES "${pages}/index.html"
    PARENT_SCOPE)
endfunction ()
