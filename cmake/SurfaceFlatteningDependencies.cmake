# The libraries that Filters/Core is built on. Included where their targets are needed, because imported
# targets are seen only in the folder that finds them and below.
find_package(Eigen3 REQUIRED NO_MODULE) # 3.3 or newer; Eigen 5 denies that it is
if (Eigen3_VERSION VERSION_LESS 3.3)
  message(FATAL_ERROR "Eigen ${Eigen3_VERSION} is too old: 3.3 or newer is needed (Debian: apt install libeigen3-dev)")
endif ()
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.0 REQUIRED)
find_package(TBB REQUIRED CONFIG)
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
find_package(CHOLMOD REQUIRED)
find_package(OpenMP COMPONENTS CXX)
find_package(UMFPACK REQUIRED)
