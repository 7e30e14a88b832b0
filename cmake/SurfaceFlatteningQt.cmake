# Sets surfaceflattening_qt to the Qt that ParaView's window is made with. To look for the other one would keep CMake from
# finding this one. ParaView 5.11 has Qt 5 and no variable that says so.
set(surfaceflattening_qt Qt5)
if (PARAVIEW_QT_MAJOR_VERSION)
  set(surfaceflattening_qt "Qt${PARAVIEW_QT_MAJOR_VERSION}")
endif ()
