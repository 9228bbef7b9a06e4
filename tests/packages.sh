# Sourced by demo.sh and test.sh. The one list of the Debian packages that truequad is built, shown and tested with.
#
#   install_packages GROUP…    installs what the groups name and the machine lacks; quick when nothing is missing
#
# Run as a program (bash tests/packages.sh GROUP…) it prints the names only.

declare -A truequad_packages=(
  # The library and the command.
  [build]="cmake ninja-build g++ libglm-dev libpugixml-dev khronos-api libcli11-dev libgl-dev libegl-dev libosmesa6-dev
    libglvnd-core-dev"
  # The sample programs and the sheets of pictures.
  [samples]="libosmesa6-dev freeglut3-dev libgl-dev libcli11-dev libglm-dev libstb-dev nlohmann-json3-dev
    imagemagick fonts-dejavu-core"
  [tests]="libgtest-dev libgmock-dev libbenchmark-dev libgmp-dev libboost-dev nlohmann-json3-dev libstb-dev libepoxy-dev
    libosmesa6-dev libegl-dev libgl-dev libx11-dev libgl1-mesa-dri libegl-mesa0 libglx-mesa0 xvfb python3 make pkg-config
    freeglut3-dev libglew-dev libglfw3-dev libsdl2-dev apitrace-tracers
    libglu1-mesa-dev libftgl-dev fonts-dejavu-core"
  # Real programs that draw quads, and the X server without a screen that they run on.
  [programs]="xvfb xauth libgl1-mesa-dri libegl-mesa0 libglx-mesa0 libstb-dev libegl-dev libgl-dev libx11-dev
    xscreensaver-gl xscreensaver-gl-extra rss-glx puredata-core gem gltron libopencsg-example openuniverse
    dosbox imagemagick piglit"
)

packages_of() {
  local group
  for group in "$@"; do
    [ -n "${truequad_packages[$group]:-}" ] || { echo "packages: there is no group '$group'" >&2; return 2; }
    # Unquoted on purpose: the words of the list.
    printf '%s\n' ${truequad_packages[$group]}
  done | sort -u
}

# Those of the named packages that are not installed. A name that another package provides counts as missing to dpkg,
# and apt-get then finds that there is nothing to do.
missing_packages() {
  comm -23 <(printf '%s\n' "$@" | sort -u) <(
    dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' | sort -u
  )
}

install_packages() {
  local names missing as_root=()
  names=$(packages_of "$@") || return
  command -v dpkg-query >/dev/null || { echo "packages: this is not Debian; please install: ${names//$'\n'/ }" >&2; return 1; }
  missing=$(missing_packages $names)
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || { echo "packages: not root and no sudo; please install: ${missing//$'\n'/ }" >&2; return 1; }
    as_root=(sudo)
  fi
  echo "packages: installing ${missing//$'\n'/ }" >&2
  local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends)
  # A machine whose package lists are missing or old needs them first.
  if ! "${install[@]}" $missing >&2; then
    "${as_root[@]}" apt-get update -q >&2 || { echo "packages: apt-get update failed" >&2; return 1; }
    "${install[@]}" $missing >&2 || { echo "packages: could not install ${missing//$'\n'/ }" >&2; return 1; }
  fi
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
  [ $# -gt 0 ] || set -- "${!truequad_packages[@]}"
  packages_of "$@"
fi
