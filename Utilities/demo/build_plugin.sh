# For scripts to source from the repository's folder. build_plugin takes the arguments of build.sh, builds, and sets
# build, the build folder, and plugin, the plugin's file.
build_plugin() {
  Utilities/build.sh "$@"
  build=$(realpath "${BUILD_DIRECTORY:-build}")
  plugin=$(find "$build/lib" -name SurfaceFlattening.so -print -quit)
}
