#!/usr/bin/env bash
# Installs what is missing to build, test and demonstrate SurfaceFlattening on Debian 12 (bookworm), 13 (trixie) and unstable
# (sid), and on what derives from them. Safe to run again; needs root or sudo only if something is missing.
#   Utilities/setup.sh           for the ParaView plugin
#   Utilities/setup.sh --vtk     for the VTK module alone, on a VTK without ParaView
#   Utilities/setup.sh --package for the ParaView plugin and to make a Debian package of it
set -euo pipefail

release=$(. /etc/os-release && echo "${VERSION_CODENAME:-sid}")

packages=(
  cmake ninja-build g++
  libcgal-dev libeigen3-dev libsuitesparse-dev libtbb-dev
  libopenblas0-serial # factorizations take a third of the time that they take with the reference BLAS
  libgtest-dev libbenchmark-dev
  python3 python3-dev
  libopenmpi-dev openmpi-bin libutfcpp-dev libdouble-conversion-dev libfreetype-dev libgl-dev libglew-dev
  xvfb xauth libgl1-mesa-dri iproute2
  mricron-data # the scan of the demo, of the pages and of their tests
  python3-nibabel python3-pydicom python3-gdcm # files of FreeSurfer, GIFTI and DICOM, when they are opened
)
if [ "${1:-}" = --vtk ]; then
  # python3-vtk9 and python3-paraview exclude each other on Debian 12 and 13.
  packages+=(libvtk9-dev python3-vtk9)
  [ "$release" = bookworm ] || packages+=(python3-pyvista) # for its tests
else
  packages+=(paraview paraview-dev python3-paraview)
  # Qt puts the icons and the part in ParaView's window into the plugin, which goes without them otherwise. The other
  # packages make the plugin's pages in ParaView's help. Without libqt5svg5 or qt6-svg-plugins ParaView shows no icons.
  case $release in
    bookworm) # ParaView 5.11, with Qt 5
      packages+=(qtbase5-dev qttools5-dev qtxmlpatterns5-dev-tools libqt5svg5 python3-markdown python3-pil)
      ;;
    trixie) # ParaView 5.13, which cannot make help with Qt 6
      packages+=(qt6-base-dev qt6-tools-dev qt6-tools-dev-tools qt6-svg-plugins)
      ;;
    *) # ParaView 6.1 on the system's VTK
      packages+=(libvtk9-dev python3-vtk9)
      packages+=(qt6-base-dev qt6-tools-dev qt6-tools-dev-tools qt6-svg-plugins xsltproc python3-markdown python3-pil)
      ;;
  esac
fi

if [ "${1:-}" = --package ]; then
  packages+=(dpkg-dev file) # find out what the package's libraries need
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "setup.sh: missing packages: ${missing[*]}; run it as root, or install sudo" >&2
    exit 1
  }
  as_root=(sudo)
fi
echo "Installing ${#missing[@]} packages: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@" >"$log" 2>&1 || {
    tail -n 20 "$log" >&2
    echo "setup.sh: apt-get $1 failed" >&2
    exit 1
  }
}
apt update
apt install --no-install-recommends "${missing[@]}"
echo "Installed."
