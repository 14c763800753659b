#!/usr/bin/env bash
# Installs what Vicus needs and this machine lacks: Debian packages by apt, browser modules by npm. Run it as often as
# you like: where all is there it changes nothing.
# usage: ./setup.sh [build|all]      build: to build and serve (./demo); all (default): to test too (./test)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

build_packages=(
  g++ cmake ninja-build ccache git ca-certificates  # to build
  libcgal-dev libgmp-dev libmpfr-dev                # triangulations
  libgeos-dev                                       # overlay of footprints
  libgdal-dev                                       # GeoPackage, Shapefile, FlatGeobuf, coordinate systems
  libosmium2-dev libprotozero-dev zlib1g-dev libbz2-dev libexpat1-dev  # OpenStreetMap files
  libgeographiclib-dev                              # the plan frame
  libsqlite3-dev                                    # the city file
  libboost-dev                                      # HTTP (Beast, Asio: headers only)
  libbrotli-dev libdeflate-dev libssl-dev           # codings and hashes of what is sent
  libimagequant-dev libpng-dev                      # palettes of textures, reading them again
  libopenimageio-dev                                # photos of facades
  libwebp-dev                                       # pictures of BlockMaps
  libdraco-dev libmeshoptimizer-dev libtinygltf-dev libstb-dev  # glTF
  libembree-dev                                     # pictures: rays
  libspdlog-dev libcli11-dev nlohmann-json3-dev
  esbuild                                           # the page's programs in one file
  nodejs npm                                        # fetches X_ITE
)
test_packages=(
  libgtest-dev
  clang-format
  libxml2-utils gdal-bin sqlite3 view3dscene        # other people's readers of our files
  chromium fonts-dejavu-core                        # the browser of tests/browser
)

say() { printf 'setup: %s\n' "$*"; }

usage() {
  printf 'usage: ./setup.sh [build|all]\n' >&2
  exit 2
}

missing_packages() {
  local package state
  for package in "$@"; do
    # npm comes inside nodejs where that is not Debian's own.
    if [[ $package == npm ]] && command -v npm >/dev/null; then continue; fi
    if [[ $package == chromium && -n ${CHROMIUM:-} ]]; then continue; fi
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $state == installed ]] || printf '%s\n' "$package"
  done
}

install_packages() {
  local missing=() as_root=()
  mapfile -t missing < <(missing_packages "$@")
  if ((${#missing[@]} == 0)); then
    say "all $# Debian packages are there"
    return
  fi
  if ! command -v apt-get >/dev/null; then
    say "no apt-get here: install what these packages of Debian 12 hold, then run this again: ${missing[*]}" >&2
    exit 1
  fi
  if ((EUID != 0)); then
    command -v sudo >/dev/null || { say "needs root: apt-get install ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
  fi
  say "installing by apt: ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update </dev/null
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 install --yes \
    --no-install-recommends "${missing[@]}" </dev/null >/dev/null
}

install_modules() {
  local stamp=node_modules/.vicus_lock
  if [[ -f $stamp ]] && cmp -s package-lock.json "$stamp"; then
    say "the npm modules of package-lock.json are there"
    return
  fi
  say "installing by npm: the modules of package-lock.json"
  npm ci --no-audit --no-fund --loglevel=error </dev/null
  cp package-lock.json "$stamp"
}

(($# <= 1)) || usage
case ${1:-all} in
  build) install_packages "${build_packages[@]}" ;;
  all) install_packages "${build_packages[@]}" "${test_packages[@]}" ;;
  *) usage ;;
esac
install_modules
